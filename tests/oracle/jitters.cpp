// SPDX-License-Identifier: MIT
#include "oracle/jitters.h"

#include <algorithm>
#include <cmath>

namespace strobe::oracle {
namespace {

double fractionOf(double x) { return x - std::floor(x); }

// Jarzynski and Olano 2020.
uint32_t pcg(uint32_t value) {
  uint32_t state = value * 747796405u + 2891336453u;
  uint32_t word = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
  return (word >> 22u) ^ word;
}

uint32_t hashOf(int x, int y, uint32_t frame, uint32_t seed) {
  return pcg(uint32_t(x) ^ pcg(uint32_t(y) ^ pcg(frame ^ pcg(seed))));
}

double unit(uint32_t bits) { return (bits >> 8u) / 16777216.0; }

// The place of the middle one among the sorted hashes of 5 x 5 pixels.
double rankOf(int x, int y, uint32_t seed) {
  std::vector<uint32_t> around;
  for (int i = 0; i < 25; ++i) around.push_back(hashOf(x + i % 5 - 2, y + i / 5 - 2, 0, seed));
  uint32_t own = around[12];
  std::sort(around.begin(), around.end());
  auto rank = std::lower_bound(around.begin(), around.end(), own) - around.begin();
  return (double(rank) + unit(pcg(own))) / 25;
}

}  // namespace

double ignJitter(int x, int y) { return fractionOf(52.9829189 * fractionOf(0.06711056 * x + 0.00583715 * y)) - 0.5; }

std::vector<std::pair<std::string, JitterAt>> jittersOf(uint32_t frame, uint32_t seed) {
  constexpr double kGolden = 1.6180339887498949, kPlastic = 1.32471795724474602596;
  double shift = fractionOf(frame / kGolden);
  auto shifted = [shift](const JitterAt& value) -> JitterAt {
    return [=](int x, int y) { return fractionOf(value(x, y) + shift) - 0.5; };
  };
  return {
      {"ign", shifted([](int x, int y) { return ignJitter(x, y) + 0.5; })},
      {"r2", shifted([](int x, int y) { return fractionOf(x / kPlastic + y / (kPlastic * kPlastic)); })},
      {"blue", shifted([seed](int x, int y) { return rankOf(x, y, seed); })},
      {"checker", shifted([](int x, int y) { return (x + y) % 2 == 0 ? 0.25 : 0.75; })},
      {"hash", [=](int x, int y) { return unit(hashOf(x, y, frame, seed)) - 0.5; }},
  };
}

}  // namespace strobe::oracle
