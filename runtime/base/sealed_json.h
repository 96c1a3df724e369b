// SPDX-License-Identifier: MIT
// JSON files with a checksum: the field "sum" is the hash of all other fields.
#pragma once

#include <optional>
#include <string>

#include "base/json_fwd.h"

namespace strobe {

// File text of `object` with its sum.
std::string sealed(Json object);

// The object without its sum; nothing if the text is not an object in JSON or differs from its sum.
std::optional<Json> unsealed(const std::string& text);

}  // namespace strobe
