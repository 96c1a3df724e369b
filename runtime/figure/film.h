// SPDX-License-Identifier: MIT
// Films of a capture: a figure for each step of a sequence, piped to ffmpeg.
#pragma once

#include "figure/figure.h"

namespace strobe::figure {

// Draws figure `data` (as scripts/strobe/figure.lua leaves a film, with the capture's `size`) at steps 0 to steps - 1
// and writes FOLDER/NAME.mp4 (H.264, what every player knows) or FOLDER/NAME.mkv (FFV1, every value as it is). The same
// frames give the same bytes: one thread, no date, no name of a program. Returns the file. Throws `Error` where there
// is no ffmpeg, saying which package has it, where it fails, and as writeFigure does.
std::vector<Path> writeFilm(const Json& data, const FindTaken& find, int steps, const Path& folder,
                            const std::string& truth_arm = "");

}  // namespace strobe::figure
