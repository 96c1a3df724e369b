// SPDX-License-Identifier: MIT
// Content of the files that pictures are made of: scripts, shaders, models, images.
#pragma once

#include <string>

#include "base/files.h"

namespace strobe {

enum class Language { lua, glsl };

// The text with a blank for every comment and, in Lua, for every help text: a field `doc` or `fails` whose value is
// strings joined by "..".
std::string withoutComments(const std::string& text, Language language);

// SHA-256 of a file. Of Lua and GLSL (by the ending of the name) comments, help texts, blank lines and blanks at the
// ends of lines do not count. tools/reproduce/inputs.py gives the same. Throws `Error` if the file cannot be read.
std::string inputHash(const Path& file);

}  // namespace strobe
