// SPDX-License-Identifier: MIT
// Properties of every blur, on any scene (docs/invariants.md). Each is checked on pictures of one generated
// shot and of what is known to change it in a known way; none looks into the filter.
#pragma once

#include "stability/cases.h"

namespace strobe::stability {

// What a check found at the worst pixel of a case.
struct Finding {
  bool holds = true;
  bool applies = true;           // false: nothing to check in this case
  int x = 0, y = 0;              // the worst pixel
  double excess = 0;             // how far it is beyond the tolerance
  std::string text;              // "pixel (3, 4) is 0.51 where 0.5 is right within 0.001"
  std::vector<lab::Shot> shots;  // the pictures that contradict each other
};

// A case that is checked: the shot, and what runs in it.
struct Subject {
  lab::Batch& batch;
  const plan::PipelineDesc& pipeline;
  bool is_base;  // of its pipeline's variants, the defaults or a preset
  lab::Shot shot;

  // The shot without blur, and as it truly is.
  lab::Shot sharp(const lab::Shot& shot) const;
  lab::Shot truth(const lab::Shot& shot, int samples) const;
  Random draw(const char* what) const;  // depends on the scene's seed alone, so it stays while a case shrinks
  double samples() const { return numberOf(pipeline, plan::Role::SampleCount, 1); }
};

struct Invariant {
  std::string name, says;
  std::string tolerance;  // with its reason
  Finding (*check)(const Subject&);
};

// In the order of plan::invariantNames().
const std::vector<Invariant>& invariants();
// Throws `Error` (exit code 2) with the nearest for an unknown name.
const Invariant& invariantNamed(const std::string& name);

// Does the blur of the shot change the picture?
bool blurs(lab::Batch& batch, const lab::Shot& shot);

}  // namespace strobe::stability
