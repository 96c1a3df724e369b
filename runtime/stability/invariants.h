// SPDX-License-Identifier: MIT
// Properties of every blur, on any scene (docs/invariants.md). A check draws a generated shot, and variations of the
// shot with a known effect on the picture. No check reads the internals of a filter.
#pragma once

#include "stability/cases.h"

namespace strobe::stability {

// Result of a check at the worst pixel of a case.
struct Finding {
  bool holds = true;
  bool applies = true;           // false: nothing to check in this case
  int x = 0, y = 0;              // the worst pixel
  double excess = 0;             // amount beyond the tolerance
  std::string text;              // "pixel (3, 4) is 0.51, expected 0.5 within 0.001"
  std::vector<lab::Shot> shots;  // shots with contradictory pictures
};

// A case to check: the shot and its pipeline.
struct CheckedCase {
  lab::Batch& batch;
  const plan::PipelineDesc& pipeline;
  bool is_base;  // the variant is the defaults or a preset
  lab::Shot shot;

  // The shot without blur, and the shot by ground truth.
  lab::Shot sharp(const lab::Shot& shot) const;
  lab::Shot truth(const lab::Shot& shot, int samples) const;
  Random draw(const char* what) const;  // depends on the scene's seed only, so it stays while a case shrinks
  double samples() const { return numberOf(pipeline, plan::Role::SampleCount, 1); }
};

// A property required of every motion blur method, with its tolerance and the function that tests it on one case.
struct Invariant {
  std::string name, says;
  std::string tolerance;  // with its reason
  Finding (*check)(const CheckedCase&);
};

// All invariants, in the order of plan::invariantNames().
const std::vector<Invariant>& invariants();
// Throws `Error` (exit code 2) with the nearest name if `name` is unknown.
const Invariant& invariantNamed(const std::string& name);

// True if the blur of the shot changes the picture.
bool blurs(lab::Batch& batch, const lab::Shot& shot);

}  // namespace strobe::stability
