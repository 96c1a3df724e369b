// SPDX-License-Identifier: MIT
// Tokens of GLSL with their places, for finding operators, literals and calls. Comments and preprocessor lines have no
// tokens.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace strobe::mutate {

struct Token {
  enum class Kind { Name, Number, Sign };
  Kind kind = Kind::Sign;
  std::string text;
  size_t at = 0;       // offset in the file
  int partner = -1;    // for a bracket: index of the matching bracket
  bool fixed = false;  // part of a declaration: layout(...), the inside of a struct, the size of an array
  int for_part = -1;   // inside the parentheses of a `for`: 0 start, 1 condition, 2 step; otherwise -1

  size_t end() const { return at + text.size(); }
  bool is(std::string_view other) const { return text == other; }
};

std::vector<Token> tokensOf(const std::string& glsl);

// Line and column of an offset, starting at 1.
struct LinePlace {
  int line = 1, column = 1;
};
LinePlace placeOf(const std::string& text, size_t offset);

// Text of the line at an offset, without the space at both ends.
std::string lineAt(const std::string& text, size_t offset);

}  // namespace strobe::mutate
