// SPDX-License-Identifier: MIT
// Content of the files that pictures are made of: scripts, shaders, models, images.
#pragma once

#include <string>

#include "base/files.h"

namespace strobe {

enum class Language { lua, glsl };

// Text with a blank for every comment and, in Lua, for every help text. A help text is a field `doc` or `fails` with
// strings joined by "..".
std::string withoutComments(const std::string& text, Language language);

// SHA-256 of a file. For Lua and GLSL (by extension), without comments, help texts, blank lines and blanks at line
// ends. Equal to tools/reproduce/inputs.py. Throws `Error` if the file cannot be read.
std::string inputHash(const Path& file);

}  // namespace strobe
