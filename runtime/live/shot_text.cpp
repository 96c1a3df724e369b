// SPDX-License-Identifier: MIT
#include "live/shot_text.h"

#include <algorithm>
#include <map>

#include "script/lua_text.h"

namespace strobe::live {

using script::field, script::luaOf, script::tableOf;

namespace {

std::string spaced(const std::string& numbers) {
  std::string result;
  for (char c : numbers) result += c == ',' ? ", " : std::string(1, c);
  return result;
}

// Splits "NAME=x,y,z" of the command line at the last '='.
std::pair<std::string, std::string> assigned(const std::string& text) {
  size_t at = std::min(text.rfind('='), text.size());
  return {text.substr(0, at), spaced(text.substr(std::min(at + 1, text.size())))};
}

// Motions and camera paths are lists of texts in JSON, and tables in Lua.
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

lab::Shot suggestedShot(const Home& home, const lab::Shot& shot, const script::Limits& limits) {
  lab::Shot suggested;
  suggested.scene = shot.scene;
  suggested.sets = lab::sceneSettings(shot.sets);
  Json none = Json::object();
  lab::fillShot(suggested, lab::isGltf(shot.scene)
                               ? none
                               : script::evaluateScene(home, shot.scene, suggested.sets, nullptr, limits));
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
