// SPDX-License-Identifier: MIT
#include "base/log.h"

#include <gtest/gtest.h>

#include "base/numbers.h"

namespace strobe {
namespace log_test {

// No rate without a previous report, and no more than 100 %.
TEST(Progress, StopsAtItsEndAndHasNoRateWithoutElapsedTime) {
  Progress progress("truth", 256, "samples");
  progress.reach(8);
  EXPECT_EQ(progress.text(clockSeconds()), "truth 8/256 samples");
  EXPECT_EQ(progress.text(clockSeconds() + 10), "truth 8/256 samples") << "no progress since the first report";
  progress.reach(108);
  EXPECT_EQ(progress.text(clockSeconds()), "truth 108/256 samples") << "no time has passed";
  EXPECT_EQ(progress.text(clockSeconds() + 10), "truth 108/256 samples  10.0/s  15 s left");
  progress.reach(300);
  EXPECT_EQ(progress.text(clockSeconds() + 10), "truth 256/256 samples  24.8/s  0 s left");
}

TEST(Counts, UseTheSingular) {
  EXPECT_EQ(countText(1, "pipeline"), "1 pipeline");
  EXPECT_EQ(countText(0, "truth"), "0 truths");
  EXPECT_EQ(countText(18, "point"), "18 points");
}

}  // namespace log_test
}  // namespace strobe
