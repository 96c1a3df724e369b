// SPDX-License-Identifier: MIT
// Chooses the value of the pipeline parameter with the role Quality from the times of the last frames.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "plan/description.h"

namespace strobe::lab {

// Searches the highest of a few values whose frames take at most `budget_ms`. Each step waits for the median of some
// frames. Values that were too expensive are not tried again until the cost of the present value changes, for example
// after a change of the scene. The search therefore ends for every relation between value and cost.
class Budget {
 public:
  static constexpr int kSteps = 20;       // steps from the lowest value to the highest
  static constexpr size_t kEnough = 5;    // number of frames of one value after which the search has settled
  static constexpr double kSpare = 0.85;  // share of the budget below which a higher value is tried

  // Values lie in [`lowest`, `highest`]. The search begins at the value nearest to `start`.
  Budget(double budget_ms, double lowest, double highest, double start);

  // Value for the next frame, rounded to six digits so that a command line states it exactly.
  double value() const;
  // Adds the time of a frame drawn with `value()`, ms; NaN if unknown. Returns true if `value()` changed. The first
  // frame after a change is not counted, because it prepares images and shaders.
  bool add(double frame_ms);

  double ms() const { return budget_ms_; }
  // Median time of the last frames with this value, ms; empty for fewer than three frames.
  std::optional<double> cost() const;
  bool isSettled() const { return frames_.size() >= kEnough; }
  // True if the median time is within the budget, or still unknown. The lowest value may exceed the budget.
  bool isMet() const { return cost().value_or(0) <= budget_ms_; }

 private:
  void learn(double cost_ms);
  int higher() const;
  int lower() const;

  double budget_ms_, lowest_, highest_;
  int step_ = 0;                                              // step of the present value
  int stride_ = 1;                                            // largest number of steps at once
  int direction_ = 0;                                         // 1: search higher values, -1: lower values, 0: neither
  bool is_first_ = true;                                      // the next frame is not counted
  std::vector<double> frames_;                                // last frame times of the present value, ms
  std::array<std::optional<double>, kSteps + 1> known_ = {};  // cost of each step for the present scene, ms
};

// Parameter that a budget chooses. Throws `Error` (exit code 2) for a pipeline without the role.
const plan::ParamDesc& budgetedParam(const plan::PipelineDesc& pipeline);
// Budget that begins at the present value of the parameter.
Budget budgetOf(const plan::PipelineDesc& pipeline, double budget_ms);

}  // namespace strobe::lab
