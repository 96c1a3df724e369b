// SPDX-License-Identifier: MIT
#include "lab/shot_data.h"

#include <cctype>
#include <filesystem>

#include "lab/shot_options.h"

namespace strobe::lab {

script::Settings settingsFrom(const Json& json, const char* name, const std::string& prefix) {
  script::Settings sets;
  if (!json.contains(name)) return sets;
  for (const Json& one : json.at(name))
    sets.emplace_back(prefix + one.at("name").get<std::string>(), plan::valueFromJson(one.at("value")));
  return sets;
}

Arm armFrom(const Json& json, const Path& script) {
  return {json.value("name", ""), besideScript(script, json.at("pipeline").get<std::string>()),
          settingsFrom(json, "set")};
}

void setOptions(Shot& shot, const Json& options) {
  for (const Json& one : options) {
    const ShotOption* option = findShotOption(one.at("name").get<std::string>());
    if (option) setFromJson(*option, shot, one.at("value"));
  }
}

std::string besideScript(const Path& script, const std::string& name) {
  bool is_file = hasExtension(name, ".lua") || hasExtension(name, ".glb") || hasExtension(name, ".gltf");
  Path beside = script.parent_path() / name;
  return is_file && Path(name).is_relative() && std::filesystem::exists(beside) ? beside.string() : name;
}

SceneFile sceneFile(const Home& home, const std::string& scene) {
  const std::string prefix = Home::kSharedPrefix;
  if (!scene.starts_with(prefix)) return {scene, "", ""};
  std::string name = scene.substr(prefix.size());
  std::optional<Path> data = home.data();
  if (!data)
    return {scene, name,
            fmt::format("'{}' is in the shared data, which is missing; set STROBE_DATA to its folder", name)};
  if (!std::filesystem::exists(*data / name)) return {scene, name, fmt::format("the shared data has no '{}'", name)};
  return {(*data / name).string(), name, ""};
}

image::ToneMap toneFrom(const Json& json) {
  image::ToneMap tone;
  tone.stops = json.value("stops", 0.0f);
  if (json.value("curve", "") == "filmic") tone.curve = image::ToneMap::Curve::filmic;
  return tone;
}

std::vector<int> framesFrom(const Json& json) {
  std::vector<int> frames;
  if (!json.contains("frames")) return frames;
  std::array<int, 3> range = json["frames"].get<std::array<int, 3>>();
  for (int frame = range[0]; frame <= range[1]; frame += range[2]) frames.push_back(frame);
  return frames;
}

std::string fileNameOf(const std::string& label) {
  std::string name;
  for (unsigned char c : label) {
    if (std::isalnum(c)) name += char(std::tolower(c));
    else if (!name.empty() && name.back() != '_') name += '_';
  }
  while (!name.empty() && name.back() == '_') name.pop_back();
  return name.empty() ? "unnamed" : name;
}

}  // namespace strobe::lab
