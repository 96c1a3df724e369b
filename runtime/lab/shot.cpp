// SPDX-License-Identifier: MIT
#include "lab/shot.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "shared/frame.h"

namespace strobe::lab {

static const std::vector<std::string> kAnchors = {"close", "centre", "open"};
static const std::vector<std::string> kBackends = {"auto", "pipeline", "query"};

std::array<double, 2> Shot::window() const {
  double length_s = exposure / fps;
  double before = anchor == "close" ? 1 : anchor == "centre" ? 0.5 : 0;
  return {captureTime() - before * length_s, captureTime() + (1 - before) * length_s};
}

static void requireOneOf(const char* option, const std::string& value, const std::vector<std::string>& allowed) {
  if (std::find(allowed.begin(), allowed.end(), value) != allowed.end()) return;
  throw Error(
      fmt::format("{} '{}' is none of {}{}", option, value, fmt::join(allowed, ", "), didYouMean(value, allowed)), {},
      2);
}

void checkShot(const Shot& shot) {
  auto refuse = [](const std::string& text) { throw Error(text, {}, 2); };
  requireOneOf("--anchor", shot.anchor, kAnchors);
  requireOneOf("--backend", shot.backend, kBackends);
  if (!(shot.fps > 0 && shot.fps <= 1e6)) refuse(fmt::format("--fps {} is not above 0 and at most 1000000", shot.fps));
  if (!(shot.exposure >= 0 && shot.exposure <= 1000))
    refuse(fmt::format("--exposure {} is not in 0 to 1000 frames", shot.exposure));
  if (shot.aa < 1 || shot.aa > 256) refuse(fmt::format("--aa {} is not in 1 to 256", shot.aa));
}

Json toJson(const Shot& shot) {
  Json json;
  json["scene"] = shot.scene;
  json["pipeline"] = shot.pipeline;
  json["size"] = {shot.width, shot.height};
  json["fps"] = shot.fps;
  json["frame"] = shot.frame;
  json["exposure"] = shot.exposure;
  json["anchor"] = shot.anchor;
  json["camera"] = shot.camera;
  if (shot.view) json["view"] = *shot.view;
  json["animation"] = shot.animation;
  json["move"] = shot.moves;
  json["spin"] = shot.spins;
  if (shot.rest_frame >= 0) json["rest_frame"] = shot.rest_frame;
  json["aa"] = shot.aa;
  json["seed"] = shot.seed;
  json["backend"] = shot.backend;
  for (const auto& [name, value] : shot.sets) json["set"][name] = value;
  return json;
}

Shot shotFromRecord(const Path& record) {
  Json json = Json::parse(readText(record), nullptr, false);
  auto refuse = [&record](const std::string& what) { throw Error(what, {record.string()}); };
  if (json.is_object() && json.contains("shot")) json = json["shot"];
  else refuse("is no run record: it has no 'shot'");
  Shot shot;
  try {
    shot.scene = json.at("scene").get<std::string>();
    shot.pipeline = json.at("pipeline").get<std::string>();
    shot.width = json.at("size").at(0).get<int>();
    shot.height = json.at("size").at(1).get<int>();
    shot.fps = json.at("fps").get<double>();
    shot.frame = json.at("frame").get<int>();
    shot.exposure = json.at("exposure").get<double>();
    shot.anchor = json.at("anchor").get<std::string>();
    shot.camera = json.at("camera").get<std::string>();
    shot.animation = json.at("animation").get<std::string>();
    shot.moves = json.at("move").get<std::vector<std::string>>();
    shot.spins = json.at("spin").get<std::vector<std::string>>();
    shot.aa = json.at("aa").get<int>();
    shot.seed = json.at("seed").get<uint32_t>();
    shot.backend = json.at("backend").get<std::string>();
    if (json.contains("view")) shot.view = json["view"].get<std::array<double, 6>>();
    if (json.contains("rest_frame")) shot.rest_frame = json["rest_frame"].get<int>();
    if (json.contains("set"))
      for (const auto& [name, value] : json["set"].items()) shot.sets.push_back({name, value.get<std::string>()});
  } catch (const Json::exception& error) {
    refuse(fmt::format("the shot of this record cannot be read: {}", error.what()));
  }
  checkShot(shot);
  return shot;
}

// As a shell reads it back, quoted where it would not be taken as it stands.
static std::string quoted(const std::string& text) {
  const char* plain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-+=.,:/@%";
  if (!text.empty() && text.find_first_not_of(plain) == std::string::npos) return text;
  std::string result = "'";
  for (char c : text) result += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return result + "'";
}

std::string commandOf(const Shot& shot) {
  std::string line = fmt::format("strobe render {} --scene {}", quoted(shot.pipeline), quoted(shot.scene));
  auto add = [&line](const char* option, const std::string& value) {
    line += fmt::format(" {} {}", option, quoted(value));
  };
  if (shot.width) add("--size", fmt::format("{}x{}", shot.width, shot.height));
  if (shot.fps > 0) add("--fps", fmt::format("{}", shot.fps));
  if (shot.frame >= 0) add("--frame", fmt::format("{}", shot.frame));
  if (shot.exposure >= 0) add("--exposure", fmt::format("{}", shot.exposure));
  add("--anchor", shot.anchor);
  if (!shot.camera.empty()) add("--camera", shot.camera);
  if (shot.view) add("--view", viewText(*shot.view));
  if (shot.animation != "all") add("--animation", shot.animation);
  for (const std::string& move : shot.moves) add("--move", move);
  for (const std::string& spin : shot.spins) add("--spin", spin);
  if (shot.rest_frame >= 0 && shot.rest_frame != shot.frame) add("--rest-frame", fmt::format("{}", shot.rest_frame));
  if (shot.aa != 1) add("--aa", fmt::format("{}", shot.aa));
  if (shot.seed) add("--seed", fmt::format("{}", shot.seed));
  if (shot.backend != "auto") add("--backend", shot.backend);
  for (const auto& [name, value] : shot.sets) add("--set", name + "=" + value);
  return line + " -o out.exr";
}

void putSetting(script::Settings& sets, const std::string& name, const std::string& value) {
  std::erase_if(sets, [&](const auto& set) { return set.first == name; });
  sets.push_back({name, value});
}

// ---- options as declarations

static plan::ParamDesc number(const char* name, plan::ParamDesc::Type type, double min, double max, const char* unit,
                              const char* doc) {
  plan::ParamDesc param;
  param.name = name;
  param.type = type;
  param.min = min;
  param.max = max;
  param.unit = unit;
  param.doc = doc;
  return param;
}

static plan::ParamDesc choice(const char* name, const std::vector<std::string>& choices, const char* doc) {
  plan::ParamDesc param;
  param.name = name;
  param.type = plan::ParamDesc::Type::Choice;
  param.choices = choices;
  param.doc = doc;
  param.variant = true;
  return param;
}

static int whole(const plan::Value& value) { return int(std::get<int64_t>(value)); }

const std::vector<ShotOption>& shotOptions() {
  using plan::Value;
  constexpr auto kInt = plan::ParamDesc::Type::Int, kFloat = plan::ParamDesc::Type::Float;
  static const std::vector<ShotOption> options = {
      {number("frame", kInt, 0, 1000000, "", "the capture is at frame / fps seconds"),
       [](const Shot& shot) -> Value { return int64_t(shot.frame); },
       [](Shot& shot, const Value& value) { shot.frame = whole(value); }},
      {number("fps", kFloat, 1e-3, 1e6, "1/s", "frames per second"), [](const Shot& shot) -> Value { return shot.fps; },
       [](Shot& shot, const Value& value) { shot.fps = std::get<double>(value); }},
      {number("exposure", kFloat, 0, 1000, "frames", "time the shutter is open, as a share of the frame interval"),
       [](const Shot& shot) -> Value { return shot.exposure; },
       [](Shot& shot, const Value& value) { shot.exposure = std::get<double>(value); }},
      {choice("anchor", kAnchors, "where the exposure lies: it ends at the capture, is centred on it, or opens at it"),
       [](const Shot& shot) -> Value { return shot.anchor; },
       [](Shot& shot, const Value& value) { shot.anchor = std::get<std::string>(value); }},
      {choice("camera", {}, "a camera of the scene"), [](const Shot& shot) -> Value { return shot.camera; },
       [](Shot& shot, const Value& value) { shot.camera = std::get<std::string>(value); }},
      {choice("animation", {}, "a clip of the scene, all or none"),
       [](const Shot& shot) -> Value { return shot.animation; },
       [](Shot& shot, const Value& value) { shot.animation = std::get<std::string>(value); }},
      {number("width", kInt, 1, 16384, "px", "of the picture"),
       [](const Shot& shot) -> Value { return int64_t(shot.width); },
       [](Shot& shot, const Value& value) { shot.width = whole(value); }},
      {number("height", kInt, 1, 16384, "px", "of the picture"),
       [](const Shot& shot) -> Value { return int64_t(shot.height); },
       [](Shot& shot, const Value& value) { shot.height = whole(value); }},
      {number("aa", kInt, 1, 256, "", "sub-pixel samples of a saved picture, each a full run of the pipeline"),
       [](const Shot& shot) -> Value { return int64_t(shot.aa); },
       [](Shot& shot, const Value& value) { shot.aa = whole(value); }},
      {number("seed", kInt, 0, 4294967295.0, "", "of every random number"),
       [](const Shot& shot) -> Value { return int64_t(shot.seed); },
       [](Shot& shot, const Value& value) { shot.seed = uint32_t(std::get<int64_t>(value)); }},
      {choice("backend", kBackends, "how rays are traced: ray queries where there are, or ray tracing pipelines"),
       [](const Shot& shot) -> Value { return shot.backend; },
       [](Shot& shot, const Value& value) { shot.backend = std::get<std::string>(value); }},
  };
  return options;
}

std::array<double, 6> parseView(const std::string& text) {
  std::array<double, 6> view{};
  const char* at = text.data();
  const char* end = at + text.size();
  bool ok = true;
  for (size_t i = 0; i < 6 && ok; ++i) {
    auto [after, error] = std::from_chars(at, end, view[i]);
    ok = error == std::errc() && std::isfinite(view[i]) && (i == 5 ? after == end : after != end && *after == ',');
    at = after + 1;
  }
  ok = ok && (view[0] != view[3] || view[1] != view[4] || view[2] != view[5]);
  if (!ok)
    throw Error(fmt::format("--view '{}' is not ex,ey,ez,tx,ty,tz: where the camera is, and another point", text), {},
                2);
  return view;
}

std::string viewText(const std::array<double, 6>& view) { return fmt::format("{}", fmt::join(view, ",")); }

uint32_t anchorCode(const std::string& anchor) {
  if (anchor == "close") return ANCHOR_CLOSE;
  return anchor == "centre" ? ANCHOR_CENTRE : ANCHOR_OPEN;
}

std::array<int, 2> parseSize(const std::string& text, const std::string& option) {
  int width = 0, height = 0;
  const char* end = text.data() + text.size();
  auto [after_width, first_error] = std::from_chars(text.data(), end, width);
  bool ok = first_error == std::errc() && after_width != end && *after_width == 'x';
  if (ok) {
    auto [after_height, second_error] = std::from_chars(after_width + 1, end, height);
    ok = second_error == std::errc() && after_height == end;
  }
  ok = ok && width >= 1 && height >= 1 && width <= 16384 && height <= 16384;
  if (!ok) throw Error(fmt::format("{} '{}' is not WIDTHxHEIGHT with 1 to 16384 pixels each", option, text), {}, 2);
  return {width, height};
}

}  // namespace strobe::lab
