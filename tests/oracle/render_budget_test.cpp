// SPDX-License-Identifier: MIT
// Rays for a share of the pixels: never more of them, spent where they are worth most, and what layers say elsewhere.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "oracle/render.h"

namespace strobe::oracle {
namespace {

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

const char* const kTracking = "../objects/tracking_parallax";

}  // namespace

// Whatever asks for them: masks, samples that layers do not explain, one ray for four pixels.
TEST_F(RenderBudget, NoMorePixelsThanTheShareHaveRays) {
  const std::vector<std::string> all_masked = {"preset=captured", "mask=all"}, half = {"reveal_resolution=half"};
  for (const lab::Shot& shot : {moving(kTracking, {{"pixels", 8}}), moving("../objects/enters", {{"pixels", 14}}),
                                moving("textured_bar", {{"d_f", 20}})}) {
    for (double share : {0., .03, .15}) {
      for (const std::vector<std::string>& set : {std::vector<std::string>{"preset=best"}, all_masked, half}) {
        const lab::Picture picture = limited(shot, share, set);
        const int64_t most = int64_t(share * kWidth * kHeight), pixels = traced(picture);
        EXPECT_LE(pixels, most) << shot.scene << ' ' << share;
        EXPECT_LE(counterOf(picture, "reveal.revealed") + counterOf(picture, "reveal.capped"), uint64_t(pixels));
        if (set != all_masked) EXPECT_LE(counterOf(picture, "own_time.samples"), uint64_t(16 * pixels));
      }
    }
  }
}

// Nearly all of it is used where more pixels than that have something to gain.
TEST_F(RenderBudget, TheShareIsUsed) {
  const lab::Picture picture = limited(moving(kTracking, {{"pixels", 8}}), .15);
  EXPECT_GE(double(traced(picture)), .14 * kWidth * kHeight) << "those of one rank go together; few have the same";
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
  const lab::Shot shot = moving("textured_bar", {{"d_f", 20}});
  const lab::Picture layers = render(with(shot, "hybrid", {"preset=captured", "taps=linear", "mask=none"}));
  EXPECT_LE(largestDifference(colorOf(limited(shot, 0)), colorOf(layers)), 1e-5) << "rounding of two sums";
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

}  // namespace strobe::oracle
