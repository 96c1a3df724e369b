// SPDX-License-Identifier: MIT
#include "lab/against_truth.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "image/metrics.h"
#include "math/statistics.h"

namespace strobe::lab {

// Empty if an output is missing.
static image::Image movingMask(const Picture& picture) {
  const auto& outputs = picture.frame.outputs;
  auto velocity = outputs.find("velocity"), id = outputs.find("id");
  if (velocity == outputs.end() || id == outputs.end()) return {};
  const image::Image& v = velocity->second.floats;
  const image::UintImage& ids = id->second.uints;
  bool fits = ids.width == v.width && ids.height == v.height && v.channels >= 2;
  if (!fits) return {};
  std::set<uint32_t> moving;
  for (int y = 0; y < v.height; ++y)
    for (int x = 0; x < v.width; ++x)
      if (std::hypot(double(v.at(x, y, 0)), double(v.at(x, y, 1))) >= 0.5) moving.insert(ids.at(x, y, 0));
  image::Image mask(v.width, v.height, 1);
  for (int y = 0; y < v.height; ++y)
    for (int x = 0; x < v.width; ++x) mask.at(x, y, 0) = moving.count(ids.at(x, y, 0)) ? 1.0f : 0.0f;
  return mask;
}

double displacementOf(const Picture& picture) {
  image::Image moving = movingMask(picture);
  if (moving.empty()) return NAN;
  const image::Image& v = picture.frame.outputs.at("velocity").floats;
  std::vector<double> lengths;
  for (int y = 0; y < v.height; ++y)
    for (int x = 0; x < v.width; ++x)
      if (moving.at(x, y, 0) > 0) lengths.push_back(std::hypot(double(v.at(x, y, 0)), double(v.at(x, y, 1))));
  return lengths.empty() ? 0 : median(std::move(lengths));
}

// Empty if an output is missing.
static image::Image edgeMask(const Picture& picture) {
  constexpr int kReach = 2;
  auto id = picture.frame.outputs.find("id");
  if (id == picture.frame.outputs.end()) return {};
  const image::UintImage& ids = id->second.uints;
  image::Image mask(ids.width, ids.height, 1);
  for (int y = 0; y < ids.height; ++y)
    for (int x = 0; x < ids.width; ++x)
      for (int dy = -kReach; dy <= kReach; ++dy)
        for (int dx = -kReach; dx <= kReach; ++dx) {
          int u = std::clamp(x + dx, 0, ids.width - 1), v = std::clamp(y + dy, 0, ids.height - 1);
          if (ids.at(u, v, 0) != ids.at(x, y, 0)) mask.at(x, y, 0) = 1;
        }
  return mask;
}

image::Image maskOf(const Picture& truth, const std::string& region) {
  if (region == "whole") return {};
  if (region == "moving" || region == "edge") {
    image::Image mask = region == "moving" ? movingMask(truth) : edgeMask(truth);
    if (!mask.empty()) return mask;
    throw Error(fmt::format("pipeline '{}' of the truth has no outputs `velocity` and `id` for the region '{}'",
                            truth.record["pipeline"]["name"].get<std::string>(), region));
  }
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

std::vector<uint64_t> countsOf(const Json& record, const std::string& counter) {
  std::vector<uint64_t> counts;
  if (!record.contains("counters")) return counts;
  for (const auto& [name, count] : record["counters"].items())
    if (name.find("." + counter) != std::string::npos) counts.push_back(count.get<uint64_t>());
  return counts;
}

}  // namespace strobe::lab
