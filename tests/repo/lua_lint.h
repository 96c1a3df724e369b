// SPDX-License-Identifier: MIT
// Rules of the house about Lua, and about what C++ may know of it.
#pragma once

#include "repo/lint.h"

namespace strobe::repo {

// Lua requires follow the floors of scripts/floors.txt: a file's room is the longest folder of the table that it is in.
// Modules that are named by an expression are not looked at.
Findings lintRequires(const std::vector<Source>& sources, const Floors& floors);

// What techniques are called, as passes/ and scripts/pipelines declare it.
struct TechniqueNames {
  std::set<std::string> names;       // files and passes, "tile_max"; of those that end in a year also without it
  std::set<std::string> parameters;  // of passes and pipelines
};
TechniqueNames techniqueNames(const std::vector<Source>& sources);

// Names that are words of other things too, from tests/repo/techniques.txt.
struct KnownWords {
  std::set<std::string> quoted;                      // names that are ordinary words: sought as whole strings alone
  std::set<std::string> free;                        // not sought
  std::set<std::pair<std::string, std::string>> at;  // file and name: may stand there
};

// Lines "quoted NAME: reason", "free NAME: reason", "at FILE NAME: reason"; '#' comments. Throws `Error` on anything
// else, on a line without a reason too.
KnownWords parseKnownWords(const std::string& text);

// C++ under runtime/ names no technique (in identifiers, comments and texts, `TileMax` as `tile_max`) and no parameter
// of one (as a whole string). What `known` lists without need is a finding too, but for files that are gone.
Findings lintTechniques(const std::vector<Source>& sources, const TechniqueNames& techniques, const KnownWords& known);

// Shaders of passes/ look up what is read `pointwise` at their own pixel: NAME_tex stands in texelFetch(NAME_tex,
// pixel, 0).
Findings lintPointwise(const std::vector<Source>& sources);

}  // namespace strobe::repo
