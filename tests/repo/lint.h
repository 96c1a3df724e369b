// SPDX-License-Identifier: MIT
// Rules of the house that no compiler checks, over files given as text.
#pragma once

#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace strobe::repo {

struct Source {
  std::string path;  // relative to the top, with '/'
  std::string text;
};

// Which floor a folder of runtime/ is on, and which lower folders it may still not know.
struct Floor {
  int level = 0;
  std::set<std::string> unknown;
};
using Floors = std::map<std::string, Floor>;

// Reads runtime/floors.txt: "LEVEL FOLDER [not FOLDER...]" per line, '#' comments. Throws `Error` on anything else.
Floors parseFloors(const std::string& text);

// All files of the project below `top` (no build folders, nothing hidden but .ci), sorted by path.
std::vector<Source> readSources(const std::filesystem::path& top);

// Each returns one line per violation, "path:line: what".
using Findings = std::vector<std::string>;

// runtime/ includes follow the floors; a shader includes shared/, lib/, mixin/ and its own family.
Findings lintFloors(const std::vector<Source>& sources, const Floors& floors);

// shaders/lib/ holds functions of their arguments (and of the frame, which every pass has). What uses names that a pass
// declares is in shaders/mixin/, whose files list them in their second line, those of their includes among them.
Findings lintMixins(const std::vector<Source>& sources);

// Vulkan's header in gpu/ and one file of live/, Lua's in script/.
Findings lintForeignHeaders(const std::vector<Source>& sources);

// A class in a header of runtime/ has at most so many methods, constructors and private ones among them.
Findings lintClasses(const std::vector<Source>& sources, int most);

// Every source says its licence in one of its first two lines.
Findings lintLicences(const std::vector<Source>& sources);

// In runtime/, C++ changes no variable of its own process, and only main() makes a home from the environment.
Findings lintHome(const std::vector<Source>& sources);

// No path and no host of the machine on which something was written.
Findings lintMachines(const std::vector<Source>& sources);

}  // namespace strobe::repo
