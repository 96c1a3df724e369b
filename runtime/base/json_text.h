// SPDX-License-Identifier: MIT
// JSON from text and to text. The reader is for large texts: the library's own reader copies the fields of an object
// whenever it grows.
#pragma once

#include <string>

#include "base/json_fwd.h"

namespace strobe {

// `is_discarded()` if the text is not JSON. An object with a duplicate key keeps both values; a lookup finds the first.
Json jsonFromText(const std::string& text);

// JSON on one line. Bytes that are not UTF-8 (in file names, in settings) become replacement characters.
std::string textOf(const Json& json);

}  // namespace strobe
