// SPDX-License-Identifier: MIT
// Project rules that no compiler checks, applied to files given as text.
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

// Level of a folder of runtime/, and lower folders that it may not include.
struct Floor {
  int level = 0;
  std::set<std::string> unknown;
};
using Floors = std::map<std::string, Floor>;

// Reads runtime/floors.txt: "LEVEL FOLDER [not FOLDER...]" per line, '#' comments. Throws `Error` on anything else.
Floors parseFloors(const std::string& text);

// All project files below `top`, without build folders and hidden ones except .ci, sorted by path.
std::vector<Source> readSources(const std::filesystem::path& top);

// Each check returns one line per violation, "path:line: what".
using Findings = std::vector<std::string>;

// runtime/ includes follow the floors; a shader includes shared/, lib/, mixin/ and its own family.
Findings lintFloors(const std::vector<Source>& sources, const Floors& floors);

// shaders/lib/ has pure functions of their arguments (and of the frame, which every pass has). Code that uses a pass's
// declarations is in shaders/mixin/; each file lists the needed names, also of its includes, in its second line.
Findings lintMixins(const std::vector<Source>& sources);

// Vulkan's header is included only in gpu/ and one file of live/, Lua's only in script/.
Findings lintForeignHeaders(const std::vector<Source>& sources);

// A class in a header of runtime/ has at most `most` methods, including constructors and private methods.
Findings lintClasses(const std::vector<Source>& sources, int most);

// Every source states its licence in its first two lines.
Findings lintLicences(const std::vector<Source>& sources);

// In runtime/, C++ changes no environment variable of its process, and only main() makes a home from the environment.
Findings lintHome(const std::vector<Source>& sources);

// No text contains paths or host names of a developer's machine.
Findings lintMachines(const std::vector<Source>& sources);

}  // namespace strobe::repo
