// SPDX-License-Identifier: MIT
#include "stability/extreme_checks.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "image/metrics.h"
#include "image/regions.h"
#include "stability/extremes.h"

namespace strobe::stability {

namespace {

using image::Image;

// ---- pictures

const Image& colorIn(const lab::Picture& picture) { return picture.frame.outputs.at("color").floats; }
const Image& velocityIn(const lab::Picture& picture) { return picture.frame.outputs.at("velocity").floats; }

std::pair<float, float> rangeOf(const Image& color) {
  std::pair<float, float> range = {INFINITY, -INFINITY};
  for (size_t i = 0; i < color.values.size(); ++i)
    if (i % 4 != 3) range = {std::min(range.first, color.values[i]), std::max(range.second, color.values[i])};
  return range;
}

bool warnedOf(const lab::Picture& picture, const std::string& text) {
  return std::any_of(picture.warnings.begin(), picture.warnings.end(),
                     [&](const std::string& warning) { return warning.find(text) != std::string::npos; });
}

// ---- checks

void drawn(Probe& probe, const ExtremeCheck& check) { probe.picture(check.shot); }

void asCaptured(Probe& probe, const ExtremeCheck& check) {
  const Image& captured = colorIn(probe.sharp(check.other ? *check.other : check.shot));
  int different = image::countDifferent(colorIn(probe.picture(check.shot)), captured, 0);
  probe.expect(different <= check.pixels,
               fmt::format("{} pixels differ from the raster image, at most {} may", different, check.pixels));
}

// Weights are not negative and add up to 1: no colour leaves the range of the surfaces' colours.
void within(Probe& probe, const ExtremeCheck& check) {
  const lab::Picture& picture = probe.picture(check.shot);
  if (!check.text.empty() && warnedOf(picture, check.text)) return;
  auto [least, most] = rangeOf(colorIn(picture));
  double slack = 1e-5 * std::max(std::abs(check.low), std::abs(check.high));  // rounding of N weights, 2 ulp each
  bool inside = least >= check.low - slack && most <= check.high + slack;
  probe.expect(inside, fmt::format("colours are {} to {}, colours of the surfaces {} to {}", least, most, check.low,
                                   check.high));
}

// A filter must bring the picture nearer to truth.
void nearer(Probe& probe, const ExtremeCheck& check) {
  const Image &truth = colorIn(probe.truth(check.shot)), &sharp = colorIn(probe.sharp(check.shot));
  double own = image::rootMeanSquaredError(colorIn(probe.picture(check.shot)), truth);
  double without = image::rootMeanSquaredError(sharp, truth);
  probe.expect(own < without, fmt::format("RMSE against truth is {:.5f}, without blur {:.5f}", own, without));
}

void same(Probe& probe, const ExtremeCheck& check) {
  const Image &a = colorIn(probe.picture(check.shot)), &b = colorIn(probe.picture(*check.other));
  int different = image::countDifferent(a, b, check.tolerance), most = int(check.share * a.width * a.height);
  probe.expect(different <= most,
               fmt::format("{} pixels differ by more than {}, at most {} may", different, check.tolerance, most));
}

void displaced(Probe& probe, const ExtremeCheck& check) {
  const Image& velocity = velocityIn(probe.picture(check.shot));
  double worst = 1;
  std::string text;
  for (int y = 0; y < velocity.height; ++y)
    for (int x = 0; x < velocity.width; ++x) {
      const double* expected = &check.exact[2 * (size_t(y) * size_t(velocity.width) + size_t(x))];
      dvec2 exact(expected[0], expected[1]), own(velocity.at(x, y, 0), velocity.at(x, y, 1));
      double off = glm::length(own - exact) / (check.share * glm::length(exact) + check.tolerance_px);
      if (!(off > worst)) continue;
      worst = off;
      text = fmt::format("displacement at ({}, {}) is ({:.6g}, {:.6g}), expected ({:.6g}, {:.6g})", x, y, own.x, own.y,
                         exact.x, exact.y);
    }
  probe.expect(text.empty(), text);
}

void exactTruth(Probe& probe, const ExtremeCheck& check) {
  const Image& color = colorIn(probe.truth(check.shot));
  double worst = 0;
  std::string text;
  for (int y = 0; y < color.height; ++y)
    for (int x = 0; x < color.width; ++x) {
      double exact = check.exact[size_t(y) * size_t(color.width) + size_t(x)];
      double off = std::abs(color.at(x, y, 0) - exact);
      if (off <= worst) continue;
      worst = off;
      text = fmt::format("pixel ({}, {}) is {:.6f}, expected {:.6f} within {:.6f}", x, y, color.at(x, y, 0), exact,
                         check.tolerance);
    }
  probe.expect(worst <= check.tolerance, text);
}

void sharpAt(Probe& probe, const ExtremeCheck& check) {
  double seen = colorIn(probe.sharp(check.shot)).at(check.pixel[0], check.pixel[1], 0);
  probe.expect(std::abs(seen - check.value) < check.tolerance,
               fmt::format("the value is {}, expected {}", seen, check.value));
}

void warns(Probe& probe, const ExtremeCheck& check) {
  probe.expect(warnedOf(probe.picture(check.shot), check.text), fmt::format("missing warning: {}", check.text));
}

void silent(Probe& probe, const ExtremeCheck& check) {
  probe.expect(!warnedOf(probe.picture(check.shot), check.text), fmt::format("warning without reason: {}", check.text));
}

// ---- reading

lab::Shot readShot(const Json& json, const std::string& what, const Place& place, Problems& problems) {
  Fields fields(json, what, place, problems);
  lab::Shot shot;
  shot.scene = fields.text("scene", std::nullopt);
  if (std::vector<double> size = fields.numbers("size", 2, 2); size.size() == 2)
    shot.width = int(size[0]), shot.height = int(size[1]);
  shot.frame = fields.integer("frame", 0, 0, std::numeric_limits<int>::max());
  shot.anchor = fields.choice("anchor", shot.anchor, {"end", "centre", "start"});
  if (fields.has("exposure")) shot.exposure = fields.number("exposure", 0, 0);
  shot.shutter_curve = fields.text("shutter_curve", shot.shutter_curve);
  shot.camera_blur = fields.number("camera_blur", shot.camera_blur, 0, 1);
  shot.object_blur = fields.number("object_blur", shot.object_blur, 0, 1);
  shot.moves = fields.texts("moves");
  shot.spins = fields.texts("spins");
  readSettings(fields.table("scene_set"), "scene.", shot.sets);
  readSettings(fields.table("set"), "", shot.sets);
  fields.finish();
  return shot;
}

void readExact(Fields& fields, ExtremeCheck& check, size_t channels) {
  for (const Json& value : fields.list("exact"))
    check.exact.push_back(value.is_number() ? value.get<double>() : std::numeric_limits<double>::quiet_NaN());
  size_t count = size_t(check.shot.width) * size_t(check.shot.height) * channels;
  if (check.exact.size() != count)
    fields.problem(fmt::format("'exact' has {} numbers instead of {}", check.exact.size(), count));
}

void readPixel(Fields& fields, ExtremeCheck& check) {
  std::vector<double> pixel = fields.numbers("pixel", 2, 2);
  if (pixel.size() == 2) check.pixel = {int(pixel[0]), int(pixel[1])};
}

// A number of a check: its member and its range.
struct Number {
  double ExtremeCheck::*member;
  double min = -1e9, max = 1e9;
};
const std::map<std::string, Number> kNumbers = {
    {"low", {&ExtremeCheck::low}},           {"high", {&ExtremeCheck::high}},
    {"value", {&ExtremeCheck::value}},       {"tolerance", {&ExtremeCheck::tolerance, 0}},
    {"share", {&ExtremeCheck::share, 0, 1}}, {"tolerance_px", {&ExtremeCheck::tolerance_px, 0}}};

// Data that a check reads besides its shot.
struct CheckKind {
  void (*holds)(Probe&, const ExtremeCheck&);
  std::vector<std::string> numbers;
  const char* text = "";  // key of a text
  bool text_needed = true;
  size_t channels = 0;     // of "exact"
  const char* other = "";  // key of another shot
  bool other_needed = false;
};

const std::map<std::string, CheckKind>& kinds() {
  static const std::map<std::string, CheckKind> table = {
      {"draws", {drawn, {}}},
      {"as_captured", {.holds = asCaptured, .other = "of"}},
      {"within", {.holds = within, .numbers = {"low", "high"}, .text = "unless", .text_needed = false}},
      {"nearer", {nearer, {}}},
      {"same", {.holds = same, .numbers = {"tolerance", "share"}, .other = "other", .other_needed = true}},
      {"displacement", {.holds = displaced, .numbers = {"share", "tolerance_px"}, .channels = 2}},
      {"truth", {.holds = exactTruth, .numbers = {"tolerance"}, .channels = 1}},
      {"sharp_at", {.holds = sharpAt, .numbers = {"value", "tolerance"}}},
      {"warns", {.holds = warns, .text = "text"}},
      {"silent", {.holds = silent, .text = "text"}}};
  return table;
}

bool isAbout(const std::string& by, const Probe& probe) {
  if (by == "blurs") return probe.blurs();
  if (by == "filters") return probe.filters();
  if (by == "others") return !probe.filters();
  if (by == "truth") return probe.isTruth();
  return by == "all" || !probe.isTruth();
}

}  // namespace

void readSettings(const Json& table, const std::string& prefix, script::Settings& sets) {
  for (const auto& [name, value] : table.items()) sets.push_back({prefix + name, plan::valueFromJson(value)});
}

ExtremeCheck readCheck(const Json& json, const std::string& what, const Place& place, Problems& problems) {
  static const std::vector<std::string> groups = {"all", "blurs", "filters", "others", "truth", "all_but_truth"};
  std::vector<std::string> names;
  for (const auto& [name, kind] : kinds()) names.push_back(name);
  Fields fields(json, what, place, problems);
  std::string name = fields.choice("check", std::nullopt, names);  // a valid name even after a mistake
  const CheckKind& kind = kinds().at(name);
  ExtremeCheck check;
  check.holds = kind.holds;
  check.by = fields.choice("by", "all", groups);
  if (const Json* shot = fields.need("shot")) check.shot = readShot(*shot, what + ": shot", place, problems);
  if (*kind.other && fields.has(kind.other))
    check.other = readShot(*fields.find(kind.other), what + ": " + kind.other, place, problems);
  if (kind.other_needed && !check.other) fields.problem(fmt::format("needs '{}'", kind.other));
  for (const std::string& key : kind.numbers) {
    const Number& number = kNumbers.at(key);
    check.*number.member = fields.number(key, std::nullopt, number.min, number.max);
  }
  if (*kind.text) check.text = kind.text_needed ? fields.text(kind.text, std::nullopt) : fields.text(kind.text);
  if (kind.channels) readExact(fields, check, kind.channels);
  if (kind.holds == asCaptured) check.pixels = fields.integer("pixels", 0, 0, 1 << 20);
  if (kind.holds == sharpAt) readPixel(fields, check);
  fields.finish();
  return check;
}

void apply(const ExtremeCheck& check, Probe& probe) {
  if (isAbout(check.by, probe)) check.holds(probe, check);
}

}  // namespace strobe::stability
