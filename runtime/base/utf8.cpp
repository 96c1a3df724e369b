// SPDX-License-Identifier: MIT
#include "base/utf8.h"

#include <algorithm>
#include <array>
#include <vector>

namespace strobe {

namespace {

// Code points of UTF-8. A byte that begins no sequence stands for itself. A sequence that is cut short ends with the
// text.
std::vector<char32_t> codePoints(std::string_view text) {
  std::vector<char32_t> points;
  for (size_t i = 0; i < text.size();) {
    unsigned char lead = static_cast<unsigned char>(text[i++]);
    int following = lead >= 0xf0 ? 3 : lead >= 0xe0 ? 2 : lead >= 0xc0 ? 1 : 0;
    char32_t point = following ? lead & (0x3f >> following) : lead;
    while (following-- > 0 && i < text.size()) point = point << 6 | (static_cast<unsigned char>(text[i++]) & 0x3f);
    points.push_back(point);
  }
  return points;
}

struct CodePointRange {
  char32_t first, last;
};

template <size_t count>
bool isIn(const std::array<CodePointRange, count>& ranges, char32_t point) {
  return std::any_of(ranges.begin(), ranges.end(),
                     [&](const CodePointRange& range) { return point >= range.first && point <= range.last; });
}

// Combining marks, joiners and variation selectors.
constexpr std::array<CodePointRange, 6> kNoColumn = {
    {{0x300, 0x36f}, {0x200b, 0x200f}, {0x1ab0, 0x1aff}, {0x1dc0, 0x1dff}, {0x20d0, 0x20ff}, {0xfe00, 0xfe0f}}};

// Blocks that Unicode's East Asian Width calls wide.
constexpr std::array<CodePointRange, 8> kTwoColumns = {{{0x1100, 0x115f},
                                                        {0x2e80, 0x303e},
                                                        {0x3041, 0xa4cf},
                                                        {0xac00, 0xd7a3},
                                                        {0xf900, 0xfaff},
                                                        {0xff00, 0xff60},
                                                        {0x1f300, 0x1faff},
                                                        {0x20000, 0x3fffd}}};

}  // namespace

size_t displayWidth(std::string_view text) {
  size_t width = 0;
  for (char32_t point : codePoints(text)) width += isIn(kNoColumn, point) ? 0 : isIn(kTwoColumns, point) ? 2 : 1;
  return width;
}

static std::string blanks(std::string_view text, size_t width) {
  size_t used = displayWidth(text);
  return std::string(used < width ? width - used : 0, ' ');
}

std::string paddedRight(std::string_view text, size_t width) { return std::string(text) + blanks(text, width); }
std::string paddedLeft(std::string_view text, size_t width) { return blanks(text, width) + std::string(text); }

}  // namespace strobe
