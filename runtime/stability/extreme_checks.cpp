// SPDX-License-Identifier: MIT
#include "stability/extreme_checks.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "base/json.h"
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

template <class Value>
void readIf(const Json& json, const char* key, Value& value) {
  if (json.contains(key)) json.at(key).get_to(value);
}

lab::Shot readShot(const Json& json) {
  lab::Shot shot;
  json.at("scene").get_to(shot.scene);
  json.at("size").at(0).get_to(shot.width);
  json.at("size").at(1).get_to(shot.height);
  json.at("frame").get_to(shot.frame);
  readIf(json, "anchor", shot.anchor);
  readIf(json, "exposure", shot.exposure);
  readIf(json, "shutter_curve", shot.shutter_curve);
  readIf(json, "camera_blur", shot.camera_blur);
  readIf(json, "object_blur", shot.object_blur);
  readIf(json, "moves", shot.moves);
  readIf(json, "spins", shot.spins);
  if (json.contains("scene_set")) readSettings(json.at("scene_set"), "scene.", shot.sets);
  if (json.contains("set")) readSettings(json.at("set"), "", shot.sets);
  return shot;
}

const std::map<std::string, void (*)(Probe&, const ExtremeCheck&)>& kinds() {
  static const std::map<std::string, void (*)(Probe&, const ExtremeCheck&)> table = {
      {"draws", drawn}, {"as_captured", asCaptured}, {"within", within},    {"nearer", nearer},    {"same", same},
      {"warns", warns}, {"displacement", displaced}, {"truth", exactTruth}, {"sharp_at", sharpAt}, {"silent", silent}};
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

ExtremeCheck readCheck(const Json& json) {
  ExtremeCheck check;
  check.holds = kinds().at(json.at("check"));
  readIf(json, "by", check.by);
  check.shot = readShot(json.at("shot"));
  for (const char* key : {"of", "other"})
    if (json.contains(key)) check.other = readShot(json.at(key));
  readIf(json, "low", check.low), readIf(json, "high", check.high);
  readIf(json, "value", check.value), readIf(json, "share", check.share);
  readIf(json, "tolerance", check.tolerance), readIf(json, "tolerance_px", check.tolerance_px);
  readIf(json, "pixels", check.pixels), readIf(json, "pixel", check.pixel);
  for (const char* key : {"unless", "text"}) readIf(json, key, check.text);
  if (!json.contains("exact")) return check;
  for (const Json& value : json.at("exact"))
    check.exact.push_back(value.is_number() ? value.get<double>() : std::numeric_limits<double>::quiet_NaN());
  return check;
}

void apply(const ExtremeCheck& check, Probe& probe) {
  if (isAbout(check.by, probe)) check.holds(probe, check);
}

}  // namespace strobe::stability
