// SPDX-License-Identifier: MIT
#include "repo/lua_lint.h"

#include <algorithm>
#include <filesystem>
#include <functional>
#include <regex>
#include <sstream>

#include "base/error.h"

namespace strobe::repo {
namespace {

using Visit = std::function<void(int, const std::string&)>;

void forLines(const std::string& text, const Visit& visit) {
  std::istringstream lines(text);
  std::string line;
  for (int number = 1; std::getline(lines, line); ++number) visit(number, line);
}

// Calls `visit` for the first group of each match of `pattern` in a line.
void forMatches(const std::string& line, const std::regex& pattern,
                const std::function<void(const std::string&)>& visit) {
  for (std::sregex_iterator match(line.begin(), line.end(), pattern), end; match != end; ++match)
    visit((*match)[1].str());
}

std::string luaFinding(const Source& source, int line, const std::string& what) {
  return fmt::format("{}:{}: {}", source.path, line, what);
}

// ---- requires

std::string roomOf(const std::string& path, const Floors& floors) {
  std::string room;
  for (const auto& [folder, floor] : floors)
    if (path.starts_with(folder + "/") && folder.size() > room.size()) room = folder;
  return room;
}

// "passes/edge/a.lua" for "passes.edge.a"; "" for a built-in module.
std::string fileOf(std::string module) {
  if (module == "strobe.native") return "";
  std::replace(module.begin(), module.end(), '.', '/');
  return (module.starts_with("strobe/") ? "scripts/" : "") + module + ".lua";
}

std::string whyNotRequired(const std::string& room, const std::string& module, const Floors& floors) {
  std::string file = fileOf(module);
  if (file.empty()) return "";
  std::string other = roomOf(file, floors);
  if (other == room) return "";
  if (other.empty()) return fmt::format("'{}' is in no room", module);
  if (floors.at(other).level >= floors.at(room).level) return fmt::format("'{}' is not on a lower floor", module);
  return floors.at(room).unknown.count(other) ? fmt::format("{} may not know {} ('{}')", room, other, module) : "";
}

// ---- names

// "passes/edge/a.lua" -> "a".
std::string stemOf(const std::string& path) { return std::filesystem::path(path).stem().string(); }

bool declaresTechniques(const std::string& path) {
  bool of_passes = path.starts_with("passes/"), of_pipelines = path.starts_with("scripts/pipelines/");
  return path.ends_with(".lua") && (of_passes || of_pipelines);
}

bool isModule(const std::string& path) { return path.find("/lib/") != std::string::npos; }

std::string withoutYear(const std::string& name) { return std::regex_replace(name, std::regex("[0-9]{4}$"), ""); }

bool isBreak(char before, char after) {
  bool upper = after >= 'A' && after <= 'Z', was_upper = before >= 'A' && before <= 'Z';
  return upper && !was_upper;
}

// "tile max" for "tileMax", "TileMax", "kTileMax_" and "tile_max": the words of an identifier, each between spaces.
std::string wordsOf(const std::string& identifier) {
  std::string words = " ";
  for (size_t i = 0; i < identifier.size(); ++i) {
    char c = identifier[i];
    if (c == '_' || (i && isBreak(identifier[i - 1], c))) words += ' ';
    if (c != '_') words += char(c >= 'A' && c <= 'Z' ? c + 32 : c);
  }
  return words + " ";
}

class TechniqueLint {
 public:
  TechniqueLint(const TechniqueNames& techniques, const KnownWords& known) : known_(known) {
    for (const std::string& name : techniques.names) add(name, known.quoted.count(name) > 0);
    for (const std::string& name : techniques.parameters) add(name, true);
    for (const std::string& name : known.quoted) noteStale(name, techniques.names.count(name) > 0);
    for (const std::string& name : known.free) noteStale(name, all_.count(name) > 0);
  }

  void look(const Source& source) {
    seen_.insert(source.path);
    static const std::regex text("\"([^\"]*)\""), word("([A-Za-z_][A-Za-z_0-9]*)");
    forLines(source.text, [&](int number, const std::string& line) {
      forMatches(line, text, [&](const std::string& one) { report(source, number, one, strings_.count(one) > 0); });
      forMatches(line, word, [&](const std::string& one) { lookAtWord(source, number, one); });
    });
  }

  Findings findings() {
    for (const auto& [path, name] : known_.at)
      if (seen_.count(path) && !met_.count({path, name}))
        findings_.push_back(fmt::format("{} does not name '{}' any more", path, name));
    return findings_;
  }

 private:
  void add(const std::string& name, bool as_string) {
    all_.insert(name);
    if (known_.free.count(name)) return;
    if (as_string) strings_.insert(name);
    else words_.emplace(name, wordsOf(name));
  }

  void noteStale(const std::string& name, bool needed) {
    if (!needed) findings_.push_back(fmt::format("'{}' is known, but no technique has that name", name));
  }

  void lookAtWord(const Source& source, int number, const std::string& identifier) {
    std::string words = wordsOf(identifier);
    for (const auto& [name, own] : words_) report(source, number, name, words.find(own) != std::string::npos);
  }

  void report(const Source& source, int number, const std::string& name, bool is_name) {
    if (!is_name) return;
    if (known_.at.count({source.path, name})) met_.insert({source.path, name});
    else findings_.push_back(luaFinding(source, number, fmt::format("names a technique: '{}'", name)));
  }

