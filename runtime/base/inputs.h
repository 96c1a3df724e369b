// SPDX-License-Identifier: MIT
// Content of the files that pictures are made of: scripts, shaders, models, images.
#pragma once

#include <string>

#include "base/files.h"

namespace strobe {

// Syntax of the comments and strings of a source text: Lua (scripts) or GLSL (shaders).
enum class Language { lua, glsl };

// Text with a blank for every comment and, in Lua, for every text for people: a field `doc` or `fails`, and quoted
// strings, joined by "..", if one of these has three words or more.
std::string withoutComments(const std::string& text, Language language);

// SHA-256 of a file. For Lua and GLSL (by extension), without comments, texts for people, and blanks without meaning.
// Equal to tools/reproduce/inputs.py. Throws `Error` if the file cannot be read.
std::string inputHash(const Path& file);

}  // namespace strobe
