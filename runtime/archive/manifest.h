// SPDX-License-Identifier: MIT
// manifest.json: pictures, inputs, program and device of a capture, and the hashes of all results. docs/captures.md
// describes each field. A manifest contains no time, date or path of a machine.
#pragma once

#include "archive/capture_file.h"
#include "archive/inputs.h"

namespace strobe::archive {

inline constexpr const char* kManifestFormat = "strobe.manifest";
inline constexpr int kManifestVersion = 1;
inline constexpr const char* kManifestFile = "manifest.json";
inline constexpr const char* kSumsFile = "SHA256SUMS";

// Program: version, hash of its file, and libraries. With git, also the revision of the sources and whether they were
// changed since.
Json programJson(const Home& home);
// Device: name, driver, API. If the name states them, also the version of LLVM and the width of vectors.
Json deviceJson(const gpu::DeviceInfo& device);

// Parsed manifest.json of a capture, with the folder that contains it.
struct Manifest {
  Path folder;  // folder of the manifest
  Json json;
};

// Reads a manifest from a file or from its folder. Throws `Error` (place: the file) if the file is missing, is not a
// manifest, is cut short, or has a newer format.
Manifest readManifest(const Path& file_or_folder);

// { sha256, bytes } of a file.
Json fileEntry(const Path& file);

// Lines for `sha256sum -c`, for files of a folder.
std::string sumsOf(const Path& folder, const std::set<std::string>& names);

// Images of a picture in one file, without loss: by output, or "node.port".
using Images = std::map<std::string, graph::ReadImage>;

// { format, size, hash } of each image, by name.
Json layersJson(const Images& images);

// Writes a part for each image, with the picture's attributes. `record` is stored in the file.
void writeLayers(const Path& file, const lab::Picture& picture, const Json& record, const Images& images);

// Reads a file written by `writeLayers`. Throws `Error` naming the file if the images differ from `layers` (see
// `layersJson`).
Images readLayers(const Path& file, const Json& layers);

}  // namespace strobe::archive
