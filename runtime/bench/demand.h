// SPDX-License-Identifier: MIT
// What a frame asks of a GPU, whatever its passes compute: the bytes of its images and its rays. It is a bound from
// traffic and rays, no prediction: arithmetic, latency, occupancy, the scene's geometry and textures are not in it, and
// images that fit into caches may cost less than their bytes.
#pragma once

#include "bench/measure.h"

namespace strobe::bench {

// What it can do at most.
struct Gpu {
  double gigabytes_per_s = 0, gigarays_per_s = 0;
};

// Of a frame at a size.
struct Demand {
  std::string scene, method;
  int width = 0, height = 0;
  std::vector<PassTimes> passes;  // without times
  double published_fps = 0;       // what somebody else measured; 0: nothing
  std::string published_by;

  uint64_t bytes() const;
  uint64_t rays() const;
  // Passes one after the other, each bound by its bytes or by its rays.
  double leastMs(const Gpu& gpu) const;
};

// The passes that a frame of `shot` ran in `counted`, at another size: bytes are those of the plan at the new size,
// rays grow with the pixels. Throws `Error` where there is no such plan.
Demand demandAt(lab::Batch& batch, const NamedShot& shot, const ShotTimes& counted, int width, int height);

Json toJson(const Demand& demand, const Gpu& gpu);

}  // namespace strobe::bench
