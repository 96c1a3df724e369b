// SPDX-License-Identifier: MIT
// ro-crate-metadata.json: description of a capture for other programs, as an RO-Crate 1.1 after the profile Process Run
// Crate 0.5 (https://w3id.org/ro/wfrun/process/0.5). Derived from the manifest.
#pragma once

#include "archive/manifest.h"

namespace strobe::archive {

inline constexpr const char* kCrateFile = "ro-crate-metadata.json";

// Date of publication, which a crate must state: "2020-07-19", UTC. Two runs state the same date. Source: the
// environment variable SOURCE_DATE_EPOCH (seconds since 1970), else the revision of the sources in git, else
// 1970-01-01. Throws `Error` if SOURCE_DATE_EPOCH is not such a number.
std::string crateDate(const Home& home);

// `manifest`: as in its folder. `names`: the other files of the folder. An input that is not in `names` was not copied,
// and is described without a place. Throws `Error` if manifest.json cannot be read.
Json crateOf(const Manifest& manifest, const std::set<std::string>& names, const std::string& date);

}  // namespace strobe::archive
