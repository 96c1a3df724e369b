// SPDX-License-Identifier: MIT
#include "lab/running_truth.h"

#include <cmath>
#include <limits>

#include "lab/capture.h"
#include "lab/session.h"

namespace strobe::lab {

// Seeds of steps lie far apart: a pipeline may use the seeds next to its own as well.
constexpr uint32_t kSeedStride = 0x9e3779b9u;

RunningTruth::RunningTruth(Workbench& bench, std::string pipeline, int samples_per_step)
    : bench_(bench), pipeline_(std::move(pipeline)), samples_per_step_(samples_per_step) {
  STROBE_ASSERT(samples_per_step >= 1, "{}", samples_per_step);
}

RunningTruth::~RunningTruth() = default;

// Samples at random times, no regions.
const script::Settings& RunningTruth::settings() {
  if (!settings_.empty()) return settings_;
  plan::PipelineDesc pipeline = script::evaluatePipeline(bench_.home(), {pipeline_, {}}, nullptr, bench_.limits);
  if (!plan::paramOf(pipeline, plan::Role::SampleCount))
    throw Error(
        fmt::format("pipeline '{}' cannot be the truth: it has no parameter of the role sample_count", pipeline_));
  putRole(settings_, pipeline, plan::Role::SampleCount, int64_t(samples_per_step_));
  putRole(settings_, pipeline, plan::Role::SampleTimes, "stratified");
  putRole(settings_, pipeline, plan::Role::Regions, false);
  return settings_;
}

void RunningTruth::restart(const Shot& shot) {
  steps_ = 0;
  mean_ = {};
  session_.reset();
  if (pipeline_.empty())
    pipeline_ = script::pipelineOfKind(bench_.home(), plan::PipelineDesc::Kind::Truth, bench_.limits);
  Shot truth = shot;
  truth.pipeline = pipeline_;
  truth.aa = 1;
  truth.taps.clear();
  truth.sets = sceneSettings(shot.sets);
  for (const auto& [name, value] : settings()) putSetting(truth.sets, name, value);
  session_ = std::make_unique<Session>(bench_, truth, "running truth");
  seed_ = shot.seed;
}

bool RunningTruth::step() {
  if (!session_) return false;
  static const std::set<std::string> wanted = {"color"};
  uint32_t seed = seed_ + uint32_t(steps_) * kSeedStride;
  if (session_->shot().seed != seed) session_->set("seed", int64_t(seed), "running truth");
  Picture picture;
  picture.frame = session_->draw(&wanted);
  add(colorOf(picture));
  return true;
}

// Welford's sums: no difference of large numbers.
void RunningTruth::add(const image::Image& color) {
  if (steps_ == 0) {
    mean_ = image::Image(color.width, color.height, color.channels);
    sum_.assign(color.values.size(), 0);
    squares_.assign(color.values.size(), 0);
  }
  ++steps_;
  for (size_t i = 0; i < color.values.size(); ++i) {
    double value = color.values[i], before = steps_ > 1 ? sum_[i] / (steps_ - 1) : value;
    sum_[i] += value;
    squares_[i] += (value - before) * (value - sum_[i] / steps_);
    mean_.values[i] = float(sum_[i] / steps_);
  }
}

double RunningTruth::standardError() const {
  if (steps_ < 2) return std::numeric_limits<double>::infinity();
  double sum = 0;
  for (double squares : squares_) sum += squares / (steps_ - 1) / steps_;
  return std::sqrt(sum / double(squares_.size()));
}

}  // namespace strobe::lab
