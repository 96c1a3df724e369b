// SPDX-License-Identifier: MIT
#include "live/budget_keeper.h"

namespace strobe::live {

static const plan::PipelineDesc& pipelineOf(const Side& a) { return a.session->running().evaluation().pipeline; }

const plan::ParamDesc* BudgetKeeper::param(const Side& a) { return plan::paramOf(pipelineOf(a), plan::Role::Quality); }

static double valueOf(const Side& a) {
  return std::get<double>(*plan::valueOf(pipelineOf(a), BudgetKeeper::param(a)->name));
}

void BudgetKeeper::take(Sides& sides) {
  if (valueOf(sides.a()) == budget_->value()) return;
  const std::string name = param(sides.a())->name;  // a copy that outlives the change
  try {
    sides.set(name, plan::textOf(budget_->value()), "budget");
  } catch (const Error&) {
    set(0);  // the control shows the refusal
  }
}

void BudgetKeeper::follow(Sides& sides, bool drawn, bool changed) {
  Side& a = sides.a();
  if (ms_ == 0 || !param(a)) return budget_.reset();
  if (!budget_ || pipeline_ != pipelineOf(a).file) {
    budget_ = lab::budgetOf(pipelineOf(a), ms_);
    pipeline_ = pipelineOf(a).file;
    a.more = lab::Budget::kEnough + 1;
    return take(sides);
  }
  if (valueOf(a) != budget_->value()) return set(0);
  if (!drawn) return;
  if (changed) a.more = lab::Budget::kEnough;
  if (budget_->add(a.times.total().ms.back())) take(sides);
}

}  // namespace strobe::live
