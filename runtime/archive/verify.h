// SPDX-License-Identifier: MIT
// Takes a capture again and compares it with its manifest.
#pragma once

#include "archive/differences.h"

namespace strobe::archive {

// Result of a repeated capture: its differences from the manifest, and true if they are within the tolerance.
struct Verification {
  Differences differences;
  bool same_device = true;
  double most_flip = 0;  // largest mean FLIP on another device
  bool holds = false;    // identical; on another device, within most_flip
};

// Takes every picture again, in a temporary folder. The files are from `home`, or from the bundle if the manifest
// belongs to a bundle. `pictures`: a folder for maps of first differences, or empty. Throws `Error` if the capture's
// script is missing, if a file of a bundle is missing or was altered (naming the file), and if drawing fails.
Verification verify(const Home& home, const Manifest& manifest, const std::string& device, bool validation,
                    const Path& pictures, const std::function<void(const std::string&)>& report = {});

std::string textOf(const Verification& verdict);

}  // namespace strobe::archive
