// SPDX-License-Identifier: MIT
// JSON from text and to text. The reader is for large texts: the library's own copies the fields of an object whenever
// it grows.
#pragma once

#include <string>

#include "base/json_fwd.h"

namespace strobe {

// `is_discarded()` where the text is no JSON. An object that has a key twice keeps both; the first is found.
Json jsonFromText(const std::string& text);

// JSON on one line. Bytes that are not UTF-8 (of a file name, of a setting) become replacement characters.
std::string textOf(const Json& json);

}  // namespace strobe
