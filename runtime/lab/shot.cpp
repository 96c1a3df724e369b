// SPDX-License-Identifier: MIT
#include "lab/shot.h"

#include <algorithm>
#include <map>

#include "lab/shot_options.h"
#include "shared/frame.h"

namespace strobe::lab {

std::array<double, 2> Shot::window() const {
  double length_s = exposureSeconds();
  double before = anchor == "end" ? 1 : anchor == "centre" ? 0.5 : 0;
  return {rasterTime() - before * length_s, rasterTime() + (1 - before) * length_s};
}

uint32_t anchorCode(const std::string& anchor) {
  if (anchor == "end") return ANCHOR_END;
  return anchor == "centre" ? ANCHOR_CENTRE : ANCHOR_START;
}

void fillShot(Shot& shot, const Json& description) {
  const Json none = Json::object(), &suggested = description.contains("shot") ? description["shot"] : none;
  for (const ShotOption& option : shotOptions())
    for (const ShotField& field : option.fields) {
      if (!option.is(ShotOption::kSuggested) || !field.isOpen(shot)) continue;
      const std::string& name = field.declaration.name;
      if (name == "exposure" && shot.exposure_time >= 0) {
        shot.exposure = shot.exposure_time * shot.fps;
        continue;
      }
      field.set(shot,
                suggested.contains(name) ? plan::valueFromJson(suggested[name]) : field.declaration.default_value);
    }
}

static bool isOpen(const ShotOption& option, const Shot& shot) {
  return std::all_of(option.fields.begin(), option.fields.end(), [&](const auto& field) { return field.isOpen(shot); });
}

void checkShot(const Shot& shot) {
  Shot checked;
  for (const ShotOption& option : shotOptions())
    if (!isOpen(option, shot)) setFromJson(option, checked, jsonOf(option, shot));
}

std::string plainText(const plan::Value& value) {
  const double* number = std::get_if<double>(&value);
  return number ? fmt::format("{}", *number) : plan::textOf(value);
}

std::string plainText(const plan::ParamDesc& param, const plan::Value& value) {
  return param.has_auto && value == plan::Value(plan::kAuto) ? "auto" : plainText(value);
}

// ---- settings

bool isOfScene(const script::Setting& setting) { return setting.first.starts_with("scene."); }

script::Settings sceneSettings(const script::Settings& sets) {
  script::Settings result;
  std::copy_if(sets.begin(), sets.end(), std::back_inserter(result), isOfScene);
  return result;
}

script::Settings pipelineSettings(const script::Settings& sets) {
  script::Settings result;
  std::remove_copy_if(sets.begin(), sets.end(), std::back_inserter(result), isOfScene);
  return result;
}

void putSetting(script::Settings& sets, const std::string& name, const plan::Value& value) {
  std::erase_if(sets, [&](const auto& set) { return set.first == name; });
  sets.push_back({name, value});
}

// ---- identity

std::string settingsIdentity(const script::Settings& sets, bool of_scene) {
  std::map<std::string, std::string> last;
  for (const script::Setting& set : sets)
    if (isOfScene(set) == of_scene) last[set.first] = plan::textOf(set.second);
  return Json(last).dump();
}

// Shot with the rest frame resolved: `frame` if unset and options move nodes; unset without such options.
static Shot rested(Shot shot) {
  bool moved = !shot.moves.empty() || !shot.spins.empty();
  if (!moved) shot.rest_frame = -1;
  if (moved && shot.rest_frame < 0) shot.rest_frame = shot.frame;
  return shot;
}

static std::string identityOf(const Shot& shot, std::initializer_list<Concern> concerns) {
  Json json;
  for (const ShotOption& option : shotOptions()) {
    bool counts = std::find(concerns.begin(), concerns.end(), option.concern) != concerns.end();
    if (counts && !option.is(ShotOption::kNoPicture) && !isOpen(option, shot)) json[option.name] = jsonOf(option, shot);
  }
  return json.dump();
}

std::string sceneIdentity(const Shot& shot) {
  bool moved = !shot.moves.empty() || !shot.spins.empty();
  std::string key = identityOf(shot, {Concern::Scene}) + settingsIdentity(shot.sets, true);
  // Moves and spins have rates per frame, so fps and the rest time count.
  return moved ? key + fmt::format("|{}|{}", shot.fps, shot.restTime()) : key;
}

std::string frameIdentity(const Shot& shot) { return identityOf(rested(shot), {Concern::Frame, Concern::Motion}); }

std::string canonical(const Shot& shot) {
  return shot.pipeline + settingsIdentity(shot.sets, false) + identityOf(shot, {Concern::Plan}) + frameIdentity(shot) +
         sceneIdentity(shot);
}

// ---- record

Json toJson(const Shot& shot) {
  Json json;
  for (const ShotOption& option : shotOptions()) {
    if (option.is(ShotOption::kNoPicture) || isOpen(option, shot)) continue;
    json[option.name] = jsonOf(option, shot);
    if (option.name == "scene") json["pipeline"] = shot.pipeline;
  }
  for (const auto& [name, value] : shot.sets) json["set"][name] = plan::toJson(value);
  return json;
}

static Shot shotOf(const Json& json) {
  Shot shot;
  shot.pipeline = json.at("pipeline").get<std::string>();
  std::vector<std::string> known = {"pipeline", "set"};
  for (const ShotOption& option : shotOptions()) {
    if (option.is(ShotOption::kNoPicture)) continue;
    known.push_back(option.name);
    // A record may lack newer options. It has all suggested options, because they were resolved before it was written.
    bool required = option.is(ShotOption::kSuggested) || option.name == "scene";
    if (required || json.contains(option.name)) setFromJson(option, shot, json.at(option.name));
  }
  for (const auto& [name, value] : json.items())
    if (std::find(known.begin(), known.end(), name) == known.end())
      throw Error(fmt::format("unknown field '{}' of a shot{}", name, didYouMean(name, known)));
  if (!json.contains("set")) return shot;
  for (const auto& [name, value] : json["set"].items()) shot.sets.push_back({name, plan::valueFromJson(value)});
  return shot;
}

Shot shotFromRecord(const Path& record) {
  Json json = Json::parse(readText(record), nullptr, false);
  auto refuse = [&record](const std::string& what) { throw Error(what, {record.string()}); };
  if (!json.is_object() || !json.contains("shot")) refuse("is not a run record: it has no 'shot'");
  try {
    return shotOf(json["shot"]);
  } catch (const std::exception& error) {  // an `Error`, or an exception of the JSON library
    refuse(fmt::format("the shot of this record cannot be read: {}", error.what()));
  }
  return {};
}

// ---- command

std::string shellWord(const std::string& text) {
  const char* plain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-+=.,:/@%";
  if (!text.empty() && text.find_first_not_of(plain) == std::string::npos) return text;
  std::string result = "'";
  for (char c : text) result += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return result + "'";
}

std::string commandOf(const Shot& shot) {
  std::string line = "strobe render " + shellWord(shot.pipeline);
  for (const ShotOption& option : shotOptions()) {
    if (option.is(ShotOption::kNoPicture)) continue;
    if (option.name == "exposure" && shot.exposure_time >= 0) continue;
    std::vector<std::string> texts = textsOf(option, shot);
    if (texts.empty() && option.is(ShotOption::kSpelled)) texts = {jsonOf(option, shot).get<std::string>()};
    bool is_flag = option.fields.front().declaration.type == plan::ParamDesc::Type::Bool;
    for (const std::string& text : texts) line += " " + spelled(option) + (is_flag ? "" : " " + shellWord(text));
  }
  for (const auto& [name, value] : shot.sets) line += " --set " + shellWord(name + "=" + plan::textOf(value));
  return line + " -o out.exr";
}

void putRole(script::Settings& sets, const plan::PipelineDesc& pipeline, plan::Role role, const plan::Value& value) {
  if (const plan::ParamDesc* param = plan::paramOf(pipeline, role)) putSetting(sets, param->name, value);
}

}  // namespace strobe::lab
