// SPDX-License-Identifier: MIT
#include "bench/demand.h"

#include <algorithm>
#include <cmath>

#include "plan/traffic.h"

namespace strobe::bench {

uint64_t Demand::bytes() const {
  uint64_t sum = 0;
  for (const PassTimes& pass : passes) sum += pass.bytes();
  return sum;
}

uint64_t Demand::rays() const {
  uint64_t sum = 0;
  for (const PassTimes& pass : passes) sum += pass.rays;
  return sum;
}

double Demand::leastMs(const Gpu& gpu) const {
  constexpr double kMsPerGiga = 1e-6;  // of what is done at one giga per second
  double ms = 0;
  for (const PassTimes& pass : passes)
    ms += kMsPerGiga * std::max(double(pass.bytes()) / gpu.gigabytes_per_s, double(pass.rays) / gpu.gigarays_per_s);
  return ms;
}

Demand demandAt(lab::Batch& batch, const NamedShot& shot, const ShotTimes& counted, int width, int height) {
  Demand demand{shot.scene, shot.method, width, height, {}};
  lab::Shot large = shot.shot;
  large.width = width, large.height = height;
  std::vector<plan::Traffic> traffic = plan::trafficOf(*batch.planOf(batch.filled(large)));
  STROBE_ASSERT(traffic.size() == counted.passes.size(), "{}", counted.name());
  const double growth = double(width) * height / (double(counted.width) * counted.height);
  for (size_t i = 0; i < traffic.size(); ++i) {
    const PassTimes& pass = counted.passes[i];
    uint64_t executions = uint64_t(pass.executions);
    demand.passes.push_back({pass.name,
                             {},
                             pass.executions,
                             traffic[i].read * executions,
                             traffic[i].written * executions,
                             uint64_t(std::llround(double(pass.rays) * growth))});
  }
  return demand;
}

Json toJson(const Demand& demand, const Gpu& gpu) {
  double ms = demand.leastMs(gpu);
  Json json = {{"scene", demand.scene},   {"method", demand.method}, {"width", demand.width}, {"height", demand.height},
               {"bytes", demand.bytes()}, {"rays", demand.rays()},   {"least_ms", ms},        {"most_fps", 1000 / ms}};
  if (demand.published_fps > 0) json["published"] = {{"fps", demand.published_fps}, {"by", demand.published_by}};
  return json;
}

}  // namespace strobe::bench
