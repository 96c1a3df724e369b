// SPDX-License-Identifier: MIT
// Films of a capture: a figure for each step of a sequence, piped to ffmpeg.
#pragma once

#include "figure/figure.h"

namespace strobe::figure {

// Draws a film at the steps 0 to steps - 1. Writes FOLDER/NAME.mp4 (H.264, supported by every player) or
// FOLDER/NAME.mkv (FFV1, lossless) and returns the file. `data`: from scripts/strobe/figure.lua, with the capture's
// `size`. Equal frames give equal bytes: one thread, no date, no program name. Throws `Error` if ffmpeg is missing
// (with the name of its package) or fails, and as writeFigure.
std::vector<Path> writeFilm(const Json& data, const FindTaken& find, int steps, const Path& folder,
                            const std::string& truth_arm = "");

}  // namespace strobe::figure
