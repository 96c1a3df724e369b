// SPDX-License-Identifier: MIT
// Sentences of the repository, extracted from code and Markdown.
#pragma once

#include <string>
#include <vector>

#include "repo/lint.h"

namespace strobe::repo {

// One comment block, string literal, paragraph or table cell.
struct TextUnit {
  std::string path;
  int line = 0;      // of its start, from 1
  std::string text;  // words with one space between them
};

// Text units of at least four words, in the order of the file:
// - comment blocks of C++, GLSL, Lua, Python and shell, without licence lines, `#!` and LuaLS annotations;
// - string literals of C++ and Lua, except code; adjacent literals, and literals that `..` joins, are one unit;
// - paragraphs and table cells of Markdown, without headings, code and HTML comments.
std::vector<TextUnit> textUnits(const Source& source);

}  // namespace strobe::repo
