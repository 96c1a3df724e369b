// SPDX-License-Identifier: MIT
// The accumulation buffer equals truth at the same times: against closed forms, and against rasterised truth, which
// neither keeps the static background nor reuses colours.
#include <fmt/format.h>

#include "oracle/render.h"

namespace strobe::oracle {
namespace render_accumulation_test {

constexpr int kWidth = 128, kRows = 8, kRow = 4;

class RenderAccumulation : public RenderTest {
 protected:
  static lab::Shot solids(const std::vector<std::string>& moves) {
    lab::Shot shot = shotOf("solids", 96, 64);
    shot.moves = moves;
    return shot;
  }

  static image::Image accumulated(const lab::Shot& shot, const std::vector<std::string>& settings,
                                  const std::string& anchor) {
    return colorOf(render(with(shot, "accumulation", settings, anchor)));
  }
};

const std::vector<std::string> kObjects = {"ball=0.7,0.2,0", "box=0.6,0,0.3"};
const std::vector<std::string> kAll = {"ball=0.7,0.2,0", "box=0.6,0,0.3", "wall=-0.8,0,0", "camera=0.5,0,0"};

// Cards behind each other that move apart before a static wall; hidden surfaces become visible. No edge passes a
// pixel's centre at a sample time.
TEST_F(RenderAccumulation, AveragesTheVisibleSurfacesOfAllTimes) {
  const Strips stack = {{32, 96, 20, {.9}}, {32, 96, 16, {.6}}, {32, 96, 12, {.3}}, {-kInfinity, kInfinity, 0, {.1}}};
  constexpr int kSamples = 24;
  Numbers numbers;
  for (size_t k = 0; k < 3; ++k)
    for (const auto& [name, value] :
         Numbers{{"left", stack[k].left}, {"right", stack[k].right}, {"d", stack[k].d}, {"v", stack[k].pattern.even}})
      numbers.push_back({fmt::format("{}{}", name, k), value});
  for (const Anchor& anchor : anchors())
    for (const char* reuse : {"none", "blended", "detailed"}) {
      image::Image color =
          accumulated(shotOf("cards", kWidth, kRows, numbers),
                      {fmt::format("samples={}", kSamples), fmt::format("reuse={}", reuse)}, anchor.name);
      for (int x = 0; x < kWidth; ++x) {
        double mean = 0;
        for (int i = 0; i < kSamples; ++i) {
          double t = anchor.window.open + (anchor.window.close - anchor.window.open) * (i + .5) / kSamples;
          mean += seenAt(stack, x + .5, t).colour / kSamples;
        }
        EXPECT_NEAR(color.at(x, kRow, 0), mean, 1e-5) << anchor.name << ' ' << reuse << ' ' << x;
      }
    }
}

// With shading at each time the picture is rasterised truth of as many samples: both draw the same times.
TEST_F(RenderAccumulation, EqualsTruthOfAsManySamples) {
  for (const auto& moves : {kObjects, kAll})
    for (const Anchor& anchor : anchors()) {
      lab::Shot shot = solids(moves);
      image::Image truth =
          colorOf(render(with(shot, "ground_truth", {"mode=raster", "samples=7", "shading=frozen"}, anchor.name)));
      image::Image color = accumulated(shot, {"samples=7", "reuse=none"}, anchor.name);
      EXPECT_GT(rmsDifference(truth, colorOf(render(with(shot, "none")))), .005);
      EXPECT_LT(oracle::largestDifference(truth, color), 1e-5) << anchor.name << ' ' << moves.size();
    }
}

// Reused colours are those in the raster image: smooth shading has a small error, and fewer samples are shaded.
TEST_F(RenderAccumulation, ReusesColoursOfTheRasterImage) {
  for (const auto& moves : {kObjects, kAll}) {
    lab::Shot shot = solids(moves);
    lab::Picture anew = render(with(shot, "accumulation", {"reuse=none"}, "centre"));
    lab::Picture kept = render(with(shot, "accumulation", {}, "centre"));
    lab::Picture blended = render(with(shot, "accumulation", {"reuse=blended"}, "centre"));
    EXPECT_LT(rmsDifference(colorOf(anew), colorOf(kept)), .002);
    EXPECT_LT(rmsDifference(colorOf(anew), colorOf(blended)), .01);
    const char* const kShaded = "accumulate_moving.shaded";
    EXPECT_LT(counterOf(kept, kShaded), counterOf(anew, kShaded) * 3 / 4);
    EXPECT_LE(counterOf(blended, kShaded), counterOf(kept, kShaded));
    EXPECT_EQ(counterOf(kept, "over_background.samples"), counterOf(anew, "over_background.samples"));
  }
}

// Before a static camera only moving surfaces are drawn, and rays find the background once, not for each sample.
TEST_F(RenderAccumulation, FindsTheStaticBackgroundOnce) {
  lab::Picture few = render(with(solids(kObjects), "accumulation", {"samples=2"}, "centre"));
  lab::Picture many = render(with(solids(kObjects), "accumulation", {"samples=32"}, "centre"));
  EXPECT_GT(counterOf(few, "static_background.rays"), 0u);
  EXPECT_EQ(counterOf(few, "static_background.rays"), counterOf(many, "static_background.rays"));
  EXPECT_EQ(counterOf(render(with(solids(kAll), "accumulation", {}, "centre")), "static_background.rays"), 0u);
}

}  // namespace render_accumulation_test
}  // namespace strobe::oracle
