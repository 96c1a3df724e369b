// SPDX-License-Identifier: MIT
// Synthetic runs with given times.
#pragma once

#include <cmath>
#include <functional>

#include "bench/times.h"

namespace strobe::bench::test {

// Milliseconds of a pass of a method in a round.
using MsOf = std::function<double(const std::string& method, const std::string& pass, int round)>;

// A factor within `percent` of 1 that depends on round and seed; its median over nine rounds is 1.
inline double noise(int round, int seed, double percent = 2) {
  return 1 + percent / 100 * ((round * 4 + seed) % 9 - 4) / 4;
}

// Methods "sharp" (passes draw, shade) and "blurred" (draw, shade, gather) at one place. A frame takes the sum of its
// passes plus `rest_ms`.
inline Run runOf(int rounds, const MsOf& ms_of, bool software = false, double rest_ms = 0.5) {
  Run run{"strobe bench frames", "1.0", "hash", "a device", "a driver", "query", software, 4, {}, {}};
  for (const char* method : {"sharp", "blurred"}) {
    ShotTimes shot{"room", method, 64, 36, {{"pipeline", method}, {"exposure", 0.5}}, {}, {}};
    shot.ms.assign(size_t(rounds), rest_ms);
    for (const char* name : {"draw", "shade", "gather"}) {
      if (shot.method == "sharp" && std::string(name) == "gather") continue;
      PassTimes pass{name, {}, 1, 100, 200, 7};
      for (int round = 0; round < rounds; ++round) {
        pass.ms.push_back(ms_of(method, name, round));
        shot.ms[size_t(round)] += pass.ms.back();
      }
      shot.passes.push_back(pass);
    }
    run.shots.push_back(shot);
  }
  return run;
}

}  // namespace strobe::bench::test
