// SPDX-License-Identifier: MIT
// Generated shots: a random scene, a frame size and random parameters for a variant. The shot has all settings, so that
// one command line repeats it.
#pragma once

#include <cstdint>

#include "stability/variants.h"

namespace strobe::stability {

// Scene of all cases.
inline const char* const kScene = "stability/crowd";

// Random numbers that depend only on the seed, on every machine.
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

// Returns the shot with one setting changed; settings of the scene are named "scene.x".
lab::Shot with(lab::Shot shot, const std::string& name, const plan::Value& value);
lab::Shot with(lab::Shot shot, const std::string& name, double value);
// Returns the shot with the parameter of a role changed; the unchanged shot if the pipeline lacks the role.
lab::Shot with(lab::Shot shot, const plan::PipelineDesc& pipeline, plan::Role role, double value);
// Value of a scene parameter in the shot; `otherwise` if the shot does not set it.
double knob(const lab::Shot& shot, const std::string& name, double otherwise);
// Returns the shot with another pipeline at its defaults; scene and frame stay.
lab::Shot by(lab::Shot shot, const std::string& pipeline);
// Returns the shot with another size of picture and scene.
lab::Shot sized(lab::Shot shot, int width, int height);

// True for roles with deliberately chosen values: sample count, tile, maximum displacement.
bool isChosen(plan::Role role);

// Case `index` of a variant. The scene depends on `index`, not on the variant. Pictures have at most 64 x 64 px; the
// sides are multiples of the tile size. No displacement is larger than the filters handle.
lab::Shot generated(const Variant& variant, uint64_t seed, int index);

}  // namespace strobe::stability
