// SPDX-License-Identifier: MIT
// Chooses the value of a pipeline's parameter of the role Quality from the times of the last frames.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "plan/description.h"

namespace strobe::lab {

// Searches the highest of a few values whose frames take at most `budget_ms`. Each step waits for the median of some
// frames. Values that were too expensive are not tried again until the cost of the present value changes, as it does if
// the scene changes; so the search ends, whatever the cost of a value is.
class Budget {
 public:
  static constexpr int kSteps = 20;       // from the lowest value of the parameter to the highest
  static constexpr size_t kEnough = 5;    // frames of one value after which the search has settled
  static constexpr double kSpare = 0.85;  // share of the budget below which a higher value is tried

  // Values lie between `lowest` and `highest`, both included. The search begins at the one next to `start`.
  Budget(double budget_ms, double lowest, double highest, double start);

  // The value to draw with, rounded to six digits so that a command line states it exactly.
  double value() const;
  // Adds the time of a frame drawn with `value()`. Returns true if `value()` changed. The first frame after a change is
  // not counted, because it prepares images and shaders. NaN: the time is not known.
  bool add(double frame_ms);

  double ms() const { return budget_ms_; }
  // Median time of the last frames with this value; empty for fewer than three frames.
  std::optional<double> cost() const;
  bool isSettled() const { return frames_.size() >= kEnough; }
  // False if a frame takes longer than the budget, even at the lowest value once the search has settled.
  bool isMet() const { return cost().value_or(0) <= budget_ms_; }

 private:
  void learn(double cost_ms);
  int higher() const;
  int lower() const;

  double budget_ms_, lowest_, highest_;
  int step_ = 0;                // of the present value
  int stride_ = 1;              // largest number of steps at once
  int direction_ = 0;           // 1: a higher value is wanted, -1: a lower one, 0: neither
  bool is_first_ = true;        // the next frame is not counted
  std::vector<double> frames_;  // last times of the present value, ms
  std::array<std::optional<double>, kSteps + 1> known_ = {};  // cost of each step, while the scene is alike, ms
};

// The parameter that a budget chooses. Throws `Error` (exit code 2) for a pipeline without the role.
const plan::ParamDesc& budgetedParam(const plan::PipelineDesc& pipeline);
// Begins at the present value of that parameter.
Budget budgetOf(const plan::PipelineDesc& pipeline, double budget_ms);

}  // namespace strobe::lab
