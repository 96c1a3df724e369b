// SPDX-License-Identifier: MIT
#include "stability/curves_run.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <set>

#include "base/log.h"
#include "image/metrics.h"
#include "lab/against_truth.h"
#include "lab/capture.h"
#include "lab/pace.h"
#include "lab/session.h"
#include "math/statistics.h"

namespace strobe::stability::curves {

namespace {

using image::Image;

uint64_t brokenValues(const Image& color) {
  return uint64_t(
      std::count_if(color.values.begin(), color.values.end(), [](float value) { return !std::isfinite(value); }));
}

// Root mean square of the channels' standard deviations.
double contrastOf(const Image& color) {
  double variance = 0, n = double(color.width) * color.height;
  for (int c = 0; c < 3; ++c) {
    double sum = 0, squares = 0;
    for (size_t i = size_t(c); i < color.values.size(); i += size_t(color.channels)) {
      sum += color.values[i];
      squares += double(color.values[i]) * color.values[i];
    }
    variance += std::max(0.0, squares / n - sum / n * (sum / n)) / 3;
  }
  return std::sqrt(variance);
}

// Largest difference, and the share of pixels that differ by more than 1e-5.
std::array<double, 2> driftOf(const Image& a, const Image& b) {
  double largest = 0;
  size_t differ = 0, pixels = size_t(a.width) * size_t(a.height), channels = size_t(a.channels);
  for (size_t i = 0; i < pixels; ++i) {
    double most = 0;
    for (size_t c = 0; c < channels; ++c)
      most = std::max(most, std::abs(double(a.values[i * channels + c]) - b.values[i * channels + c]));
    largest = std::max(largest, most);
    differ += most > 1e-5;
  }
  return {largest, double(differ) / double(pixels)};
}

// "NODE: COUNT WHAT" of each limit a picture met: its warnings without those of the scene, without what to do about
// them.
std::vector<std::string> limitsMet(const lab::Picture& picture) {
  std::vector<std::string> met, of_scene = picture.record["scene"]["warnings"].get<std::vector<std::string>>();
  for (const std::string& warning : picture.warnings)
    if (std::find(of_scene.begin(), of_scene.end(), warning) == of_scene.end())
      met.push_back(warning.substr(0, warning.find(';')));
  return met;
}

// One axis in the making.
class Walk {
 public:
  Walk(const Experiment& experiment, const Axis& axis, lab::Workbench& bench)
      : experiment_(experiment), axis_(axis), bench_(bench) {}

  // The benign point first: the others are compared to it.
  ReportAxis run(lab::Pace& pace);

 private:
  ReportPoint point(const AxisPoint& at);
  Measured measured(const AxisPoint& at, const Method& method, const ReportPoint& point);

  const Experiment& experiment_;
  const Axis& axis_;
  lab::Workbench& bench_;
  lab::Picture truth_picture_;  // of `truth_command_`: an axis need not change what is seen
  std::string truth_command_;
  Image truth_, benign_truth_;  // at the point at hand, at the benign one
  std::array<Image, 4> masks_;
};

Measured Walk::measured(const AxisPoint& at, const Method& method, const ReportPoint& point) {
  lab::Shot shot = shotOf(experiment_, axis_, at, method);
  lab::Picture picture = bench_.render(shot);
  Image color = lab::colorOf(picture);
  Measured result;
  result.command = lab::commandOf(shot);
  result.limits = limitsMet(picture);
  result.broken = brokenValues(color);
  bool is_floor = &method == &experiment_.floor;
  for (size_t i = 0; i < kRegions.size(); ++i) {
    double mse = image::meanSquaredError(color, truth_, masks_[i]);
    result.rmse[i] = std::sqrt(mse + (is_floor ? point.sigma[i] * point.sigma[i] : 0));
  }
  return result;
}

ReportPoint Walk::point(const AxisPoint& at) {
  ReportPoint result;
  result.value = at.value;
  result.label = at.label;
  lab::Shot shot = shotOf(experiment_, axis_, at, experiment_.truth);
  result.command = lab::commandOf(shot);
  if (result.command != truth_command_) truth_picture_ = bench_.render(shot), truth_command_ = result.command;
  const lab::Picture& truth = truth_picture_;
  truth_ = lab::colorOf(truth);
  for (const std::string& met : limitsMet(truth)) warn(fmt::format("truth, {} {}: {}", axis_.name, at.label, met));
  for (size_t i = 0; i < kRegions.size(); ++i) {
    masks_[i] = lab::maskOf(truth, kRegions[i]);
    result.pixels[i] = image::countedPixels(truth_, masks_[i]);
    result.sigma[i] = lab::sigmaOf(truth, masks_[i]);
  }
  if (at.value == axis_.benign) benign_truth_ = truth_;
  auto [drift, drifted] = driftOf(truth_, benign_truth_);
  result.drift = drift, result.drifted = drifted;
  result.floor = measured(at, experiment_.floor, result);
  for (const Method& method : experiment_.methods) result.methods.push_back(measured(at, method, result));
  return result;
}

ReportAxis Walk::run(lab::Pace& pace) {
  ReportAxis result{axis_.name,  axis_.title, axis_.unit,    axis_.scale,  axis_.region,
                    axis_.fixed, axis_.note,  axis_.reading, axis_.benign, axis_.same_picture};
  result.points.resize(axis_.points.size());
  std::vector<size_t> order = {axis_.benignIndex()};
  for (size_t i = 0; i < axis_.points.size(); ++i)
    if (i != order.front()) order.push_back(i);
  for (size_t i : order) {
    result.points[i] = point(axis_.points[i]);
    pace.advance(1);
    pace.finish(fmt::format("{} {}", axis_.name, axis_.points[i].label));
  }
  result.contrast = contrastOf(benign_truth_);
  return result;
}

// The values of all variants with one method, the references once: what is drawn in turn.
struct Setting {
  const Variant* variant = nullptr;  // nullptr: every variant at its reference
  std::string value;
  VariantRow row;
  Image color;  // of the case at hand
};

class Comparison {
 public:
  Comparison(const Experiment& experiment, const Method& method, lab::Workbench& bench);
  void measure(const Case& in, const Image& truth, double contrast);
  void time(const Case& in);
  void addTo(std::vector<ReportVariant>& variants) const;

