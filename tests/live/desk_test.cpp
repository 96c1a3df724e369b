// SPDX-License-Identifier: MIT
// What the window works on, without a window.
#include "live/desk.h"

#include "oracle/render.h"

namespace strobe::live {
namespace desk_test {

using DeskTest = oracle::RenderTest;

// The first frame pays for its pipelines: it is drawn once more, so that its times are there before anything changes.
TEST_F(DeskTest, TimesAreKnownBeforeAnyChange) {
  DeskOptions options;
  options.shot = oracle::with(oracle::shotOf("bar", 32, 16), "none");
  Desk desk(bench(), options);
  EXPECT_TRUE(desk.turn());
  EXPECT_FALSE(desk.a().times.total().latest());
  EXPECT_TRUE(desk.busy());
  EXPECT_TRUE(desk.turn());
  EXPECT_TRUE(desk.a().times.total().latest());
  EXPECT_FALSE(desk.busy());
  EXPECT_EQ(desk.a().frames_drawn, 2);
}

}  // namespace desk_test
}  // namespace strobe::live
