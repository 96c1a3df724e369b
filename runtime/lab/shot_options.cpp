// SPDX-License-Identifier: MIT
#include "lab/shot_options.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace strobe::lab {

using plan::ParamDesc;
using plan::Value;
using Type = ParamDesc::Type;

// ---- the table

static ShotField number(const char* name, ShotMember member, Type type, double otherwise, double min, double max,
                        const char* unit) {
  ShotField field{{}, member};
  field.declaration.name = name;
  field.declaration.type = type;
  field.declaration.default_value = type == Type::Int ? Value(int64_t(otherwise)) : Value(otherwise);
  field.declaration.min = min;
  field.declaration.max = max;
  field.declaration.unit = unit;
  return field;
}

static ShotField whole(const char* name, ShotMember member, double otherwise, double min, double max,
                       const char* unit = "") {
  return number(name, member, Type::Int, otherwise, min, max, unit);
}

static ShotField real(const char* name, ShotMember member, double otherwise, double min, double max, const char* unit) {
  return number(name, member, Type::Float, otherwise, min, max, unit);
}

// One of some choices; of none, any text.
static ShotField text(const char* name, ShotMember member, const char* otherwise,
                      const std::vector<std::string>& choices = {}) {
  ShotField field{{}, member};
  field.declaration.name = name;
  field.declaration.type = Type::Choice;
  field.declaration.default_value = std::string(otherwise);
  field.declaration.choices = choices;
  field.declaration.variant = true;
  return field;
}

static std::vector<ShotOption> allOptions() {
  using S = Shot;
  using O = ShotOption;
  constexpr double kSide = 16384, kLastFrame = 2147483647;
  return {
      {"scene",
       "a name of scripts/scenes, a .lua, .glb or .gltf file",
       Concern::Scene,
       {text("scene", &S::scene, "living_room")},
       O::kSpelled},
      {"size",
       "WIDTHxHEIGHT in pixels",
       Concern::Plan,
       {whole("width", &S::width, 960, 1, kSide, "px"), whole("height", &S::height, 540, 1, kSide, "px")},
       O::kSuggested | O::kControl},
      {"fps",
       "frames per second",
       Concern::Motion,
       {real("fps", &S::fps, 24, 1e-3, 1e6, "1/s")},
       O::kSuggested | O::kControl},
      {"frame",
       "the capture is at frame / fps seconds",
       Concern::Motion,
       {whole("frame", &S::frame, 1, 0, kLastFrame)},
       O::kSuggested | O::kControl},
      {"exposure",
       "time the shutter is open, as a share of the frame interval",
       Concern::Frame,
       {real("exposure", &S::exposure, 0.5, 0, 1000, "frames")},
       O::kSuggested | O::kControl},
      {"anchor",
       "where the exposure lies: it ends at the capture, is centred on it, or opens at it",
       Concern::Frame,
       {text("anchor", &S::anchor, "close", {"close", "centre", "open"})},
       O::kSpelled | O::kControl},
      {"camera",
       "a camera of the scene (default: its first)",
       Concern::Scene,
       {text("camera", &S::camera, "")},
       O::kControl},
      {"view",
       "EX,EY,EZ,TX,TY,TZ: camera at E, looking at T, instead of its pose in the scene",
       Concern::Frame,
       {text("view", &S::view, "")}},
      {"animation",
       "a clip of the scene, all or none",
       Concern::Frame,
       {text("animation", &S::animation, "all")},
       O::kControl},
      {"move", "NODE=dx,dy,dz: metres per frame in world axes", Concern::Scene, {text("move", &S::moves, "")}},
      {"spin", "NODE=ax,ay,az,deg: degrees per frame about an axis", Concern::Scene, {text("spin", &S::spins, "")}},
      {"rest_frame",
       "frame at which --move and --spin are at rest (default: --frame)",
       Concern::Motion,
       {whole("rest_frame", &S::rest_frame, 0, 0, kLastFrame)}},
      {"aa",
       "sub-pixel samples of a saved picture, each a full run of the pipeline",
       Concern::Frame,
       {whole("aa", &S::aa, 1, 1, 256)},
       O::kControl},
      {"seed", "of every random number", Concern::Frame, {whole("seed", &S::seed, 0, 0, 4294967295.0)}, O::kControl},
      {"backend",
       "how rays are traced: ray queries where there are, or ray tracing pipelines",
       Concern::Plan,
       {text("backend", &S::backend, "auto", {"auto", "pipeline", "query"})},
       O::kControl},
      {"device",
       "index or part of the name of a Vulkan device",
       Concern::Device,
       {text("device", &S::device, "")},
       O::kNoPicture},
      {"tap", "NODE.PORT to write as well", Concern::Plan, {text("tap", &S::taps, "")}, O::kNoPicture},
  };
}