 private:
  lab::Shot shot(const Case& in, const Setting& setting) const {
    return setting.variant ? shotOf(experiment_, in, method_, setting.variant->name, setting.value)
                           : shotOf(experiment_, in, method_);
  }

  const Experiment& experiment_;
  const Method& method_;
  lab::Workbench& bench_;
  std::vector<Setting> settings_;
};

Comparison::Comparison(const Experiment& experiment, const Method& method, lab::Workbench& bench)
    : experiment_(experiment), method_(method), bench_(bench) {
  settings_.push_back({});
  for (const Variant& variant : experiment.variants)
    for (const std::string& value : variant.values)
      if (value != variant.reference && !lacks(method, variant.name)) settings_.push_back({&variant, value, {}, {}});
}

void Comparison::measure(const Case& in, const Image& truth, double contrast) {
  for (Setting& setting : settings_) {
    lab::Picture picture = bench_.render(shot(in, setting));
    setting.color = lab::colorOf(picture);
    setting.row.errors.push_back(image::rootMeanSquaredError(setting.color, truth) / contrast);
    setting.row.changes.push_back(driftOf(setting.color, settings_.front().color)[0]);
    setting.row.limits.push_back(limitsMet(picture));
  }
}

// In turn, so that what else the machine does strikes all alike.
void Comparison::time(const Case& in) {
  constexpr int kRounds = 9;
  std::vector<std::unique_ptr<lab::Session>> sessions;
  std::set<std::string> wanted = {"color"};
  for (Setting& setting : settings_) {
    sessions.push_back(std::make_unique<lab::Session>(bench_, shot(in, setting)));
    setting.row.mib = double(plan::bytesAliased(sessions.back()->plan())) / (1 << 20);
    sessions.back()->draw(&wanted);
  }
  std::vector<std::vector<double>> ms(settings_.size());
  for (int round = 0; round < kRounds; ++round)
    for (size_t i = 0; i < settings_.size(); ++i) ms[i].push_back(sessions[i]->draw(&wanted).gpu_ms);
  for (size_t i = 0; i < settings_.size(); ++i) {
    settings_[i].row.ms = median(ms[i]);
    settings_[i].row.least_ms = *std::min_element(ms[i].begin(), ms[i].end());
  }
}

void Comparison::addTo(std::vector<ReportVariant>& variants) const {
  for (size_t v = 0; v < variants.size(); ++v) {
    const Variant& variant = experiment_.variants[v];
    for (const std::string& value : lacks(method_, variant.name) ? std::vector<std::string>() : variant.values)
      for (const Setting& setting : settings_) {
        bool reference = !setting.variant && value == variant.reference;
        if (!reference && (setting.variant != &variant || setting.value != value)) continue;
        variants[v].rows.push_back(setting.row);
        variants[v].rows.back().method = method_.label;
        variants[v].rows.back().value = value;
      }
  }
}

bool hasAny(const Experiment& experiment, const Method& method) {
  return std::any_of(experiment.variants.begin(), experiment.variants.end(),
                     [&](const Variant& variant) { return !lacks(method, variant.name); });
}

void measureVariants(const Experiment& experiment, lab::Workbench& bench, Report& report, lab::Pace& pace) {
  std::vector<Comparison> comparisons;
  for (const Method& method : experiment.methods)
    if (hasAny(experiment, method)) comparisons.emplace_back(experiment, method, bench);
  for (const Case& in : experiment.cases) {
    report.cases.push_back(in.label);
    Image truth = lab::colorOf(bench.render(shotOf(experiment, in, experiment.truth)));
    double contrast = contrastOf(truth);
    for (Comparison& comparison : comparisons) comparison.measure(in, truth, contrast);
    pace.advance(1);
    pace.finish("variants, " + in.label);
  }
  for (const Variant& variant : experiment.variants)
    report.variants.push_back({variant.name, variant.title, variant.reference, variant.reading, {}});
  for (Comparison& comparison : comparisons) {
    comparison.time(experiment.cases.front());
    comparison.addTo(report.variants);
  }
}

}  // namespace

Report measure(const Experiment& experiment, lab::Workbench& bench) {
  Report report;
  report.strobe = STROBE_VERSION;
  report.title = experiment.title;
  report.note = experiment.note;
  const gpu::DeviceInfo& device = bench.device().info();
  report.device = device.name, report.driver = device.driver, report.software = device.software;
  report.width = experiment.width, report.height = experiment.height;
  report.factor = experiment.factor;
  report.truth = experiment.truth.label, report.floor = experiment.floor.label;
  for (const Method& method : experiment.methods) report.methods.push_back(method.label);
  int points = int(experiment.cases.size());
  for (const Axis& axis : experiment.axes) points += int(axis.points.size());
  lab::Pace pace("extremes", points, points);
  for (const Axis& axis : experiment.axes) report.axes.push_back(Walk(experiment, axis, bench).run(pace));
  if (!experiment.variants.empty()) measureVariants(experiment, bench, report, pace);
  return report;
}

}  // namespace strobe::stability::curves
