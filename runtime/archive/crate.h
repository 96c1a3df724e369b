// SPDX-License-Identifier: MIT
// ro-crate-metadata.json: what a capture is for programs that know nothing of Strobe, as an RO-Crate 1.1 after the
// profile Process Run Crate 0.5 (https://w3id.org/ro/wfrun/process/0.5). All of it is derived from the manifest.
#pragma once

#include "archive/manifest.h"

namespace strobe::archive {

inline constexpr const char* kCrateFile = "ro-crate-metadata.json";

// The day of publication that a crate must state, "2020-07-19" in UTC, which two runs state alike: that of the
// environment's SOURCE_DATE_EPOCH (seconds since 1970), else of the revision of the sources, where git knows, else
// 1970-01-01. Throws `Error` for a SOURCE_DATE_EPOCH that is no such number.
std::string crateDate(const Home& home);

// `manifest`: as it lies in its folder. `names`: the files of that folder besides; an input that is not among them was
// not copied, and is described without a place. Throws `Error` where manifest.json cannot be read.
Json crateOf(const Manifest& manifest, const std::set<std::string>& names, const std::string& date);

}  // namespace strobe::archive
