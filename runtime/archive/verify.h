// SPDX-License-Identifier: MIT
// A capture taken again and compared with its manifest.
#pragma once

#include "archive/differences.h"

namespace strobe::archive {

struct Verdict {
  Differences differences;
  bool same_device = true;
  double most_flip = 0;  // mean FLIP that is allowed on another device
  bool holds = false;    // identical; on another device, within that
};

// Takes every picture again in a folder of its own, which is removed, from the files of `home`, or of the bundle itself
// where the manifest is one's. `pictures`: a folder for pictures of first differences, or empty. Throws `Error`: the
// capture's script is not there, a file of a bundle is missing or was altered (named), and what drawing throws.
Verdict verify(const Home& home, const Manifest& manifest, const std::string& device, bool validation,
               const Path& pictures, const std::function<void(const std::string&)>& report = {});

std::string textOf(const Verdict& verdict);

}  // namespace strobe::archive
