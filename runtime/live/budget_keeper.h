// SPDX-License-Identifier: MIT
// Keeps the frames of side A within a budget of time.
#pragma once

#include "lab/budget.h"
#include "live/sides.h"

namespace strobe::live {

// Sets the parameter of the role Quality after each frame. Without a budget, or if the pipeline has no such
// parameter, it does nothing. A value that is set by hand, or is refused, ends the budget.
class BudgetKeeper {
 public:
  // `ms`: of a frame; 0: none.
  explicit BudgetKeeper(double ms) : ms_(ms) {}
  void set(double ms) { ms_ = ms, budget_.reset(); }
  double ms() const { return ms_; }

  // Call once per turn, after the draw of A. `drawn`: A has a new frame. `changed`: the values of A changed before it.
  void follow(Sides& sides, bool drawn, bool changed);

  // The parameter; null for a pipeline without the role.
  static const plan::ParamDesc* param(const Side& a);
  // The search for its value; null without a budget.
  const lab::Budget* budget() const { return budget_ ? &*budget_ : nullptr; }

 private:
  void take(Sides& sides);

  double ms_;
  std::string pipeline_;  // of `budget_`
  std::optional<lab::Budget> budget_;
};

}  // namespace strobe::live
