// SPDX-License-Identifier: MIT
#include <algorithm>
#include <regex>
#include <sstream>

#include "base/error.h"
#include "repo/lint.h"

namespace strobe::repo {
namespace {

// GLSL names that a pass must declare, and names that it may declare. The scene's arrays count as "scene", names of
// tracing passes as "rays".
struct Needs {
  std::set<std::string> needed, optional;

  void add(const Needs& other) {
    needed.insert(other.needed.begin(), other.needed.end());
    optional.insert(other.optional.begin(), other.optional.end());
  }
  bool empty() const { return needed.empty() && optional.empty(); }
};

std::string withoutComment(const std::string& line) { return line.substr(0, line.find("//")); }

// The needed name in a match of `pattern` below; `text` decides whether it is a buffer.
std::string nameOf(const std::smatch& match, const std::string& text) {
  std::string name = match.str();
  if (name.starts_with("HAS_")) {
    std::string read = name.substr(4);
    return read + (text.find(read + "_buf") == std::string::npos ? "_tex" : "_buf");
  }
  if (name.ends_with("_at")) return name.substr(0, name.size() - 3) + "_tex";
  if (name == "scene_top_levels" || name == "scene_bvh") return "rays";
  return name.starts_with("scene_") ? "scene" : name;
}

// Needs of a text without its includes. Names in `#if HAS_x` or `#if defined(PARAM_x)` are optional.
Needs ownNeeds(const std::string& text) {
  static const std::regex pattern(R"(params\.\w+|\b(PARAM|HAS|scene|count)_\w+|\b\w+_(tex|at|img|out|buf)\b)");
  static const std::regex opens(R"(^\s*#\s*if)"), closes(R"(^\s*#\s*endif)"), asks(R"(HAS_|defined\(PARAM_)");
  Needs needs;
  std::vector<bool> conditions;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    std::string code = withoutComment(line);
    bool optional = std::find(conditions.begin(), conditions.end(), true) != conditions.end();
    if (std::regex_search(code, opens)) conditions.push_back(std::regex_search(code, asks));
    if (std::regex_search(code, closes) && !conditions.empty()) conditions.pop_back();
    for (std::sregex_iterator match(code.begin(), code.end(), pattern), end; match != end; ++match) {
      bool asked = match->str().starts_with("HAS_") || code.find("defined(" + match->str() + ")") != std::string::npos;
      (optional || asked ? needs.optional : needs.needed).insert(nameOf(*match, text));
    }
  }
  return needs;
}

using Texts = std::map<std::string, std::string>;  // by path below shaders/

// Needs of a file and all its includes.
Needs needsOf(const std::string& file, const Texts& texts, std::set<std::string>& seen) {
  Needs needs;
  auto found = texts.find(file);
  if (found == texts.end() || !seen.insert(file).second) return needs;
  needs = ownNeeds(found->second);
  static const std::regex include(R"rx(#\s*include\s*"([^"]+)")rx");
  for (std::sregex_iterator match(found->second.begin(), found->second.end(), include), end; match != end; ++match)
    needs.add(needsOf((*match)[1], texts, seen));
  for (const std::string& name : needs.needed) needs.optional.erase(name);
  return needs;
}

std::set<std::string> listed(const std::string& names) {
  std::set<std::string> set;
  std::istringstream words(std::regex_replace(names, std::regex("[,\n]|//"), " "));
  for (std::string word; words >> word;) set.insert(word);
  set.erase("nothing");
  return set;
}

// The line after the licence: "// Needs: a_tex, params.b; may have: PARAM_c.", possibly on several lines.
Needs statedNeeds(const std::string& text) {
  static const std::regex form(R"(^[^\n]*\n// Needs: ([^;:]*?)(;\s+(//\s+)?may have:([^;:]*?))?\.\n(?!//   ))");
  std::smatch match;
  if (!std::regex_search(text, match, form)) return {{"no line"}, {}};
  return {listed(match[1]), listed(match[4])};
}

std::string textOf(const Needs& needs) {
  auto join = [](const std::set<std::string>& names) { return fmt::format("{}", fmt::join(names, ", ")); };
  std::string text = "// Needs: " + (needs.needed.empty() ? "nothing" : join(needs.needed));
  return text + (needs.optional.empty() ? "" : "; may have: " + join(needs.optional)) + ".";
}

}  // namespace

Findings lintMixins(const std::vector<Source>& sources) {
  Texts texts;
  for (const Source& source : sources)
    if (source.path.starts_with("shaders/")) texts[source.path.substr(8)] = source.text;
  Findings findings;
  for (const auto& [file, text] : texts) {
    bool mixin = file.starts_with("mixin/");
    if (!mixin && !file.starts_with("lib/")) continue;
    std::set<std::string> seen;
    Needs needs = needsOf(file, texts, seen);
    if (!mixin && !needs.empty())
      findings.push_back(fmt::format("shaders/{}: is not a pure function, but has '{}'", file, textOf(needs)));
    if (!mixin) continue;
    Needs stated = statedNeeds(text);
    if (needs.empty()) findings.push_back(fmt::format("shaders/{}: needs nothing: belongs to lib/", file));
    else if (stated.needed != needs.needed || stated.optional != needs.optional)
      findings.push_back(fmt::format("shaders/{}: its second line should be '{}'", file, textOf(needs)));
  }
  return findings;
}

}  // namespace strobe::repo
