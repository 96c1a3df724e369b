// SPDX-License-Identifier: MIT
#include "lab/limits.h"

#include "gpu/limits.h"
#include "scene/limits.h"
#include "world/limits.h"

namespace strobe::lab {

std::vector<Limit> allLimits() {
  std::vector<Limit> all(gpu::kLimits.begin(), gpu::kLimits.end());
  all.insert(all.end(), scene::kLimits.begin(), scene::kLimits.end());
  all.insert(all.end(), world::kLimits.begin(), world::kLimits.end());
  all.insert(all.end(), kLimits.begin(), kLimits.end());
  return all;
}

}  // namespace strobe::lab
