// SPDX-License-Identifier: MIT
// Comparison with Khronos' glTF validator: a file with an error is refused and its place named; other files load.
// Exceptions are listed here and in docs/gltf.md. Values outside an enumeration (filters, modes, types) are only
// warnings of the validator, but count as errors here.
#pragma once

#include <functional>
#include <regex>

#include "scene/gltf_asset.h"

namespace strobe::scene {

// True if node and the validator are installed; `./strobe test` installs the validator in STROBE_NODE_MODULES.
bool hasValidator();

// The error of a file that does not load; "" if it loads.
std::string refusalOf(const Path& file);

using Exceptions = std::vector<std::pair<std::regex, std::string>>;

// Validator errors that do not prevent loading, by code and JSON pointer, and their place in docs/gltf.md.
const Exceptions& accepted();

// Refusals of files without validator errors, and their place in docs/gltf.md.
const Exceptions& refusedAllTheSame();

struct Tally {
  size_t refused = 0, loaded = 0, listed = 0;
};

// Expects that a file with errors is refused in one line or listed, and that a file without errors loads or its refusal
// is listed.
Tally expectAgreement(const std::vector<Path>& files, const std::function<std::string(size_t)>& describe);

// A file with all features: a textured and lit triangle, an index list, two cameras, clips, a deformed mesh.
Asset everything();

}  // namespace strobe::scene
