// SPDX-License-Identifier: MIT
// The images of a picture in its file, and back without loss.
#pragma once

#include "lab/workbench.h"

namespace strobe::archive {

using Images = std::map<std::string, graph::ReadImage>;  // by output, or "node.port"

// { format, size, hash } of each image, by name.
Json layersJson(const Images& images);

// Writes the images with the picture's attributes, a part each; `record` is what the file says of itself.
void writeLayers(const Path& file, const lab::Picture& picture, const Json& record, const Images& images);

// What `writeLayers` wrote. Throws `Error` naming the file where it is not as `layers` says (what `layersJson` gave).
Images readLayers(const Path& file, const Json& layers);

}  // namespace strobe::archive