const std::vector<ShotOption>& shotOptions() {
  static const std::vector<ShotOption> options = [] {
    std::vector<ShotOption> all = allOptions();
    for (ShotOption& option : all)
      for (ShotField& field : option.fields) field.declaration.doc = option.doc;
    return all;
  }();
  return options;
}

const ShotOption* findShotOption(const std::string& name) {
  for (const ShotOption& option : shotOptions())
    if (option.name == name) return &option;
  return nullptr;
}

// ---- values

template <class Type>
static constexpr bool is(const ShotMember& member) {
  return std::holds_alternative<Type Shot::*>(member);
}

static bool isView(const ShotMember& member) { return is<View>(member); }
static bool isList(const ShotMember& member) { return is<std::vector<std::string>>(member); }

bool ShotField::isValue() const { return !isView(member) && !isList(member); }

Value ShotField::get(const Shot& shot) const {
  if (const auto* at = std::get_if<int Shot::*>(&member)) return int64_t(shot.**at);
  if (const auto* at = std::get_if<uint32_t Shot::*>(&member)) return int64_t(shot.**at);
  if (const auto* at = std::get_if<double Shot::*>(&member)) return shot.**at;
  return shot.*std::get<std::string Shot::*>(member);
}

void ShotField::set(Shot& shot, const Value& value) const {
  if (const auto* at = std::get_if<std::string Shot::*>(&member)) {
    bool any = declaration.choices.empty();
    shot.** at = plan::textOf(any ? value : plan::checkValue(declaration, value, {}));
    return;
  }
  Value checked = plan::checkValue(declaration, value, {});
  if (const auto* at = std::get_if<int Shot::*>(&member)) shot.** at = int(std::get<int64_t>(checked));
  if (const auto* at = std::get_if<uint32_t Shot::*>(&member)) shot.** at = uint32_t(std::get<int64_t>(checked));
  if (const auto* at = std::get_if<double Shot::*>(&member)) shot.** at = std::get<double>(checked);
}

bool ShotField::isOpen(const Shot& shot) const {
  if (const auto* at = std::get_if<View Shot::*>(&member)) return !(shot.**at).has_value();
  if (!isValue() || !declaration.min) return false;
  Value value = get(shot);
  double number = declaration.type == Type::Int ? double(std::get<int64_t>(value)) : std::get<double>(value);
  return value == get(Shot()) && number < *declaration.min;
}

std::vector<scene::Suggestion> suggestions() {
  std::vector<scene::Suggestion> list;
  for (const ShotOption& option : shotOptions())
    for (const ShotField& field : option.fields) {
      const ParamDesc& one = field.declaration;
      if (option.is(ShotOption::kSuggested)) list.push_back({one.name, one.type == Type::Int, *one.min, *one.max});
    }
  return list;
}

// ---- as JSON

static Json toJson(const ShotField& field, const Shot& shot) {
  if (const auto* at = std::get_if<View Shot::*>(&field.member)) return shot.**at ? Json(*(shot.**at)) : Json();
  if (const auto* at = std::get_if<std::vector<std::string> Shot::*>(&field.member)) return shot.**at;
  return plan::toJson(field.get(shot));
}

Json jsonOf(const ShotOption& option, const Shot& shot) {
  if (option.fields.size() == 1) return toJson(option.fields.front(), shot);
  Json list = Json::array();
  for (const ShotField& field : option.fields) list.push_back(toJson(field, shot));
  return list;
}

bool ShotOption::isGiven(const Shot& shot) const { return jsonOf(*this, shot) != jsonOf(*this, Shot()); }

std::string spelled(const ShotOption& option) {
  std::string name = "--" + option.name;
  std::replace(name.begin(), name.end(), '_', '-');
  return name;
}

// Its mistakes name the option as the command line does.
static void setField(const ShotOption& option, const ShotField& field, Shot& shot, const Value& value) {
  ShotField named = field;
  named.declaration.name = spelled(option);
  try {
    named.set(shot, value);
  } catch (const Error& error) {
    throw Error(error.message(), {}, 2);
  }
}

static std::array<double, 6> viewFrom(const std::array<double, 6>& view, const std::string& text) {
  bool finite = std::all_of(view.begin(), view.end(), [](double number) { return std::isfinite(number); });
  if (finite && (view[0] != view[3] || view[1] != view[4] || view[2] != view[5])) return view;
  throw Error(fmt::format("--view '{}' is not ex,ey,ez,tx,ty,tz: where the camera is, and another point", text), {}, 2);
}

