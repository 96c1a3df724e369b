// SPDX-License-Identifier: MIT
#include "repo/lint.h"

#include <algorithm>
#include <regex>
#include <sstream>

#include "base/error.h"
#include "base/files.h"

namespace strobe::repo {
namespace {

namespace fs = std::filesystem;

bool endsWithAny(const std::string& text, const std::vector<std::string>& ends) {
  return std::any_of(ends.begin(), ends.end(), [&](const std::string& end) { return text.ends_with(end); });
}

bool isCpp(const std::string& path) { return endsWithAny(path, {".h", ".cpp", ".inc"}); }

bool isSource(const std::string& path) {
  static const std::set<std::string> scripts = {"strobe", ".ci/run", "docs/pictures/make", "tools/same_pictures"};
  if (scripts.count(path) || path.ends_with("CMakeLists.txt")) return true;
  return isCpp(path) || endsWithAny(path, {".glsl", ".lua", ".cmake", ".py", ".sh"});
}

// "gpu" for "runtime/gpu/device.cpp"; "" outside `top`.
std::string folderBelow(const std::string& top, const std::string& path) {
  if (!path.starts_with(top)) return "";
  size_t slash = path.find('/', top.size());
  return slash == std::string::npos ? "" : path.substr(top.size(), slash - top.size());
}

std::string finding(const Source& source, int line, const std::string& what) {
  return fmt::format("{}:{}: {}", source.path, line, what);
}

// Calls `visit(line number, line)` for each line.
template <class Visit>
void forLines(const Source& source, Visit visit) {
  std::istringstream lines(source.text);
  std::string line;
  for (int number = 1; std::getline(lines, line); ++number) visit(number, line);
}

// Calls `visit(line number, header)` for each #include.
template <class Visit>
void forIncludes(const Source& source, Visit visit) {
  static const std::regex include(R"rx(^\s*#\s*include\s*["<]([^">]+)[">])rx");
  forLines(source, [&](int number, const std::string& line) {
    std::smatch match;
    if (std::regex_search(line, match, include)) visit(number, match[1].str());
  });
}

// Includes in quotation marks name a project file, in angle brackets a system file.
template <class Visit>
void forOwnIncludes(const Source& source, Visit visit) {
  static const std::regex include(R"rx(^\s*#\s*include\s*"([^"]+)")rx");
  forLines(source, [&](int number, const std::string& line) {
    std::smatch match;
    if (std::regex_search(line, match, include)) visit(number, match[1].str());
  });
}

std::string whyNot(const std::string& folder, const std::string& header, const Floors& floors) {
  std::string other = header.substr(0, header.find('/'));
  if (header.find('/') == std::string::npos) return fmt::format("'{}' does not say its folder", header);
  if (other == folder || other == "shared") return "";  // shaders/shared: structures for C++ and GLSL
  auto target = floors.find(other);
  if (target == floors.end()) return fmt::format("'{}' is in no room", header);
  const Floor& own = floors.at(folder);
  if (target->second.level >= own.level) return fmt::format("'{}' is not on a lower floor", header);
  return own.unknown.count(other) ? fmt::format("{} may not know {} ('{}')", folder, other, header) : "";
}

void lintFloorsOf(const Source& source, const Floors& floors, Findings& findings) {
  std::string folder = folderBelow("runtime/", source.path);
  if (folder.empty() || !isCpp(source.path)) return;
  if (!floors.count(folder)) return findings.push_back(finding(source, 1, "is on no floor"));
  forOwnIncludes(source, [&](int number, const std::string& header) {
    std::string why = whyNot(folder, header, floors);
    if (!why.empty()) findings.push_back(finding(source, number, why));
  });
}

void lintFamilyOf(const Source& source, Findings& findings) {
  std::string family = folderBelow("shaders/", source.path);
  if (family.empty() || !source.path.ends_with(".glsl")) return;
  forOwnIncludes(source, [&](int number, const std::string& header) {
    std::string other = header.substr(0, header.find('/'));
    if (other == "shared" || other == "lib" || other == "mixin" || other == family) return;
    findings.push_back(finding(source, number, fmt::format("includes '{}' of another family", header)));
  });
}

// Reports every match of `pattern` in the files that `applies` to.
template <class Applies>
Findings lintPattern(const std::vector<Source>& sources, const std::string& pattern, const char* what,
                     Applies applies) {
  std::regex regex(pattern, std::regex::icase);
  Findings findings;
  for (const Source& source : sources) {
    if (!applies(source.path)) continue;
    forLines(source, [&](int number, const std::string& line) {
      std::smatch match;
      if (!std::regex_search(line, match, regex)) return;
      findings.push_back(finding(source, number, fmt::format("{} '{}'", what, match.str())));
    });
  }
  return findings;
}

bool isOurs(const fs::path& relative) {
  std::string first = relative.begin()->string();
  bool hidden = first.starts_with(".") && first != ".ci";
  return !hidden && first != "out" && first != "build" && !first.starts_with("build-");
}

}  // namespace

Floors parseFloors(const std::string& text) {
  Floors floors;
  forLines({"", text}, [&](int number, const std::string& line) {
    if (line.empty() || line[0] == '#') return;
    std::istringstream words(line);
    std::string folder, word;
    Floor floor;
    bool good = static_cast<bool>(words >> floor.level >> folder);
    if (good && words >> word) good = word == "not";
    while (words >> word) floor.unknown.insert(word);
    if (!good || !floors.emplace(folder, floor).second) throw Error("bad floor", {"runtime/floors.txt", number});
  });
  return floors;
}

std::vector<Source> readSources(const fs::path& top) {
  std::vector<Source> sources;
  for (auto entry = fs::recursive_directory_iterator(top); entry != fs::recursive_directory_iterator(); ++entry) {
    fs::path relative = fs::relative(entry->path(), top);
    if (entry->is_directory() && !isOurs(relative)) entry.disable_recursion_pending();
    bool text = isSource(relative.generic_string()) || endsWithAny(relative.string(), {".md", ".txt", ".json", ".cff"});
    if (entry->is_regular_file() && isOurs(relative) && text) {
      sources.push_back({relative.generic_string(), readText(entry->path())});
    }
  }
  std::sort(sources.begin(), sources.end(), [](const Source& a, const Source& b) { return a.path < b.path; });
  return sources;
}

Findings lintFloors(const std::vector<Source>& sources, const Floors& floors) {
  Findings findings;
  for (const Source& source : sources) {
    lintFloorsOf(source, floors, findings);
    lintFamilyOf(source, findings);
  }
  return findings;
}

Findings lintForeignHeaders(const std::vector<Source>& sources) {
  static const std::regex vulkan(R"(^(vulkan/|.*vulkan(_core)?\.h))"),
      lua(R"((^|/)(lua|lualib|lauxlib|luaconf)\.h(pp)?$)");
  Findings findings;
  std::set<std::string> surface_files;
  for (const Source& source : sources) {
    std::string folder = folderBelow("runtime/", source.path);
    if (folder.empty() || !isCpp(source.path)) continue;
    forIncludes(source, [&](int number, const std::string& header) {
      if (std::regex_search(header, lua) && folder != "script") {
        findings.push_back(finding(source, number, fmt::format("includes '{}' outside script/", header)));
      }
      if (!std::regex_search(header, vulkan) || folder == "gpu") return;
      if (folder == "live") surface_files.insert(source.path);
      if (folder == "live" && surface_files.size() == 1) return;
      findings.push_back(finding(source, number, fmt::format("includes '{}' outside gpu/", header)));
    });
  }
  return findings;
}

Findings lintLicences(const std::vector<Source>& sources) {
  Findings findings;
  for (const Source& source : sources) {
    if (!isSource(source.path)) continue;
    bool found = false;
    forLines(source, [&](int number, const std::string& line) {
      found = found || (number <= 2 && line.find("SPDX-License-Identifier: MIT") != std::string::npos);
    });
    if (!found) findings.push_back(finding(source, 1, "has no SPDX line"));
  }
  return findings;
}

Findings lintHome(const std::vector<Source>& sources) {
  Findings findings;
  for (const Source& source : sources) {
    bool cpp = source.path.ends_with(".cpp") || source.path.ends_with(".h");
    if (!cpp || !source.path.starts_with("runtime/")) continue;
    bool makes = source.path == "runtime/app/main.cpp" || source.path.starts_with("runtime/base/home.");
    bool changes = source.path == "runtime/gpu/device.cpp";  // the number of threads of the software device
    forLines(source, [&](int number, const std::string& line) {
      if (!changes && line.find(std::string("set") + "env(") != std::string::npos)
        findings.push_back(finding(source, number, "changes the environment of this process"));
      if (!makes && line.find(std::string("from") + "Environment(") != std::string::npos)
        findings.push_back(finding(source, number, "makes a home instead of taking one"));
    });
  }
  return findings;
}

Findings lintMachines(const std::vector<Source>& sources) {
  // Written in pieces: otherwise the rule would find its own pattern.
  std::string folders = std::string("(^|[^a-z0-9_.])/(wor") + "k|hom" + "e|roo" + "t|User" + "s)/";
  std::string hosts = std::string("debian\\.or") + "g|ubuntu\\.co" + "m";
  return lintPattern(sources, folders + "|" + hosts, "belongs to a machine:", [](const std::string&) { return true; });
}

}  // namespace strobe::repo
