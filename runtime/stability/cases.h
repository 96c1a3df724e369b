// SPDX-License-Identifier: MIT
// Generated shots: a scene drawn by a seed, a size, numbers for the parameters of a variant. Everything is in the shot,
// so that one command line repeats it.
#pragma once

#include <cstdint>

#include "stability/variants.h"

namespace strobe::stability {

// The scene all cases are drawn from.
inline const char* const kScene = "stability/crowd";

// A function of its seed alone, on every machine.
class Random {
 public:
  explicit Random(uint64_t seed) : state_(seed) {}
  Random(uint64_t seed, const std::string& text);
  uint64_t bits();
  double unit() { return double(bits() >> 11) * 0x1p-53; }
  int whole(int low, int high) { return low + int(bits() % uint64_t(high - low + 1)); }
  bool chance(double probability) { return unit() < probability; }

 private:
  uint64_t state_;
};

// A shot with a setting changed; those of the scene are called "scene.x".
lab::Shot with(lab::Shot shot, const std::string& name, const plan::Value& value);
lab::Shot with(lab::Shot shot, const std::string& name, double value);
// The parameter of a role changed; the same shot where the pipeline has none.
lab::Shot with(lab::Shot shot, const plan::PipelineDesc& pipeline, plan::Role role, double value);
// The value of a scene's parameter in the shot, or what the scene takes without it.
double knob(const lab::Shot& shot, const std::string& name, double otherwise);
// The same scene and frame, blurred by another pipeline with its defaults.
lab::Shot by(lab::Shot shot, const std::string& pipeline);
// The same with another size, of picture and scene.
lab::Shot sized(lab::Shot shot, int width, int height);

// Roles of numbers that a case chooses on purpose: samples, tile, reach.
bool isChosen(plan::Role role);

// Case `index` of a variant. Pictures of one index have the same scene in all variants, at most 64 px wide and high
// unless tiles are larger; its sides are multiples of the tiles. Nothing moves farther than the filters handle.
lab::Shot generated(const Variant& variant, uint64_t seed, int index);

}  // namespace strobe::stability
