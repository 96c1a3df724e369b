// SPDX-License-Identifier: MIT
// JSON files that show damage: the hash of all other fields is the field "sum".
#pragma once

#include <optional>
#include <string>

#include "base/json_fwd.h"

namespace strobe {

// Text of a file of `object` and its sum.
std::string sealed(Json object);

// The object without its sum; nothing if the text is not an object in JSON or differs from its sum.
std::optional<Json> unsealed(const std::string& text);

}  // namespace strobe
