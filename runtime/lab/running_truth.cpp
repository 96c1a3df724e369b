// SPDX-License-Identifier: MIT
#include "lab/running_truth.h"

#include <algorithm>
#include <cmath>

#include "base/log.h"
#include "lab/capture.h"
#include "lab/session.h"

namespace strobe::lab {

// Distance between the seeds of two steps. Large, because a pipeline may also use the seeds next to its own.
constexpr uint32_t kSeedStride = 0x9e3779b9u;

RunningTruth::RunningTruth(Workbench& bench, std::string pipeline, const Steps& steps)
    : bench_(bench), pipeline_(std::move(pipeline)), steps_(steps) {
  STROBE_ASSERT(steps.first >= 1 && steps.most >= steps.first, "{} to {}", steps.first, steps.most);
}

RunningTruth::~RunningTruth() = default;

// Settings of the truth pipeline: stratified sample times, no regions.
const script::Settings& RunningTruth::settings() {
  if (!settings_.empty()) return settings_;
  plan::PipelineDesc pipeline = script::evaluatePipeline(bench_.home(), {pipeline_, {}}, nullptr, bench_.limits);
  const plan::ParamDesc* count = plan::paramOf(pipeline, plan::Role::SampleCount);
  if (!count)
    throw Error(
        fmt::format("pipeline '{}' cannot be the truth: it has no parameter of the role sample_count", pipeline_));
  count_ = count->name;
  putRole(settings_, pipeline, plan::Role::SampleCount, int64_t(steps_.first));
  putRole(settings_, pipeline, plan::Role::SampleTimes, "stratified");
  putRole(settings_, pipeline, plan::Role::Regions, false);
  return settings_;
}

void RunningTruth::restart(const Shot& shot) {
  taken_ = samples_ = interrupted_ = 0;
  next_ = set_ = steps_.first;
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

namespace {

struct Interrupted {};

}  // namespace

bool RunningTruth::step(int most, const std::function<bool()>& goes_on) {
  const int samples = std::min(next_, most);
  if (!session_ || samples < 1) return false;
  static const std::set<std::string> wanted = {"color"};
  uint32_t seed = seed_ + uint32_t(taken_) * kSeedStride;
  if (session_->shot().seed != seed) session_->set("seed", int64_t(seed), "running truth");
  if (samples != set_) session_->set(count_, int64_t(set_ = samples), "running truth");
  auto after_sample = [&](int done, int of) {
    if (done < of && goes_on && !goes_on()) throw Interrupted();
  };
  Picture picture;
  double started_s = clockSeconds();
  try {
    picture.frame = session_->draw(&wanted, after_sample);
  } catch (const Interrupted&) {
    next_ = std::max(1, samples / 2);
    ++interrupted_;
    return true;
  }
  double took_s = clockSeconds() - started_s;
  add(colorOf(picture), samples);
  if (samples_ >= 2 * samples && 2 * samples <= steps_.most && took_s <= steps_.longest_s) next_ = 2 * samples;
  return true;
}

// Welford's algorithm, weighted by samples. It avoids differences of large numbers.
void RunningTruth::add(const image::Image& color, int samples) {
  if (taken_ == 0) {
    mean_ = image::Image(color.width, color.height, color.channels);
    mean_so_far_.assign(color.values.size(), 0);
    squares_.assign(color.values.size(), 0);
  }
  ++taken_;
  samples_ += samples;
  for (size_t i = 0; i < color.values.size(); ++i) {
    double off = color.values[i] - mean_so_far_[i];
    mean_so_far_[i] += off * samples / samples_;
    squares_[i] += samples * off * (color.values[i] - mean_so_far_[i]);
    mean_.values[i] = float(mean_so_far_[i]);
  }
}

double RunningTruth::standardError() const {
  if (taken_ < 2) return std::numeric_limits<double>::infinity();
  double sum = 0;
  for (double squares : squares_) sum += squares / (taken_ - 1) / samples_;
  return std::sqrt(sum / double(squares_.size()));
}

}  // namespace strobe::lab
