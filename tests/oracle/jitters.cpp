// SPDX-License-Identifier: MIT
#include "oracle/jitters.h"

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

}  // namespace

double ignJitter(int x, int y) { return fractionOf(52.9829189 * fractionOf(0.06711056 * x + 0.00583715 * y)) - 0.5; }

std::vector<std::pair<std::string, JitterAt>> jittersOf(uint32_t frame, uint32_t seed) {
  constexpr double kGolden = 1.6180339887498949;
  double shift = fractionOf(frame / kGolden);
  return {
      {"ign", [=](int x, int y) { return fractionOf(ignJitter(x, y) + 0.5 + shift) - 0.5; }},
      {"hash", [=](int x, int y) { return unit(hashOf(x, y, frame, seed)) - 0.5; }},
  };
}

}  // namespace strobe::oracle