  const KnownWords& known_;
  std::set<std::string> all_, strings_, seen_;
  std::map<std::string, std::string> words_;
  std::set<std::pair<std::string, std::string>> met_;
  Findings findings_;
};

}  // namespace

Findings lintRequires(const std::vector<Source>& sources, const Floors& floors) {
  static const std::regex require(R"rx(\brequire\s*\(?\s*["']([^"']+)["'])rx");
  Findings findings;
  for (const Source& source : sources) {
    if (!source.path.ends_with(".lua") || source.path == "scripts/types.lua") continue;
    std::string room = roomOf(source.path, floors);
    if (room.empty()) findings.push_back(luaFinding(source, 1, "is in no room"));
    forLines(source.text, [&](int number, const std::string& line) {
      forMatches(line.substr(0, line.find("--")), require, [&](const std::string& module) {
        std::string why = room.empty() ? "" : whyNotRequired(room, module, floors);
        if (!why.empty()) findings.push_back(luaFinding(source, number, why));
      });
    });
  }
  return findings;
}

TechniqueNames techniqueNames(const std::vector<Source>& sources) {
  static const std::regex pass(R"rx(^\s*name\s*=\s*"(\w+)")rx"),
      declared(R"rx(^\s*(\w+)\s*=\s*(?:\w+\.)?(?:int|float|bool|choice)\s*[{(])rx"),
      taken(R"rx(^\s*(\w+)\s*=\s*\w+\.params\.\w+)rx");
  TechniqueNames found;
  auto name = [&](const std::string& one) { found.names.insert({one, withoutYear(one)}); };
  auto parameter = [&](const std::string& one) { found.parameters.insert(one); };
  for (const Source& source : sources) {
    if (!declaresTechniques(source.path)) continue;
    if (!isModule(source.path)) name(stemOf(source.path));
    forLines(source.text, [&](int, const std::string& line) {
      if (source.path.starts_with("passes/")) forMatches(line, pass, name);
      forMatches(line, declared, parameter);
      forMatches(line, taken, parameter);
    });
  }
  return found;
}

KnownWords parseKnownWords(const std::string& text) {
  static const std::regex line_form(R"(^(quoted|free|at \S+) (\w+): \S.*$)");
  KnownWords known;
  forLines(text, [&](int number, const std::string& line) {
    if (line.empty() || line[0] == '#') return;
    std::smatch match;
    if (!std::regex_match(line, match, line_form)) throw Error("no known word", {"tests/repo/techniques.txt", number});
    if (match[1] == "quoted") known.quoted.insert(match[2]);
    else if (match[1] == "free") known.free.insert(match[2]);
    else known.at.insert({match[1].str().substr(3), match[2]});
  });
  return known;
}

Findings lintTechniques(const std::vector<Source>& sources, const TechniqueNames& techniques, const KnownWords& known) {
  TechniqueLint lint(techniques, known);
  for (const Source& source : sources) {
    bool cpp = source.path.ends_with(".h") || source.path.ends_with(".cpp") || source.path.ends_with(".inc");
    if (cpp && source.path.starts_with("runtime/")) lint.look(source);
  }
  return lint.findings();
}

// Adds a file of shaders/ and all files that it includes.
static void addWithIncludes(const std::map<std::string, const Source*>& files, const std::string& path,
                            std::set<const Source*>& found) {
  static const std::regex include(R"re(#include "([\w./]+)")re");
  auto file = files.find(path);
  if (file == files.end() || !found.insert(file->second).second) return;
  forMatches(file->second->text, include,
             [&](const std::string& name) { addWithIncludes(files, "shaders/" + name, found); });
}

Findings lintPointwise(const std::vector<Source>& sources) {
  static const std::regex shader(R"re(\bshader\s*=\s*"([\w/]+)")re"), read(R"((\w+)\s*=\s*\{[^{}]*\bpointwise = true)");
  std::map<std::string, const Source*> files;
  for (const Source& source : sources) files[source.path] = &source;
  Findings findings;
  auto look = [&](const Source& source, const std::string& name) {
    const std::regex texture("\\b" + name + "_(tex\\b|at\\()");
    const std::regex lookup("\\b(texelFetch\\(" + name + "_tex, pixel, 0\\)|" + name + "_at\\(pixel\\))");
    forLines(source.text, [&](int number, const std::string& line) {
      const bool is_note = line.starts_with("//");
      if (!is_note && std::regex_search(std::regex_replace(line, lookup, ""), texture))
        findings.push_back(luaFinding(source, number, fmt::format("'{}' is read pointwise", name)));
    });
  };
  for (const Source& pass : sources) {
    const std::string folder = "passes/";
    if (!pass.path.starts_with(folder)) continue;
    std::smatch file;
    std::string name = pass.path.substr(folder.size(), pass.path.rfind(".lua") - folder.size());
    if (std::regex_search(pass.text, file, shader)) name = file[1];
    std::set<const Source*> found;
    addWithIncludes(files, "shaders/" + name + ".glsl", found);
    forMatches(pass.text, read, [&](const std::string& name) {
      for (const Source* source : found) look(*source, name);
    });
  }
  return findings;
}

}  // namespace strobe::repo
