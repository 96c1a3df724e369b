// SPDX-License-Identifier: MIT
// Picture files: OpenEXR (docs/exr.md) or PNG, with the run record and the timings in separate files beside it.
#pragma once

#include "image/exr.h"
#include "image/tone.h"
#include "lab/workbench.h"

namespace strobe::lab {

// Colour of a picture: three channels, linear.
image::Image colorOf(const Picture& picture);

// Channel names of an output: R G B A; X Y; Z for depth; id, geometry, primitive, unused for ids.
std::vector<std::string> componentNames(const std::string& output, int channels);

// Options of an OpenEXR file: float precision, one or several parts, Cryptomatte layers, and the outputs to store
// beside the colour.
struct ExrOptions {
  bool half = false;                // 16-bit floats; ids and mattes stay 32-bit
  bool multipart = false;           // one part per output and tap, with its own name and size
  bool cryptomatte = false;         // mattes by node and by material, and the coverage of each pixel
  std::vector<std::string> layers;  // outputs and taps beside the color; empty: all
};

// Outputs and taps as layers: colour R G B A, depth Z, velocity.X/Y, normal N.X/Y/Z, id; others by name. Without
// `multipart`, images that differ in size from the color are left out with a warning. Mattes need `id_coverage` if the
// picture has several sub-pixel samples. Throws `Error` for an unknown layer, and for mattes without ids.
image::ExrFile exrOf(const Picture& picture, const ExrOptions& options = {});

// Images of a multi-part file of `exrOf` by output or tap name, bit-exact. The file was written without `half`; mattes
// are left out. Throws `Error` (place: `file`) for another file.
std::map<std::string, graph::ReadImage> imagesOf(const image::ExrFile& content, const Path& file);

// Writes `file` and, beside it, "<stem>.record.json" and "<stem>.timings.json". The extension selects the format, .exr
// or .png. PNG: linear colour without scaling, clamped, sRGB-encoded. Throws `Error` (exit code 2) for another
// extension. Returns the files written.
std::vector<Path> writePicture(const Picture& picture, const Path& file, const ExrOptions& options = {});

// Throws `Error` (exit code 2) if `writePicture` would refuse the name. Call before rendering.
void checkPictureName(const Path& file);

}  // namespace strobe::lab
