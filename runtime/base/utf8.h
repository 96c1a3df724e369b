// SPDX-License-Identifier: MIT
// Text as people see it: code points and columns, not bytes.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace strobe {

// The code points of UTF-8. A byte that begins none stands for itself; a sequence that ends early ends with the text.
std::vector<char32_t> codePoints(std::string_view text);

// Columns of a terminal: combining marks take none, wide East Asian characters and emoji two, all others one.
size_t displayWidth(std::string_view text);

// `text` followed or preceded by as many blanks as `width` columns need; longer text stays as it is.
std::string paddedRight(std::string_view text, size_t width);
std::string paddedLeft(std::string_view text, size_t width);

}  // namespace strobe
