// SPDX-License-Identifier: MIT
// Images of a picture in one file, without loss.
#pragma once

#include "lab/workbench.h"

namespace strobe::archive {

using Images = std::map<std::string, graph::ReadImage>;  // by output, or "node.port"

// { format, size, hash } of each image, by name.
Json layersJson(const Images& images);

// Writes a part for each image, with the picture's attributes. `record` is stored in the file.
void writeLayers(const Path& file, const lab::Picture& picture, const Json& record, const Images& images);

// Reads a file written by `writeLayers`. Throws `Error` naming the file if the images differ from `layers` (see
// `layersJson`).
Images readLayers(const Path& file, const Json& layers);

}  // namespace strobe::archive
