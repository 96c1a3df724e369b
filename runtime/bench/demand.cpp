// SPDX-License-Identifier: MIT
#include "bench/demand.h"

#include <algorithm>
#include <cmath>

namespace strobe::bench {

double Demand::leastMs(const Gpu& gpu) const {
  constexpr double kMsPerGiga = 1e-6;  // ms per byte or ray, at 1e9 per second
  double ms = 0;
  for (const PassTimes& pass : passes)
    ms += kMsPerGiga * std::max(double(pass.bytes()) / gpu.gigabytes_per_s, double(pass.rays) / gpu.gigarays_per_s);
  return ms;
}

Demand demandAt(lab::Batch& batch, const NamedShot& shot, const ShotTimes& counted, int width, int height) {
  Demand demand{shot.scene, shot.method, width, height, {}};
  lab::Shot large = shot.shot;
  large.width = width, large.height = height;
  std::map<std::string, plan::Traffic> traffic = trafficByPass(*batch.planOf(large));
  const double growth = double(width) * height / (double(counted.width) * counted.height);
  for (PassTimes pass : counted.passes) {
    pass.ms.clear();
    pass.bytes_read = traffic[pass.name].read * uint64_t(pass.executions);
    pass.bytes_written = traffic[pass.name].written * uint64_t(pass.executions);
    pass.rays = uint64_t(std::llround(double(pass.rays) * growth));
    demand.passes.push_back(std::move(pass));
  }
  return demand;
}

Json toJson(const Demand& demand, const Gpu& gpu) {
  double ms = demand.leastMs(gpu);
  Json json = {{"scene", demand.scene},
               {"method", demand.method},
               {"width", demand.width},
               {"height", demand.height},
               {"bytes", bytesOf(demand.passes)},
               {"rays", raysOf(demand.passes)},
               {"least_ms", ms},
               {"most_fps", 1000 / ms}};
  if (demand.published_fps > 0) json["published"] = {{"fps", demand.published_fps}, {"by", demand.published_by}};
  return json;
}

}  // namespace strobe::bench
