// SPDX-License-Identifier: MIT
// A picture as files: OpenEXR (docs/exr.md) or PNG, the run record beside it, timings in a file of their own.
#pragma once

#include "image/exr.h"
#include "image/tone.h"
#include "lab/workbench.h"

namespace strobe::lab {

// Colour of a picture, three channels, linear.
image::Image colorOf(const Picture& picture);

// Names of an image's channels: R G B A, X Y, Z of a depth, id and its companions.
std::vector<std::string> componentNames(const std::string& output, int channels);

struct ExrOptions {
  bool half = false;                // 16-bit floats; ids and mattes stay as they are
  bool multipart = false;           // each output and tap a part of its own name and size
  bool cryptomatte = false;         // mattes by node and by material, and how much of a pixel anything covers
  std::vector<std::string> layers;  // outputs and taps beside the color; empty: all there are
};

// Outputs and taps as layers: colour R G B A, depth Z, velocity.X/Y, normal N.X/Y/Z, id; others by their names. Without
// `multipart` images of another size than the color are left out, with a warning each. Mattes need `id_coverage` where
// the picture has several sub-pixel samples. Throws `Error` for a layer there is not, and for mattes without ids.
image::ExrFile exrOf(const Picture& picture, const ExrOptions& options = {});

// The images in a multi-part file of `exrOf` (without `half`; mattes are left out) by the name of the output or tap,
// bit for bit. Throws `Error` (place: `file`) for another file.
std::map<std::string, graph::ReadImage> imagesOf(const image::ExrFile& content, const Path& file);

// Writes `file` (.exr or .png by its name; PNG: linear colour times 2^0, clamped, sRGB-encoded), "<stem>.record.json"
// and "<stem>.timings.json" beside it. Throws `Error` (exit code 2) for another ending. Returns the files written.
std::vector<Path> writePicture(const Picture& picture, const Path& file, const ExrOptions& options = {});

// Refuses a name that `writePicture` would refuse, before anything is rendered.
void checkPictureName(const Path& file);

}  // namespace strobe::lab
