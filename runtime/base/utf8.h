// SPDX-License-Identifier: MIT
// Text in terminal columns, not bytes.
#pragma once

#include <string>
#include <string_view>

namespace strobe {

// Width in terminal columns: combining marks 0, wide East Asian characters and emoji 2, all others 1.
size_t displayWidth(std::string_view text);

// `text` padded on the right or left with blanks to `width` columns. Longer text is unchanged.
std::string paddedRight(std::string_view text, size_t width);
std::string paddedLeft(std::string_view text, size_t width);

}  // namespace strobe
