// SPDX-License-Identifier: MIT
#include "bench/slopes.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/error.h"

namespace strobe::bench {

namespace {

constexpr std::array kGrowths = {"constant", "linear", "logarithmic"};
constexpr std::array kVerdicts = {"", "holds", "fails"};

// Most specific expectation: for the part itself, else for every pass.
std::optional<ExpectedGrowth> expectedOf(const AxisRun& axis, const std::string& method, const std::string& part) {
  auto find = [&](const std::string& name) {
    return std::find_if(axis.expected.begin(), axis.expected.end(), [&](const ExpectedGrowth& one) {
      return one.part == name && (one.method.empty() || one.method == method);
    });
  };
  auto found = find(part);
  bool is_pass = part != kFrame && part != kRest;
  if (found == axis.expected.end() && is_pass) found = find(kEveryPass);
  return found == axis.expected.end() ? std::nullopt : std::optional<ExpectedGrowth>(*found);
}

GrowthVerdict verdictOf(const Fit& fit) {
  if (!fit.expected || std::isnan(fit.line.slope.low)) return GrowthVerdict::unknown;
  const Estimate& slope = fit.line.slope;
  if (fit.expected->growth != Growth::constant)
    return slope.low > 0 && fit.line.r2 >= kLeastR2 ? GrowthVerdict::holds : GrowthVerdict::fails;
  auto [least, most] = std::minmax_element(fit.x.begin(), fit.x.end());
  double allowed_ms = kConstantShare * fit.line.at(mean(fit.x)), length = *most - *least;
  return slope.low * length <= allowed_ms && slope.high * length >= -allowed_ms ? GrowthVerdict::holds
                                                                                : GrowthVerdict::fails;
}

double fittedOver(double x, bool logarithmic) { return logarithmic ? std::log2(std::max(x, 1.0)) : x; }

// Shots of one method, with their x.
struct Along {
  std::string method;
  std::vector<double> x;
  std::vector<const ShotTimes*> shots;
  std::vector<std::vector<PassTimes>> parts;  // of each shot
};

std::vector<Along> methodsOf(const AxisRun& axis) {
  std::vector<Along> methods;
  for (size_t i = 0; i < axis.run.shots.size(); ++i) {
    const ShotTimes& shot = axis.run.shots[i];
    auto found =
        std::find_if(methods.begin(), methods.end(), [&](const Along& one) { return one.method == shot.method; });
    if (found == methods.end()) found = methods.insert(methods.end(), Along{shot.method, {}, {}, {}});
    found->x.push_back(axis.x[i]);
    found->shots.push_back(&shot);
    found->parts.push_back(shot.parts());
  }
  return methods;
}

// Milliseconds of a part by shot; empty if a shot lacks the part.
std::vector<Estimate> msOf(const Along& along, const std::string& part) {
  std::vector<Estimate> ms;
  for (const std::vector<PassTimes>& parts : along.parts)
    for (const PassTimes& one : parts)
      if (one.name == part) ms.push_back(estimatedMedian(one.ms));
  return ms.size() == along.shots.size() ? ms : std::vector<Estimate>();
}

Fit fitOf(const AxisRun& axis, const Along& along, const std::string& part, std::vector<Estimate> ms) {
  Fit fit{along.method, part, along.x, std::move(ms), {}, expectedOf(axis, along.method, part)};
  std::vector<double> x, y;
  for (size_t i = 0; i < fit.x.size(); ++i) {
    x.push_back(fittedOver(fit.x[i], fit.isLogarithmic()));
    y.push_back(fit.ms[i].value);
  }
  fit.line = lineThrough(x, y);
  fit.verdict = verdictOf(fit);
  return fit;
}

Json toJson(const Estimate& estimate) { return {estimate.value, estimate.low, estimate.high}; }

Json toJson(const Fit& fit) {
  Json json = {{"method", fit.method},
               {"part", fit.part},
               {"x", fit.x},
               {"ms", Json::array()},
               {"slope", toJson(fit.line.slope)},
               {"intercept", fit.line.intercept},
               {"r2", fit.line.r2},
               {"over", fit.isLogarithmic() ? "log2(x)" : "x"}};
  for (const Estimate& ms : fit.ms) json["ms"].push_back(toJson(ms));
  if (!fit.expected) return json;
  json["expected"] = nameOf(fit.expected->growth);
  json["outcome"] = nameOf(fit.verdict);
  json["why"] = fit.expected->why;
  return json;
}

}  // namespace

const char* nameOf(Growth growth) { return kGrowths[size_t(growth)]; }
const char* nameOf(GrowthVerdict verdict) { return kVerdicts[size_t(verdict)]; }

Growth growthNamed(const std::string& name) {
  auto found = std::find(kGrowths.begin(), kGrowths.end(), name);
  STROBE_ASSERT(found != kGrowths.end(), "{}", name);
  return Growth(found - kGrowths.begin());
}

double Fit::at(double where) const { return line.at(fittedOver(where, isLogarithmic())); }

std::vector<Fit> fitsOf(const AxisRun& axis) {
  std::vector<Fit> fits;
  for (const Along& along : methodsOf(axis)) {
    std::vector<Estimate> frames;
    for (const ShotTimes* shot : along.shots) frames.push_back(estimatedMedian(shot->ms));
    fits.push_back(fitOf(axis, along, kFrame, std::move(frames)));
    for (const PassTimes& part : along.parts.front())
      if (std::vector<Estimate> ms = msOf(along, part.name); !ms.empty())
        fits.push_back(fitOf(axis, along, part.name, std::move(ms)));
  }
  return fits;
}

void requireKnownParts(const AxisRun& axis, const std::vector<Fit>& fits) {
  for (const ExpectedGrowth& expected : axis.expected) {
    bool is_met = std::any_of(fits.begin(), fits.end(), [&](const Fit& fit) {
      bool of_method = expected.method.empty() || expected.method == fit.method;
      return of_method && (expected.part == kEveryPass || expected.part == fit.part);
    });
    if (!is_met) throw Error(fmt::format("axis '{}': no frame has the part '{}'", axis.name, expected.part), {}, 2);
  }
}

Json toJson(const AxisRun& axis, const std::vector<Fit>& fits) {
  Json json = {{"name", axis.name}, {"title", axis.title}, {"unit", axis.unit}, {"fits", Json::array()}};
  for (const Fit& fit : fits) json["fits"].push_back(toJson(fit));
  json["run"] = bench::toJson(axis.run);
  return json;
}

}  // namespace strobe::bench
