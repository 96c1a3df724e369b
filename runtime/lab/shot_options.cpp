// SPDX-License-Identifier: MIT
#include "lab/shot_options.h"

#include <algorithm>
#include <cmath>

#include "base/numbers.h"
#include "gpu/choice.h"
#include "lab/camera_path.h"
#include "math/shutter_curve.h"
#include "plan/named.h"
#include "scene/depth_bounds.h"
#include "scene/motion.h"
#include "shader/backends.h"

namespace strobe::lab {

using plan::ParamDesc;
using plan::Value;
using Type = ParamDesc::Type;

constexpr double kMostFrames = 1000;  // longest exposure, frame intervals

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

// A choice; any text if `choices` is empty.
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

static ShotField checked(ShotField field, void (*check)(const std::string&)) {
  field.check = check;
  return field;
}

static void checkCurve(const std::string& text) { ShutterCurve::from(text); }

static void checkDepths(const std::string& text) {
  if (!text.empty()) scene::DepthBounds::from(text);
}

static void checkCuts(const std::string& text) { scene::cutsFromOption(text); }

static ShotField flag(const char* name, ShotMember member) {
  ShotField field{{}, member};
  field.declaration.name = name;
  field.declaration.type = Type::Bool;
  field.declaration.default_value = false;
  return field;
}

static std::vector<std::string> backendNames() {
  std::vector<std::string> names = {"auto"};
  for (const shader::BackendRow& row : shader::backends()) names.push_back(row.name);
  return names;
}

static std::string backendDoc() {
  std::string text = "method of ray tracing: ";
  for (const shader::BackendRow& row : shader::backends()) text += fmt::format("{}, {}; ", row.name, row.doc);
  return text + "auto: query on a hardware device with ray queries, otherwise bvh";
}

// Option with one field of the same name.
static ShotOption one(const ShotField& field, const std::string& doc, Concern concern, uint32_t uses = 0) {
  return {field.declaration.name, doc, concern, {field}, uses};
}

static std::vector<ShotOption> allOptions() {
  using S = Shot;
  using O = ShotOption;
  constexpr double kSide = plan::kMaxSide, kLastFrame = 2147483647;
  return {
      one(text("scene", &S::scene, "living_room"), "name of a scene in scripts/scenes, or a .lua, .glb or .gltf file",
          Concern::Scene, O::kSpelled),
      {"size",
       "WIDTHxHEIGHT in pixels",
       Concern::Plan,
       {whole("width", &S::width, 960, 1, kSide, "px"), whole("height", &S::height, 540, 1, kSide, "px")},
       O::kSuggested | O::kControl},
      one(real("fps", &S::fps, 24, 1e-3, 1e6, "frames/s"), "frames per second of the clip", Concern::Motion,
          O::kSuggested | O::kControl),
      one(whole("frame", &S::frame, 1, 0, kLastFrame), "number of the frame; its raster time is frame / fps seconds",
          Concern::Motion, O::kSuggested | O::kControl),
      one(real("exposure", &S::exposure, 0.5, 0, kMostFrames, "frames"),
          "time the shutter is open, as a share of the frame interval", Concern::Frame, O::kSuggested | O::kControl),
      one(real("exposure_time", &S::exposure_time, 0, 0, 1e6, "s"),
          "time the shutter is open, seconds, independent of --fps; replaces --exposure", Concern::Frame, O::kControl),
      one(text("anchor", &S::anchor, "end", {"end", "centre", "start"}),
          "raster time within the exposure: its end, its centre, or its start", Concern::Frame,
          O::kSpelled | O::kControl),
      one(checked(text("shutter_curve", &S::shutter_curve, "box"), checkCurve),
          "weight of each time of the exposure: box, triangle, trapezoid:OPENING,CLOSING, gaussian:SIGMA (shares "
          "of the exposure), or weights from opening to closing: 0,1,1,0.5 or TIME=WEIGHT,...",
          Concern::Frame, O::kControl),
      one(real("camera_blur", &S::camera_blur, 1, 0, 1, ""), "share of the camera's motion that blurs", Concern::Frame,
          O::kControl),
      one(real("object_blur", &S::object_blur, 1, 0, 1, ""), "share of the motion of objects and lights that blurs",
          Concern::Frame, O::kControl),
      one(text("follow", &S::follow, ""), "node that blurs like the camera, with all nodes below it", Concern::Frame,
          O::kControl),
      one(checked(text("motion_depths", &S::motion_depths, ""), checkDepths),
          "NEAR,FAR[,SOFT]: range of view depths that blur, metres. Surfaces outside the range at the raster time "
          "are static on the screen; within SOFT of the range they keep a share of their motion",
          Concern::Frame, O::kControl),
      one(checked(text("cuts", &S::cuts, ""), checkCuts),
          "T,T,...: times of cuts in addition to the cuts of the scene, seconds of scene time, increasing. No frame "
          "blurs over a cut",
          Concern::Frame, O::kControl),
      one(text("camera", &S::camera, ""), "a camera of the scene (default: its first)", Concern::Scene, O::kControl),
      one(text("view", &S::view, ""), "EX,EY,EZ,TX,TY,TZ: camera at E, looking at T, instead of its pose in the scene",
          Concern::Frame),
      one(text("path", &S::path, ""),
          "FRAME=EX,EY,EZ,TX,TY,TZ: key of a moving camera, at E and looking at T (--view: a static camera)",
          Concern::Frame),
      one(text("animation", &S::animation, "all"), "a clip of the scene, all or none", Concern::Frame, O::kControl),
      one(text("variant", &S::variant, ""), "a variant of a glTF scene's materials (KHR_materials_variants)",
          Concern::Scene),
      one(text("faces", &S::faces, "material", {"material", "both"}),
          "visible sides of surfaces: the sides that the materials declare, or both", Concern::Scene, O::kControl),
      one(text("move", &S::moves, ""), "NODE=dx,dy,dz: metres per frame in world axes", Concern::Scene),
      one(text("spin", &S::spins, ""), "NODE=ax,ay,az,deg: degrees per frame about an axis", Concern::Scene),
      one(flag("allow_outside", &S::allow_outside), "files that the scene refers to may lie outside its folder",
          Concern::Scene),
      one(whole("rest_frame", &S::rest_frame, 0, 0, kLastFrame),
          "frame without displacement by --move and --spin (default: --frame)", Concern::Motion),
      one(whole("aa", &S::aa, 1, 1, 256), "sub-pixel samples of a saved picture, each a full run of the pipeline",
          Concern::Frame, O::kControl),
      one(whole("seed", &S::seed, 0, 0, 4294967295.0), "seed of all random numbers", Concern::Frame, O::kControl),
      one(text("backend", &S::backend, "auto", backendNames()), backendDoc(), Concern::Plan, O::kControl),
      one(flag("model_everything", &S::model_everything),
          "also run the passes that the scene of the frame does not require; changes no picture", Concern::Plan,
          O::kControl),
      one(text("device", &S::device, ""), gpu::kDeviceHelp, Concern::Device, O::kNoPicture),
      one(text("tap", &S::taps, ""), "NODE.PORT: an additional image to write", Concern::Plan, O::kNoPicture),
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

const ShotOption* findShotOption(const std::string& name) { return plan::find(shotOptions(), name); }

// ---- values

template <class Type>
static constexpr bool is(const ShotMember& member) {
  return std::holds_alternative<Type Shot::*>(member);
}

static bool isView(const ShotMember& member) { return is<View>(member); }
static bool isList(const ShotMember& member) { return is<std::vector<std::string>>(member); }

bool ShotField::isValue() const { return !isView(member) && !isList(member); }

Value ShotField::get(const Shot& shot) const {
  if (const auto* at = std::get_if<bool Shot::*>(&member)) return shot.**at;
  if (const auto* at = std::get_if<int Shot::*>(&member)) return int64_t(shot.**at);
  if (const auto* at = std::get_if<uint32_t Shot::*>(&member)) return int64_t(shot.**at);
  if (const auto* at = std::get_if<double Shot::*>(&member)) return shot.**at;
  return shot.*std::get<std::string Shot::*>(member);
}

// Keeps `exposure` and `exposure_time` consistent. Setting `exposure` unsets `exposure_time`. While `exposure_time` is
// set, `exposure` is computed from it.
static void settleExposure(const ShotMember& member, Shot& shot) {
  const auto* set = std::get_if<double Shot::*>(&member);
  if (!set || (*set != &Shot::exposure && *set != &Shot::exposure_time && *set != &Shot::fps)) return;
  if (*set == &Shot::exposure) shot.exposure_time = Shot().exposure_time;
  if (shot.exposure_time < 0) return;
  shot.exposure = shot.fps > 0 ? shot.exposure_time * shot.fps : Shot().exposure;
  if (shot.exposure <= kMostFrames) return;
  throw Error(fmt::format("--exposure-time {} is {:.6g} frame intervals at {} frames per second, above max {}",
                          shot.exposure_time, shot.exposure, shot.fps, kMostFrames),
              {}, 2);
}

void ShotField::set(Shot& shot, const Value& value) const {
  if (const auto* at = std::get_if<std::string Shot::*>(&member)) {
    bool any = declaration.choices.empty();
    std::string text = plan::textOf(any ? value : plan::checkValue(declaration, value, {}));
    if (check) check(text);
    shot.** at = text;
    return;
  }
  Value checked = plan::checkValue(declaration, value, {});
  if (const auto* at = std::get_if<bool Shot::*>(&member)) shot.** at = std::get<bool>(checked);
  if (const auto* at = std::get_if<int Shot::*>(&member)) shot.** at = int(std::get<int64_t>(checked));
  if (const auto* at = std::get_if<uint32_t Shot::*>(&member)) shot.** at = uint32_t(std::get<int64_t>(checked));
  if (const auto* at = std::get_if<double Shot::*>(&member)) shot.** at = std::get<double>(checked);
  settleExposure(member, shot);
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

// Sets a field. Error messages spell the option as on the command line.
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
  throw Error(
      fmt::format("--view '{}' is not ex,ey,ez,tx,ty,tz: the position of the camera, and a different point to look at",
                  text),
      {}, 2);
}

static void setList(std::vector<std::string> Shot::*list, Shot& shot, const std::vector<std::string>& texts) {
  if (list == &Shot::path) cameraKeys(texts);  // throws for an invalid key
  shot.*list = texts;
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
      setList(*list, shot, value.get<std::vector<std::string>>());
    } else if (option.fields.size() == 1) {
      setField(option, option.fields.front(), shot, plan::valueFromJson(value));
    } else {
      if (!value.is_array() || value.size() != option.fields.size()) refuse("a list with one number per field");
      for (size_t i = 0; i < option.fields.size(); ++i)
        setField(option, option.fields[i], shot, plan::valueFromJson(value[i]));
    }
  } catch (const Json::exception&) {
    refuse("a valid value");
  }
}

// ---- as text

std::vector<std::string> textsOf(const ShotOption& option, const Shot& shot) {
  if (!option.isGiven(shot)) return {};
  const ShotMember& member = option.fields.front().member;
  if (const auto* at = std::get_if<View Shot::*>(&member)) return {viewText(*(shot.**at))};
  if (const auto* list = std::get_if<std::vector<std::string> Shot::*>(&member)) return shot.**list;
  std::vector<std::string> texts;
  for (const ShotField& field : option.fields) texts.push_back(plainText(field.get(shot)));
  return {fmt::format("{}", fmt::join(texts, "x"))};
}

// Parses "ex,ey,ez,tx,ty,tz" with two different points.
static std::array<double, 6> parseView(const std::string& text) {
  return viewFrom(numbersIn<double, 6>(text, ',').value_or(std::array<double, 6>{}), text);
}

void setFromTexts(const ShotOption& option, Shot& shot, const std::vector<std::string>& texts) {
  const ShotMember& member = option.fields.front().member;
  if (const auto* list = std::get_if<std::vector<std::string> Shot::*>(&member)) {
    setList(*list, shot, texts);
  } else if (const auto* at = std::get_if<View Shot::*>(&member)) {
    (shot.**at).reset();
    if (!texts.empty() && !texts.back().empty()) shot.** at = parseView(texts.back());
  } else if (!texts.empty() && option.fields.size() > 1) {
    setFromJson(option, shot, parseSize(texts.back(), spelled(option)));
  } else if (!texts.empty()) {
    setField(option, option.fields.front(), shot, texts.back());
  }
}

std::string viewText(const std::array<double, 6>& view) { return fmt::format("{}", fmt::join(view, ",")); }

std::array<int, 2> parseSize(const std::string& text, const std::string& option) {
  auto size = numbersIn<int, 2>(text, 'x');
  const ParamDesc& side = findShotOption("size")->fields.front().declaration;
  auto fits = [&](int pixels) { return pixels >= *side.min && pixels <= *side.max; };
  if (!size || !fits((*size)[0]) || !fits((*size)[1]))
    throw Error(
        fmt::format("{} '{}' is not WIDTHxHEIGHT with {} to {} pixels each", option, text, *side.min, *side.max), {},
        2);
  return *size;
}

// ---- for scripts

static const char* typeName(const ShotOption& option) {
  const ShotField& field = option.fields.front();
  if (option.fields.size() > 1) return "size";
  if (isView(field.member)) return "view";
  if (isList(field.member)) return "texts";
  if (field.declaration.type == Type::Bool) return "bool";
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