void setFromJson(const ShotOption& option, Shot& shot, const Json& value) {
  auto refuse = [&](const char* what) {
    throw Error(fmt::format("{} = {} is not {}", spelled(option), value.dump(), what), {}, 2);
  };
  const ShotMember& member = option.fields.front().member;
  try {
    if (const auto* at = std::get_if<View Shot::*>(&member)) {
      if (value.is_null()) return (shot.**at).reset();
      shot.** at = viewFrom(value.get<std::array<double, 6>>(), value.dump());
    } else if (const auto* list = std::get_if<std::vector<std::string> Shot::*>(&member)) {
      shot.** list = value.get<std::vector<std::string>>();
    } else if (option.fields.size() == 1) {
      setField(option, option.fields.front(), shot, plan::valueFromJson(value));
    } else {
      if (!value.is_array() || value.size() != option.fields.size()) refuse("a list of as many numbers");
      for (size_t i = 0; i < option.fields.size(); ++i)
        setField(option, option.fields[i], shot, plan::valueFromJson(value[i]));
    }
  } catch (const Json::exception&) {
    refuse("of its form");
  }
}

// ---- as text

static std::string textOfField(const ShotField& field, const Shot& shot) {
  Value value = field.get(shot);
  const double* number = std::get_if<double>(&value);
  return number ? fmt::format("{}", *number) : plan::textOf(value);
}

std::vector<std::string> textsOf(const ShotOption& option, const Shot& shot) {
  if (!option.isGiven(shot)) return {};
  const ShotMember& member = option.fields.front().member;
  if (const auto* at = std::get_if<View Shot::*>(&member)) return {viewText(*(shot.**at))};
  if (const auto* list = std::get_if<std::vector<std::string> Shot::*>(&member)) return shot.**list;
  std::vector<std::string> texts;
  for (const ShotField& field : option.fields) texts.push_back(textOfField(field, shot));
  return {fmt::format("{}", fmt::join(texts, "x"))};
}

void setFromTexts(const ShotOption& option, Shot& shot, const std::vector<std::string>& texts) {
  const ShotMember& member = option.fields.front().member;
  if (const auto* list = std::get_if<std::vector<std::string> Shot::*>(&member)) {
    shot.** list = texts;
  } else if (const auto* at = std::get_if<View Shot::*>(&member)) {
    (shot.**at).reset();
    if (!texts.empty() && !texts.back().empty()) shot.** at = parseView(texts.back());
  } else if (!texts.empty() && option.fields.size() > 1) {
    setFromJson(option, shot, parseSize(texts.back(), spelled(option)));
  } else if (!texts.empty()) {
    setField(option, option.fields.front(), shot, texts.back());
  }
}

std::array<double, 6> parseView(const std::string& text) {
  std::array<double, 6> view{};
  const char* at = text.data();
  const char* end = at + text.size();
  bool ok = true;
  for (size_t i = 0; i < 6 && ok; ++i) {
    auto [after, error] = std::from_chars(at, end, view[i]);
    ok = error == std::errc() && (i == 5 ? after == end : after != end && *after == ',');
    at = after + 1;
  }
  return viewFrom(ok ? view : std::array<double, 6>{}, text);
}

std::string viewText(const std::array<double, 6>& view) { return fmt::format("{}", fmt::join(view, ",")); }

std::array<int, 2> parseSize(const std::string& text, const std::string& option) {
  int width = 0, height = 0;
  const char* end = text.data() + text.size();
  auto [after_width, first_error] = std::from_chars(text.data(), end, width);
  bool ok = first_error == std::errc() && after_width != end && *after_width == 'x';
  if (ok) {
    auto [after_height, second_error] = std::from_chars(after_width + 1, end, height);
    ok = second_error == std::errc() && after_height == end;
  }
  const ParamDesc& side = findShotOption("size")->fields.front().declaration;
  auto fits = [&](int pixels) { return pixels >= *side.min && pixels <= *side.max; };
  if (!ok || !fits(width) || !fits(height))
    throw Error(
        fmt::format("{} '{}' is not WIDTHxHEIGHT with {} to {} pixels each", option, text, *side.min, *side.max), {},
        2);
  return {width, height};
}

// ---- for scripts

static const char* typeName(const ShotOption& option) {
  const ShotField& field = option.fields.front();
  if (option.fields.size() > 1) return "size";
  if (isView(field.member)) return "view";
  if (isList(field.member)) return "texts";
  if (field.declaration.type == Type::Int) return "integer";
  if (field.declaration.type == Type::Float) return "number";
  return field.declaration.choices.empty() ? "text" : "choice";
}

Json shotOptionsJson() {
  Json list = Json::array();
  for (const ShotOption& option : shotOptions()) {
    const ParamDesc& declaration = option.fields.front().declaration;
    Json json = {{"name", option.name}, {"type", typeName(option)}, {"doc", option.doc}};
    if (declaration.min) json["min"] = *declaration.min;
    if (declaration.max) json["max"] = *declaration.max;
    if (!declaration.choices.empty()) json["choices"] = declaration.choices;
    list.push_back(std::move(json));
  }
  return list;
}

}  // namespace strobe::lab
