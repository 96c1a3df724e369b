// SPDX-License-Identifier: MIT
#include "live/lua_text.h"

#include <algorithm>
#include <cctype>
#include <map>
#include <set>

namespace strobe::live {

std::string quoted(const std::string& text) {
  std::string result = "\"";
  for (char c : text) {
    if (c == '"' || c == '\\' || c == '\n') result += '\\';  // a line's end after a backslash stays one
    result += c;
  }
  return result + "\"";
}

std::string luaOf(const plan::Value& value) {
  if (const auto* text = std::get_if<std::string>(&value)) return quoted(*text);
  return plan::textOf(value);
}

std::string luaOf(const Json& json) {
  if (json.is_string()) return quoted(json.get<std::string>());
  if (!json.is_array()) return json.dump();
  std::string list;
  for (const Json& one : json) list += fmt::format("{}{}", list.empty() ? "" : ", ", luaOf(one));
  return fmt::format("{{ {} }}", list);
}

static std::string keyOf(const std::string& name) {
  static const std::set<std::string> words = {"and",      "break",  "do",   "else", "elseif", "end",  "false", "for",
                                              "function", "goto",   "if",   "in",   "local",  "nil",  "not",   "or",
                                              "repeat",   "return", "then", "true", "until",  "while"};
  bool plain = !name.empty() && !words.count(name) && !std::isdigit(static_cast<unsigned char>(name[0])) &&
               std::all_of(name.begin(), name.end(), [](unsigned char c) { return std::isalnum(c) || c == '_'; });
  return plain ? name : fmt::format("[{}]", quoted(name));
}

std::string tableOf(const std::vector<std::string>& fields) { return fmt::format("{{ {} }}", fmt::join(fields, ", ")); }

std::string field(const std::string& name, const std::string& text) { return keyOf(name) + " = " + text; }

namespace {

std::string spaced(const std::string& numbers) {
  std::string result;
  for (char c : numbers) result += c == ',' ? ", " : std::string(1, c);
  return result;
}

// "NAME=x,y,z" of the command line in two.
std::pair<std::string, std::string> assigned(const std::string& text) {
  size_t at = std::min(text.rfind('='), text.size());
  return {text.substr(0, at), spaced(text.substr(std::min(at + 1, text.size())))};
}

// Motions and camera paths are lists of texts elsewhere, tables in Lua.
std::string optionText(const lab::ShotOption& option, const lab::Shot& shot) {
  Json value = lab::jsonOf(option, shot);
  bool motion = option.name == "move" || option.name == "spin";
  if (!motion && option.name != "path") return luaOf(value);
  std::vector<std::string> entries;
  for (const Json& one : value) {
    auto [name, numbers] = assigned(one.get<std::string>());
    entries.push_back(motion ? field(name, fmt::format("{{ {} }}", numbers))
                             : fmt::format("{{ {}, {} }}", name, numbers));
  }
  return tableOf(entries);
}

}  // namespace

lab::Shot suggestedShot(lab::Workbench& bench, const lab::Shot& shot) {
  lab::Shot suggested;
  suggested.scene = shot.scene;
  suggested.sets = lab::sceneSettings(shot.sets);
  bench.scene(suggested);
  return suggested;
}

std::vector<std::string> optionFields(const lab::Shot& shot, const lab::Shot& from, const LeftOut& left_out) {
  std::vector<std::string> fields;
  for (const lab::ShotOption& option : lab::shotOptions()) {
    bool alike = lab::jsonOf(option, shot) == lab::jsonOf(option, from);
    bool elsewhere = option.name == "scene" || option.name == "size" || option.is(lab::ShotOption::kNoPicture);
    if (!alike && !elsewhere && !(left_out && left_out(option.name)))
      fields.push_back(field(option.name, optionText(option, shot)));
  }
  return fields;
}

std::vector<std::string> settingFields(const script::Settings& sets, bool of_scene, const LeftOut& left_out) {
  std::map<std::string, plan::Value> last;
  for (const script::Setting& set : sets)
    if (lab::isOfScene(set) == of_scene && !(left_out && left_out(set.first))) last[set.first] = set.second;
  std::vector<std::string> fields;
  for (const auto& [name, value] : last) fields.push_back(field(name, luaOf(value)));
  return fields;
}

}  // namespace strobe::live
