// SPDX-License-Identifier: MIT
// Rays for a share of the pixels: never more of them, spent where they are worth most, and what layers say elsewhere.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "oracle/render.h"

namespace strobe::oracle {
namespace render_budget_test {

constexpr int kWidth = 64, kHeight = 36;

class RenderBudget : public RenderTest {
 protected:
  static lab::Shot moving(const std::string& scene, const Numbers& numbers = {}) {
    return shotOf(scene, kWidth, kHeight, numbers);
  }
  static lab::Picture limited(const lab::Shot& shot, double share, std::vector<std::string> set = {"preset=best"}) {
    set.push_back(fmt::format("most_rays={}", share));
    return render(with(shot, "hybrid", set));
  }
  static int64_t traced(const lab::Picture& picture) {
    const std::vector<float>& values = imageOf(picture, "traced").values;
    return std::count_if(values.begin(), values.end(), [](float value) { return value >= .5f; });
  }
};

// It goes 16 px, and its right end is at the border between two pixels.
const Numbers kBar = {{"left", 20}, {"right", 42}, {"d_f", 16}};
const char* const kTracking = "../objects/tracking_parallax";

// Whatever asks for them: masks, samples that layers do not explain.
TEST_F(RenderBudget, NoMorePixelsThanTheShareHaveRays) {
  const std::vector<std::string> all_masked = {"preset=captured", "mask=none", "mask.everywhere=true"};
  for (const lab::Shot& shot : {moving(kTracking, {{"pixels", 8}}), moving("../objects/enters", {{"pixels", 14}}),
                                moving("textured_bar", kBar)}) {
    for (double share : {0., .03, .15}) {
      for (const std::vector<std::string>& set : {std::vector<std::string>{"preset=best"}, all_masked}) {
        const lab::Picture picture = limited(shot, share, set);
        const int64_t most = int64_t(share * kWidth * kHeight), pixels = traced(picture);
        EXPECT_LE(pixels, most) << shot.scene << ' ' << share;
        EXPECT_LE(counterOf(picture, "reveal.revealed") + counterOf(picture, "reveal.capped"), uint64_t(pixels));
        if (set == all_masked) continue;  // none at their own time
        EXPECT_LE(counterOf(picture, "own_time.samples"), uint64_t(16 * pixels));
      }
    }
  }
}

// Nearly all of it is used where more pixels than that have something to gain.
TEST_F(RenderBudget, TheShareIsUsed) {
  const lab::Picture picture = limited(moving(kTracking, {{"pixels", 8}}), .15);
  EXPECT_GE(double(traced(picture)), .14 * kWidth * kHeight) << "those of one rank go together; few have the same";
}

// With one more rank it would be exceeded: counted here one by one.
TEST_F(RenderBudget, TheFirstRanksHaveThem) {
  lab::Shot shot = with(moving(kTracking, {{"pixels", 8}}), "hybrid", {"preset=best", "most_rays=0.1"});
  shot.taps = {"mask_open_rank.rank"};
  const lab::Picture picture = render(shot);
  const image::UintImage& image = picture.frame.taps.at(shot.taps.front()).uints;
  ASSERT_EQ(image.channels, 1);
  const std::vector<uint32_t>& ranks = image.values;
  const std::vector<float>& marked = imageOf(picture, "traced").values;
  ASSERT_EQ(ranks.size(), marked.size());
  std::vector<uint32_t> sorted = ranks;
  std::sort(sorted.rbegin(), sorted.rend());
  const uint32_t beyond = sorted[size_t(.1 * double(sorted.size()))];  // of the first pixel that may have none
  int wrong = 0;
  for (size_t i = 0; i < ranks.size(); ++i) wrong += (marked[i] >= .5f) != (ranks[i] > beyond);
  EXPECT_EQ(wrong, 0);
  EXPECT_GT(beyond, 0u) << "not all that ask for rays have them";
}

// A bar went to where it is: what is behind its right end is uncovered nearly all the time, farther in for less.
TEST_F(RenderBudget, WhatIsUncoveredLongestIsRevealedFirst) {
  const int columns = 5;
  const lab::Picture picture =
      limited(with(moving("bar", kBar), "hybrid", {}, "close"), (columns + .5) / kWidth, {"preset=captured"});
  for (int x = 0; x < kWidth; ++x)
    EXPECT_EQ(imageOf(picture, "mask").at(x, kHeight / 2, 0) >= .5f, 42 - columns <= x && x < 42) << x;
}

// Ranks as lib/rank.glsl counts them: 256 to each doubling of the gain, which is the share of the times at which the
// wall is seen, times the channel by which it differs most; cut to a whole number.
TEST_F(RenderBudget, RanksAreThoseOfTheirFormula) {
  constexpr int kSamples = 16;
  constexpr double kBluer = .25;
  Numbers numbers = kBar;
  numbers.push_back({"bluer", kBluer});
  lab::Shot shot = with(moving("blue_behind", numbers), "hybrid",
                        {"preset=captured", "most_rays=0.5", fmt::format("samples={}", kSamples)}, "close");
  shot.taps = {"mask_uncovered_rank.rank"};
  const lab::Picture picture = render(shot);
  const image::UintImage& rank = picture.frame.taps.at(shot.taps.front()).uints;
  int masked = 0;
  for (int x = 0; x < kWidth; ++x) {
    if (rank.at(x, kHeight / 2, 0) == 0) continue;
    ++masked;
    int seen = 0;
    for (int i = 0; i < kSamples; ++i) seen += x + int((i + .5) / kSamples * 16 + .5) >= 42;
    const double gain = std::max(.001, kBluer * seen / kSamples);
    EXPECT_NEAR(rank.at(x, kHeight / 2, 0), 256 * (std::log2(gain) + 12), 1.01) << x;
  }
  EXPECT_GE(masked, 16) << "as far as the bar goes";
}

// However much a ray promises, what has one already comes first.
TEST_F(RenderBudget, NoGainHasTheFirstRank) {
  Numbers numbers = kBar;
  numbers.push_back({"bluer", 1e4});
  lab::Shot shot = with(moving("blue_behind", numbers), "hybrid", {"preset=captured", "most_rays=0.5"}, "close");
  shot.taps = {"mask_uncovered_rank.rank"};
  const std::vector<uint32_t> ranks = render(shot).frame.taps.at(shot.taps.front()).uints.values;
  EXPECT_EQ(*std::max_element(ranks.begin(), ranks.end()), 4094u);
}

// A share that is more than is asked for takes nothing away.
TEST_F(RenderBudget, EnoughIsAll) {
  const lab::Shot shot = moving("../objects/stacked", {{"pixels", 9}});
  const lab::Picture all = render(with(shot, "hybrid", {"preset=best"}));
  EXPECT_TRUE(identical(colorOf(all), colorOf(limited(shot, .9999))));
  EXPECT_GT(rmsDifference(colorOf(all), colorOf(limited(shot, .02))), 1e-4);
}

// Without any ray the picture is the composite's of what raster saw, texels blended.
TEST_F(RenderBudget, WithoutRaysLayersSayWhatIsSeen) {
  const lab::Shot shot = moving("textured_bar", kBar);
  const lab::Picture layers = render(with(shot, "hybrid", {"preset=captured", "taps=linear", "mask=none"}));
  EXPECT_LE(largestDifference(colorOf(limited(shot, 0)), colorOf(layers)), 1e-5) << "rounding of two sums";
  EXPECT_GT(counterOf(layers, "composite.fallback"), 0u) << "something is guessed";
}

// More rays, less error: those that were taken first were not worth less.
TEST_F(RenderBudget, ErrorFallsWithTheShare) {
  const lab::Shot shot = moving(kTracking, {{"pixels", 8}});
  const image::Image truth = colorOf(render(with(shot, "ground_truth", {"samples=64", "times=stratified"})));
  double before = INFINITY, first = 0, half_way = 0;
  for (double share : {0., .1, .3, .999}) {
    const double error = rmsDifference(colorOf(limited(shot, share)), truth);
    EXPECT_LT(error, before) << share;
    before = error;
    if (share == 0) first = error;
    if (share == .3) half_way = error;
  }
  EXPECT_LT(half_way - before, .5 * (first - before))
      << "three tenths of the pixels, chosen well, are worth most of it";
}

}  // namespace render_budget_test
}  // namespace strobe::oracle
