// SPDX-License-Identifier: MIT
// Form of a glTF 2.0 asset and of the supported extensions.
#pragma once

#include "scene/gltf_file.h"

namespace strobe::scene {

// Names of the supported extensions.
const std::vector<std::string>& supportedExtensions();

// True if the file declares the extension as used or required.
bool declares(const GltfFile& file, const std::string& extension);

// Compares every object of the file, used or not, with its form in the standard: required members, their types, ranges
// and references. Throws `Error` with the place of the first difference. Also refuses an extension that is used but not
// declared, or that is in a place without a meaning. Members without a form are ignored.
void requireForm(const GltfFile& file);

}  // namespace strobe::scene
