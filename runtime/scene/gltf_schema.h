// SPDX-License-Identifier: MIT
// The form of a glTF 2.0 asset and of the extensions that are read.
#pragma once

#include "scene/gltf_file.h"

namespace strobe::scene {

// Names of the extensions that are read.
const std::vector<std::string>& supportedExtensions();

// True if the file declares the extension as used or required.
bool declares(const GltfFile& file, const std::string& extension);

// Compares every object of the file, used or not, with its form in the standard: required members, their types,
// ranges and references. Throws `Error` with the place of the first one that differs, and of an extension
// that is used and not declared, or that stands where it has no meaning. Members without a form are not looked at.
void requireForm(const GltfFile& file);

}  // namespace strobe::scene
