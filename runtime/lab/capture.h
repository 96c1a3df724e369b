// SPDX-License-Identifier: MIT
// A picture as files: multi-layer EXR or PNG, the run record beside it, timings in a file of their own.
#pragma once

#include "image/exr.h"
#include "image/tone.h"
#include "lab/workbench.h"

namespace strobe::lab {

// Colour of a picture, three channels, linear.
image::Image colorOf(const Picture& picture);

// Names of an image's channels: R G B A, X Y, Z of a depth, id and its companions.
std::vector<std::string> componentNames(const std::string& output, int channels);

// Every output and tap as layers: colour R G B A, depth Z, velocity.X/Y, normal N.X/Y/Z, id; others by their names.
image::ExrFile exrOf(const Picture& picture, bool half);

// Writes `file` (.exr or .png by its name; PNG: linear colour times 2^0, clamped, sRGB-encoded), "<stem>.record.json"
// and "<stem>.timings.json" beside it. Throws `Error` (exit code 2) for another ending. Returns the files written.
std::vector<Path> writePicture(const Picture& picture, const Path& file, bool half);

// Refuses a name that `writePicture` would refuse, before anything is rendered.
void checkPictureName(const Path& file);

}  // namespace strobe::lab
