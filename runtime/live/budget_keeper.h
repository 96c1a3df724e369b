// SPDX-License-Identifier: MIT
// Keeps the GPU time of A's frames within a budget.
#pragma once

#include "lab/budget.h"
#include "live/sides.h"

namespace strobe::live {

// Sets the parameter with the role Quality after each frame of A. Does nothing without a budget or if the pipeline
// lacks such a parameter. The budget ends if anything else changes the parameter or its new value is refused.
class BudgetKeeper {
 public:
  // `ms`: GPU time of a frame of A, milliseconds; 0 for no budget.
  explicit BudgetKeeper(double ms) : ms_(ms) {}
  void set(double ms) { ms_ = ms, budget_.reset(); }
  double ms() const { return ms_; }

  // Call once per turn, after A is drawn. `drawn`: A has a new frame. `changed`: a value of A changed before that
  // frame.
  void follow(Sides& sides, bool drawn, bool changed);

  // Returns the parameter; null if the pipeline lacks the role.
  static const plan::ParamDesc* param(const Side& a);
  // Returns the search for the parameter's value; null without a budget.
  const lab::Budget* budget() const { return budget_ ? &*budget_ : nullptr; }

 private:
  void take(Sides& sides);

  double ms_;
  std::string pipeline_;  // pipeline of `budget_`
  std::optional<lab::Budget> budget_;
};

}  // namespace strobe::live
