// SPDX-License-Identifier: MIT
// Takes a capture again and compares it with its manifest.
#pragma once

#include "archive/differences.h"

namespace strobe::archive {

// Takes every picture again, in a temporary folder. The files are from `home`, or from the bundle if the manifest
// belongs to a bundle. `pictures`: a folder for maps of first differences, or empty. Throws `Error` if the capture's
// script is missing, if a file of a bundle is missing or was altered (naming the file), and if drawing fails. Returns
// the differences, with the fields `holds` (identical; on another device, within `most_flip`), `same_device` and
// `most_flip` (largest mean FLIP on another device).
Json verify(const Home& home, const Manifest& manifest, const std::string& device, bool validation,
            const Path& pictures, const std::function<void(const std::string&)>& report = {});

// Last line of the text of a verification: its verdict.
std::string verdictOf(const Json& verification);

}  // namespace strobe::archive
