// SPDX-License-Identifier: MIT
// Demand of a frame on a GPU: the bytes of its images, and its rays. The times are a bound from traffic and rays, not a
// prediction: arithmetic, latency, occupancy, and the scene's geometry and textures are not included, and images that
// fit into caches may cost less than their bytes.
#pragma once

#include "bench/measure.h"

namespace strobe::bench {

// Peak rates of a GPU.
struct Gpu {
  double gigabytes_per_s = 0, gigarays_per_s = 0;
};

// Demand of a frame at one size.
struct Demand {
  std::string scene, method;
  int width = 0, height = 0;
  std::vector<PassTimes> passes;  // without times
  double published_fps = 0;       // frames per second published by others; 0: unknown
  std::string published_by;

  // Milliseconds of the passes one after the other. A pass takes the time of its bytes or of its rays, whichever is
  // longer.
  double leastMs(const Gpu& gpu) const;
};

// Demand of `shot` at another size, for the passes that ran in `counted`. Bytes are from the plan at the new size, and
// rays grow with the pixels. Throws `Error` if the shot has no plan at that size.
Demand demandAt(lab::Batch& batch, const NamedShot& shot, const ShotTimes& counted, int width, int height);

Json toJson(const Demand& demand, const Gpu& gpu);

}  // namespace strobe::bench
