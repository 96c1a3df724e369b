// SPDX-License-Identifier: MIT
// Histories of pass times: unmeasured times are absent.
#include "live/times.h"

#include <gtest/gtest.h>

#include <cmath>

namespace strobe::live {
namespace times_test {

graph::FrameResult frame(std::vector<graph::StepTime> times, double total) {
  graph::FrameResult result;
  result.times = std::move(times);
  result.gpu_ms = total;
  return result;
}

TEST(Times, FirstFrameIsLeftOut) {
  TimeHistory history;
  history.add(frame({{"a", 100, 1}}, 100));
  EXPECT_FALSE(history.total().latest());
  EXPECT_TRUE(history.lastIsVoid());
  EXPECT_TRUE(std::isnan(history.passes()[0].ms[0]));
  history.add(frame({{"a", 2, 1}}, 3));
  EXPECT_DOUBLE_EQ(*history.passes()[0].latest(), 2);
  EXPECT_DOUBLE_EQ(*history.total().median(), 3);
  EXPECT_FALSE(history.lastIsVoid());
}

TEST(Times, FrameAfterARebuildIsLeftOut) {
  TimeHistory history;
  for (int i = 0; i < 3; ++i) history.add(frame({{"a", double(i), 1}}, i));
  history.voidNext();
  history.add(frame({{"a", 500, 1}, {"b", 1, 1}}, 500));
  EXPECT_DOUBLE_EQ(*history.passes()[0].latest(), 2);
  EXPECT_FALSE(history.passes()[1].latest());
  history.add(frame({{"b", 7, 1}, {"a", 0, 0}}, 7));
  EXPECT_EQ(history.passes()[0].name, "b");
  EXPECT_DOUBLE_EQ(*history.passes()[0].latest(), 7);
  EXPECT_DOUBLE_EQ(*history.passes()[1].latest(), 2) << "a pass that did not run has no time";
}

TEST(Times, OnlyTheLastFramesAreKept) {
  TimeHistory history;
  for (size_t i = 0; i < TimeHistory::kFrames + 10; ++i) history.add(frame({}, double(i)));
  EXPECT_EQ(history.total().ms.size(), TimeHistory::kFrames);
  EXPECT_FLOAT_EQ(history.total().ms.front(), 10);
}

}  // namespace times_test
}  // namespace strobe::live
