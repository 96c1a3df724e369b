// SPDX-License-Identifier: MIT
#include "lab/budget.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "math/statistics.h"

namespace strobe::lab {

// Smallest and largest number of frames in a median. The median of three ignores a single slow frame. More frames
// average the noise, but delay the response to a change of the scene.
static constexpr size_t kFewest = 3, kMost = 9;
// Largest change of the value at once: a quarter of the range. Smaller changes come first, unless a frame takes more
// than kFar times the budget.
static constexpr int kStride = Budget::kSteps / 4;
static constexpr double kFar = 2;
// If two costs of one value have at least this ratio, the scene has changed. Medians of 9 times with a noise of 10 %
// differ by 6 % (one standard deviation).
static constexpr double kChange = 1.3;

Budget::Budget(double budget_ms, double lowest, double highest, double start)
    : budget_ms_(budget_ms), lowest_(lowest), highest_(highest) {
  double share = highest > lowest ? (start - lowest) / (highest - lowest) : 0;
  step_ = std::clamp(int(std::lround(share * kSteps)), 0, kSteps);
}

double Budget::value() const {
  return std::stod(fmt::format("{:.6g}", lowest_ + (highest_ - lowest_) * step_ / kSteps));
}

std::optional<double> Budget::cost() const {
  if (frames_.size() < kFewest) return {};
  return median(frames_);
}

// Next higher step: half way to the lowest step known as too expensive, otherwise up by the stride.
int Budget::higher() const {
  auto is_expensive = [this](const auto& cost) { return cost && *cost > budget_ms_; };
  int expensive = int(std::find_if(known_.begin() + step_ + 1, known_.end(), is_expensive) - known_.begin());
  if (expensive > kSteps) return std::min(step_ + stride_, kSteps);
  return step_ + std::min((expensive - step_) / 2, stride_);
}

// Next lower step: half way to the highest step known as cheap enough, otherwise down by the stride.
int Budget::lower() const {
  for (int cheap = step_ - 1; cheap >= 0; --cheap) {
    const std::optional<double>& cost = known_[size_t(cheap)];
    if (cost && *cost <= budget_ms_) return std::max(cheap + (step_ - cheap) / 2, step_ - kStride);
  }
  return std::max(step_ - stride_, 0);
}

// Stores the cost of the present value. A large change of this cost means that the scene changed; the costs of all
// other values are then dropped.
void Budget::learn(double cost_ms) {
  std::optional<double>& known = known_[size_t(step_)];
  if (known && !isSettled()) return;
  bool changed = known && std::abs(std::log(cost_ms / *known)) > std::log(kChange);
  if (changed) known_ = {};
  if (changed || frames_.size() < kMost) known = cost_ms;
}

bool Budget::add(double frame_ms) {
  if (std::exchange(is_first_, false) || !(frame_ms > 0)) return false;
  frames_.push_back(frame_ms);
  if (frames_.size() > kMost) frames_.erase(frames_.begin());
  const std::optional<double> cost_ms = cost();
  if (!cost_ms) return false;
  learn(*cost_ms);
  const int direction = *cost_ms > budget_ms_ ? -1 : *cost_ms < kSpare * budget_ms_ ? 1 : 0;
  if (direction != direction_) stride_ = *cost_ms > kFar * budget_ms_ ? kStride : 1;
  direction_ = direction;
  const int next = direction == 0 ? step_ : direction > 0 ? higher() : lower();
  if (next == step_ && isSettled()) direction_ = 0;
  if (next == step_) return false;
  known_[size_t(step_)] = cost_ms;
  step_ = next;
  stride_ = std::min(2 * stride_, kStride);
  is_first_ = true;
  frames_.clear();
  return true;
}

// ---- of a pipeline

const plan::ParamDesc& budgetedParam(const plan::PipelineDesc& pipeline) {
  if (const plan::ParamDesc* param = plan::paramOf(pipeline, plan::Role::Quality)) return *param;
  throw Error(
      fmt::format("--budget-ms needs a parameter with the role 'quality', which '{}' does not have", pipeline.name), {},
      2);
}

Budget budgetOf(const plan::PipelineDesc& pipeline, double budget_ms) {
  const plan::ParamDesc& param = budgetedParam(pipeline);
  return {budget_ms, *param.min, *param.max, std::get<double>(*plan::valueOf(pipeline, param.name))};
}

}  // namespace strobe::lab
