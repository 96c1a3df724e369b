// SPDX-License-Identifier: MIT
// The glTF validator of Khronos as an oracle: what it calls an error is refused with its place, what it accepts loads;
// exceptions are listed here and in docs/gltf.md. It only warns of values that are none of a list (filters, modes,
// types), which are refused here: they count as errors.
#pragma once

#include <functional>
#include <regex>

#include "scene/gltf_asset.h"

namespace strobe::scene {

// True if there are node and the validator, in STROBE_NODE_MODULES, where `./strobe test` puts it.
bool hasValidator();

// The message of a file that does not load, else "".
std::string refusalOf(const Path& file);

using Exceptions = std::vector<std::pair<std::regex, std::string>>;

// Errors of the validator with which a file may load, by code and JSON pointer, and where docs/gltf.md lists them.
const Exceptions& accepted();

// Refusals of files that the validator accepts, and where docs/gltf.md lists them.
const Exceptions& refusedAllTheSame();

struct Tally {
  size_t refused = 0, loaded = 0, listed = 0;
};

// Each error is refused in one line, or listed; a file without errors loads, or its refusal is listed.
Tally expectAgreement(const std::vector<Path>& files, const std::function<std::string(size_t)>& describe);

// A file with something of everything: a textured and lit triangle, an index list, two cameras, clips, what bends.
Asset everything();

}  // namespace strobe::scene
