// SPDX-License-Identifier: MIT
// GLSL as tokens with their places: enough to find operators, literals and calls. Comments and preprocessor lines are
// no tokens.
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
  int partner = -1;    // of a bracket: the token that closes or opens it
  bool fixed = false;  // part of a declaration: layout(...), the inside of a struct, the size of an array
  int for_part = -1;   // within the brackets of a for: 0 start, 1 condition, 2 step

  size_t end() const { return at + text.size(); }
  bool is(std::string_view other) const { return text == other; }
};

std::vector<Token> tokensOf(const std::string& glsl);

// Line and column of an offset, from 1.
struct LinePlace {
  int line = 1, column = 1;
};
LinePlace placeOf(const std::string& text, size_t offset);

// The line around an offset, without the space around it.
std::string lineAt(const std::string& text, size_t offset);

}  // namespace strobe::mutate
