// SPDX-License-Identifier: MIT
// manifest.json: what a capture took, of what, by what, and the hash of all that came of it. docs/captures.md has it
// field by field. No time, date or path of a machine is in it.
#pragma once

#include "archive/capture_file.h"
#include "archive/inputs.h"

namespace strobe::archive {

inline constexpr const char* kManifestFormat = "strobe.manifest";
inline constexpr int kManifestVersion = 1;
inline constexpr const char* kManifestFile = "manifest.json";
inline constexpr const char* kSumsFile = "SHA256SUMS";

// The program: version, the hash of its file, the revision of its sources and whether they were changed since, where
// git knows, and the libraries it was built with.
Json programJson(const Home& home);
// When that revision was made, in seconds since 1970, where git knows. It is no part of a manifest.
std::optional<int64_t> revisionTime(const Home& home);
// The device: name, driver, interface, what its name says of LLVM and the width of vectors.
Json deviceJson(const gpu::DeviceInfo& device);

struct Manifest {
  Path folder;  // that it lies in
  Json json;
};

// Of a file, or of the one in a folder. Throws `Error` (place: the file) where there is none, where it is none, is cut
// short, or of a newer format.
Manifest readManifest(const Path& file_or_folder);

// { sha256, bytes } of a file.
Json fileEntry(const Path& file);

// Lines that `sha256sum -c` takes, of files of a folder.
std::string sumsOf(const Path& folder, const std::set<std::string>& names);

}  // namespace strobe::archive
