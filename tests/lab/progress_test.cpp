// SPDX-License-Identifier: MIT
// Progress of a frame with several loops.
#include <gtest/gtest.h>

#include "oracle/render.h"

namespace strobe::lab {
namespace progress_test {

class FrameProgress : public oracle::RenderTest {
 protected:
  // Reported (done, of) for a shot's picture, and the number of its loops.
  std::vector<std::pair<int, int>> reported_;
  size_t loops_ = 0;

  void draw(const Shot& shot) {
    reported_.clear();
    Picture picture = bench().render(shot, [&](int done, int of) { reported_.push_back({done, of}); });
    loops_ = picture.frame.iterations.size();
  }
  void expectOneTotal(int least) const {
    ASSERT_FALSE(reported_.empty());
    int before = 0;
    for (auto [done, of] : reported_) {
      EXPECT_EQ(of, reported_.front().second) << "one total";
      EXPECT_GT(done, before);
      before = done;
    }
    EXPECT_EQ(before, reported_.front().second) << "the end is the total";
    EXPECT_GE(before, least);
  }
};

// Truth has a loop of first samples and a loop of the remaining samples.
TEST_F(FrameProgress, TruthCountsItsSamplesToOneTotal) {
  Shot shot = oracle::shotOf("half_plane", 48, 4, {{"edge", 24}, {"d_f", 20}});
  draw(oracle::with(shot, "ground_truth", {"samples=256"}));
  EXPECT_GT(loops_, 1u) << "the test needs several loops";
  expectOneTotal(256);
  shot.aa = 2;
  draw(oracle::with(shot, "ground_truth", {"samples=64", "mode=rays"}));
  expectOneTotal(128);
}

}  // namespace progress_test
}  // namespace strobe::lab
