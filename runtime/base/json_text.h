// SPDX-License-Identifier: MIT
// JSON from text, for what is large: the library's own way copies the fields of an object whenever that grows.
#pragma once

#include <string>

#include "base/json.h"

namespace strobe {

// `is_discarded()` where the text is no JSON. An object that has a key twice keeps both; the first is found.
Json jsonFromText(const std::string& text);

}  // namespace strobe
