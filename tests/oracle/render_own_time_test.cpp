// SPDX-License-Identifier: MIT
// What no layer of the capture holds: found by rays at their own time, or by layers of the ends of the exposure; and
// what more layers behind each other hold. Against the samples of a bar in closed form, and against truth of the same
// samples.
#include <fmt/format.h>

#include <cmath>

#include "oracle/render.h"

namespace strobe::oracle {
namespace render_own_time_test {

constexpr int kWidth = 64, kHeight = 12, kRow = 6, kSamples = 16;
constexpr double kLight = .8, kDark = .2;

// The bar [left, right) at the capture, which moves by d over the exposure that ends there.
struct Bar {
  std::string what;
  double left, right, d;

  lab::Shot shot() const {
    return shotOf("bar", kWidth, kHeight,
                  {{"left", left}, {"right", right}, {"d_f", d}, {"foreground", kLight}, {"background", kDark}});
  }
  // The mean of what is seen at a pixel's centre in the middle of each part of the exposure.
  double sampledAt(int x, int samples) const {
    int covered = 0;
    for (int i = 0; i < samples; ++i) {
      double shift = d * ((i + .5) / samples - 1);
      covered += left + shift <= x + .5 && x + .5 < right + shift;
    }
    return kDark + (kLight - kDark) * covered / samples;
  }
};

// It was in the picture only before the capture; it is half in and half out; it comes from outside.
const Bar kBars[] = {{"has left", 70.3, 90.3, 40}, {"leaves", 50.3, 80.3, 30}, {"comes in", 12.3, 28.3, 40}};
// It is outside at the capture, which ends the exposure, and where that begins.
const Bar kCrosses = {"crosses", 80.3, 100.3, 220};

class RenderOwnTime : public RenderTest {
 protected:
  static double largestError(const Bar& bar, const std::string& pipeline, std::vector<std::string> set = {},
                             int samples = kSamples) {
    set.insert(set.end(), {"tile=16", fmt::format("samples={}", samples)});
    const lab::Picture picture = render(with(bar.shot(), pipeline, set, "end"));
    double largest = 0;
    for (int x = 0; x < kWidth; ++x)
      largest = std::max(largest, std::abs(colorOf(picture).at(x, kRow, 0) - bar.sampledAt(x, samples)));
    return largest;
  }
};

// The capture does not see it, or not all of it; a ray at each sample's time does.
TEST_F(RenderOwnTime, FindsWhatTheCaptureDoesNotSee) {
  for (const Bar& bar : kBars) {
    EXPECT_LE(largestError(bar, "hybrid_traced", {"composite.taps=nearest"}), 1e-5) << bar.what;
  }
  EXPECT_GE(largestError(kBars[0], "hybrid_layered"), .25);
}

TEST_F(RenderOwnTime, FindsWhatCrossesThePictureBetweenTheEnds) {
  EXPECT_LE(largestError(kCrosses, "hybrid_traced", {"composite.taps=nearest"}), 1e-5);
  EXPECT_LE(largestError(kCrosses, "hybrid_traced", {"composite.taps=nearest"}, 64), 1e-5);
  EXPECT_GE(largestError(kCrosses, "hybrid_layered"), .05);
}

// However slow the bar: to a part of a pixel, as rays at the samples' times do.
TEST_F(RenderOwnTime, OfDetailMeetsEdgesBetweenPixels) {
  for (double d : {.3, .9, 2.6, 6.1}) {
    const Bar bar = {"slow", 20.27, 41.73, d};
    const std::string what = fmt::format("{} px", d);
    EXPECT_LE(largestError(bar, "hybrid_traced"), 1e-5) << what;
    EXPECT_LE(largestError(bar, "hybrid_traced", {"composite.taps=nearest"}), 1e-5) << what;
    EXPECT_GE(largestError(bar, "hybrid_layered"), .02) << what;
  }
}

// Texture too: as truth of the same samples, of which there may be more than 32. Where samples lie farther apart than
// `detail_below` texels are blended.
TEST_F(RenderOwnTime, OfDetailMeetsTextureBetweenPixels) {
  auto rendered = [](double speed, const std::string& samples, const std::string& pipeline,
                     std::vector<std::string> set = {}) {
    set.push_back("samples=" + samples);
    return render(with(shotOf("../stability/passage", 96, 54, {{"speed", speed}, {"angle", 17}}), pipeline, set));
  };
  for (auto [speed, samples] : {std::pair{.4, "16"}, {3.0, "16"}, {3.0, "64"}, {20.0, "64"}}) {
    const lab::Picture truth = rendered(speed, samples, "ground_truth", {"times=midpoint"});
    const lab::Picture best = rendered(speed, samples, "hybrid_traced");
    EXPECT_LE(oracle::largestDifference(colorOf(best), colorOf(truth)), 1e-5) << speed << ", " << samples << " samples";
  }
  const lab::Picture truth = rendered(20, "16", "ground_truth", {"times=midpoint"});
  EXPECT_GE(oracle::largestDifference(colorOf(rendered(20, "16", "hybrid_traced")), colorOf(truth)), .01);
}

// Raster rounds places: at some pixels of the cage's wires it sees one where rays pass beside it, at some the other way
// round. What rays at rest know of a pixel is what they see there themselves.
TEST_F(RenderOwnTime, SilhouettesAtRestAreThoseOfRays) {
  lab::Shot shot = with(shotOf("../objects/caged_fan", 320, 180, {}), "hybrid_traced", {}, "end");
  const lab::Picture known = render(shot);
  shot.model_everything = true;  // every ray asks for what is at rest too
  EXPECT_LE(oracle::largestDifference(colorOf(known), colorOf(render(shot))), 1e-4)
      << "rounding; a wrong pixel is off by .3";
}

}  // namespace render_own_time_test
}  // namespace strobe::oracle
