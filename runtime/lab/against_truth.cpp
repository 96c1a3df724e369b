// SPDX-License-Identifier: MIT
#include "lab/against_truth.h"

#include <algorithm>

#include "image/metrics.h"

namespace strobe::lab {

image::Image maskOf(const Picture& truth, const std::string& region) {
  if (region == "whole") return {};
  auto found = truth.frame.outputs.find(region);
  if (found == truth.frame.outputs.end())
    throw Error(fmt::format("pipeline '{}' of the truth has no output '{}' for the region of that name",
                            truth.record["pipeline"]["name"].get<std::string>(), region));
  return found->second.floats;
}

double sigmaOf(const Picture& truth, const image::Image& mask) {
  auto found = truth.frame.outputs.find("error");
  if (found == truth.frame.outputs.end()) return 0;
  image::Image error = image::threeChannels(found->second.floats);
  return image::rootMeanSquaredError(error, image::Image(error.width, error.height, 3), mask);
}

// Counters named "clamped" count the same pixels in several passes: the largest stands for all.
uint64_t clampedPixels(const Json& record) {
  uint64_t most = 0;
  if (!record.contains("counters")) return 0;
  for (const auto& [name, count] : record["counters"].items())
    if (name.ends_with(".clamped")) most = std::max(most, count.get<uint64_t>());
  return most;
}

}  // namespace strobe::lab
