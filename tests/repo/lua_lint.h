// SPDX-License-Identifier: MIT
// Project rules about Lua, and about names that C++ may use.
#pragma once

#include "repo/lint.h"

namespace strobe::repo {

// Lua requires follow the floors of scripts/floors.txt: a file's folder is the longest folder of the table that
// contains it. Modules named by an expression are not tested.
Findings lintRequires(const std::vector<Source>& sources, const Floors& floors);

// Names of techniques declared by passes/ and scripts/pipelines.
struct TechniqueNames {
  std::set<std::string> names;       // files and passes, "tile_max"; a name that ends in a year also without the year
  std::set<std::string> parameters;  // of passes and pipelines
};
TechniqueNames techniqueNames(const std::vector<Source>& sources);

// Names that are also words with another meaning, from tests/repo/techniques.txt.
struct KnownWords {
  std::set<std::string> quoted;                      // ordinary words: searched as whole strings only
  std::set<std::string> free;                        // not searched
  std::set<std::pair<std::string, std::string>> at;  // file and name: allowed there
};

// Lines "quoted NAME: reason", "free NAME: reason", "at FILE NAME: reason"; '#' comments. Throws `Error` on any other
// line, also without a reason.
KnownWords parseKnownWords(const std::string& text);

// C++ in runtime/ names no technique (in identifiers, comments and texts, `TileMax` as `tile_max`) and no parameter of
// a technique (as a whole string). An unneeded entry of `known` is a finding too, unless its file is gone.
Findings lintTechniques(const std::vector<Source>& sources, const TechniqueNames& techniques, const KnownWords& known);

// Shaders of passes/ fetch `pointwise` reads at their own pixel: NAME_tex occurs only in texelFetch(NAME_tex, pixel,
// 0).
Findings lintPointwise(const std::vector<Source>& sources);

}  // namespace strobe::repo
