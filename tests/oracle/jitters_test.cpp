// SPDX-License-Identifier: MIT
// Tests the definition of a published jitter. render_gathers_test.cpp compares the renderer with the definitions.
#include "oracle/jitters.h"

#include <gtest/gtest.h>

#include <array>

namespace strobe::oracle {
namespace jitters_test {

// Values published with the formula, for integer pixels.
TEST(Jitters, InterleavedGradientNoiseHasItsPublishedValues) {
  const std::array<std::array<double, 3>, 5> table = {
      {{1, 0, .555713}, {0, 1, .309269}, {1, 1, .864983}, {7, 3, .817801}, {100, 200, .544752}}};
  for (const auto& [x, y, value] : table) EXPECT_NEAR(ignJitter(int(x), int(y)) + 0.5, value, 5e-7) << x << " " << y;
}

}  // namespace jitters_test
}  // namespace strobe::oracle
