// SPDX-License-Identifier: MIT
// The masks in the renderer: marked pixels against the required ones, and the error with each mask against truth.
#include <fmt/format.h>

#include <cmath>
#include <map>

#include "common/home.h"
#include "common/source.h"
#include "oracle/render.h"

namespace strobe::oracle {
namespace render_masks_test {

using Columns = std::vector<int>;

// The marked pixels of the middle row.
Columns markedIn(const lab::Picture& picture) {
  const image::Image& mask = imageOf(picture, "mask");
  Columns columns;
  for (int x = 0; x < mask.width; ++x)
    if (mask.at(x, mask.height / 2, 0) > .5f) columns.push_back(x);
  return columns;
}

Columns range(int first, int end) {
  Columns columns;
  for (int x = first; x < end; ++x) columns.push_back(x);
  return columns;
}

int countMarked(const image::Image& mask) {
  int count = 0;
  for (float value : mask.values) count += value > .5f;
  return count;
}

int countMissing(const image::Image& mask, const image::Image& from) {
  int count = 0;
  for (size_t i = 0; i < mask.values.size(); ++i) count += mask.values[i] > .5f && from.values[i] < .5f;
  return count;
}

class RenderMasks : public RenderTest {
 protected:
  static lab::Picture marked(const lab::Shot& shot, const std::string& mask, std::vector<std::string> settings = {},
                             const std::string& anchor = "end") {
    settings.insert(settings.end(), {"mask=" + mask, "tile=8", "limit=0.25"});
    return render(with(shot, hybridSteps(), settings, anchor));
  }
  static image::Image truth(const lab::Shot& shot) {
    return colorOf(render(with(shot, "ground_truth", {"samples=256", "mark_regions=false"})));
  }
};

// A bar [96, 160) that moves by 20 px marks the band [R - d, R), and one pixel more where the silhouette arrives at the
// very end of the exposure.
TEST_F(RenderMasks, MarkedBandsHaveTheLengthOfTheMotion) {
  lab::Shot right = shotOf("bar", 256, 16, {{"d_f", 20}}), left = shotOf("bar", 256, 16, {{"d_f", -20}});
  for (const char* own : {"own_edge=true", "own_edge=false"})
    EXPECT_EQ(markedIn(marked(right, "paper", {"edge=sobel", own})), range(139, 160)) << own;
  EXPECT_EQ(markedIn(marked(left, "paper", {"edge=sobel"})), range(96, 117));
  EXPECT_EQ(markedIn(marked(right, "disocclusion")), range(139, 160));
  // Edges two pixels wide on the near side are reached a pixel earlier.
  EXPECT_EQ(markedIn(marked(right, "paper", {"edge=laplacian", "edge.kernel=log"})), range(138, 160));
}

// Half of 40 px to either side: both bands. Edges by Roberts lie half a pixel to the right: a left silhouette falls on
// the background, where the mask does not read edges.
TEST_F(RenderMasks, EdgeDetectorsGiveTheSameMask) {
  lab::Shot bar = shotOf("bar", 256, 16, {{"d_f", 40}});
  Columns both = range(96, 117), right = range(139, 160);
  both.insert(both.end(), right.begin(), right.end());
  for (const char* detector : {"canny", "id", "laplacian", "plane", "prewitt", "scharr", "silhouette", "sobel"})
    EXPECT_EQ(markedIn(marked(bar, "paper", {fmt::format("edge={}", detector)}, "centre")), both) << detector;
  EXPECT_EQ(markedIn(marked(bar, "paper", {"edge=roberts"}, "centre")), right);
}

TEST_F(RenderMasks, MasksStayWithinTheBoundOverAStaticBackground) {
  const Strips strips{{96, 160, 20, {1}}, {-kInfinity, kInfinity, 0, {0}}};
  for (const Anchor& anchor : anchors())
    for (const char* mask : {"paper", "disocclusion", "moving", "all"}) {
      lab::Picture picture = marked(shotOf("bar", 256, 16), mask, {"edge=silhouette"}, anchor.name);
      // Each border of the bar is off by one of 16 samples: half a sample by time, half by rounding to pixels.
      expectWithin(
          colorOf(picture), [&](int x, int) { return exposeCentre(strips, anchor.window, x); },
          [](const Exposure& e) { return e.variation / 16 + 1e-4; }, fmt::format("{} {}", anchor.name, mask));
    }
}

// All surfaces here are nearer than a metre.
TEST_F(RenderMasks, TilesHoldTheFarthestMovingDepth) {
  constexpr int kTile = 8;
  lab::Shot shot = shotOf("crowd", 64, 40, {{"scale", .01}});
  shot.taps = {"tile_velocities.farthest"};
  const lab::Picture picture = marked(shot, "disocclusion");
  const image::Image &farthest = picture.frame.taps.at(shot.taps[0]).floats, &depth = imageOf(picture, "depth"),
                     &velocity = imageOf(picture, "velocity");
  int moving = 0, still = 0;
  for (int y = 0; y < farthest.height; ++y)
    for (int x = 0; x < farthest.width; ++x) {
      float expected = 0;
      for (int j = kTile * y; j < std::min(kTile * y + kTile, depth.height); ++j)
        for (int i = kTile * x; i < std::min(kTile * x + kTile, depth.width); ++i)
          if (velocity.at(i, j, 0) != 0 || velocity.at(i, j, 1) != 0) expected = std::max(expected, depth.at(i, j, 0));
      EXPECT_EQ(farthest.at(x, y, 0), expected) << x << ' ' << y;
      ++(expected > 0 ? moving : still);
    }
  EXPECT_GT(moving, 10);
  EXPECT_GT(still, 0);
}

// --- Gaps

// Displaced by 20 px every tooth lies on the next one; by 5 or 15 px half of a tooth lies in a gap. One tap finds
// nothing; of four taps one finds the right half of each tooth and another the left half.
TEST_F(RenderMasks, SeveralTapsFindGapsThatOneTapMisses) {
  lab::Shot comb = shotOf("comb", 128, 16);
  lab::Picture one = marked(comb, "paper", {"edge=silhouette"});
  lab::Picture four = marked(comb, "paper", {"edge=silhouette", "mask_taps=4"});
  int in_teeth = 0, found = 0;
  for (int x = 20; x < 88; ++x) {  // from 108 on, pixels leave the picture, which marks them; stops 20 px before
    bool tooth = (x - 4) % 20 < 10;
    in_teeth += tooth;
    EXPECT_LT(imageOf(one, "mask").at(x, 8, 0), .5f) << x;
    found += tooth && imageOf(four, "mask").at(x, 8, 0) > .5f;
  }
  EXPECT_EQ(found, in_teeth);
  image::Image exact = truth(comb);
  double without = rmsDifference(colorOf(one), exact), with_taps = rmsDifference(colorOf(four), exact);
  EXPECT_LE(with_taps, .5 * without) << with_taps << " " << without;
}

// A surface that moves by more pixels than an integer can hold leaves the picture. Disocclusions by the other surfaces
// are still marked.
TEST_F(RenderMasks, HugeDisplacementsKeepOtherDisocclusions) {
  lab::Shot slow = shotOf("crowd", 64, 40, {{"scale", 1e-8}}), fast = slow;
  slow.moves = {"near=0,0,0"}, fast.moves = {"near=1e5,0,0"};
  for (const Anchor& anchor : anchors()) {
    auto maskOf = [&](const lab::Shot& shot) {
      return render(with(shot, hybridSteps(), {"mask=disocclusion", "tile=8", "limit=auto"}, anchor.name));
    };
    const lab::Picture without = maskOf(slow), with_it = maskOf(fast);
    int marked = 0, missing = 0, beyond = 0;
    for (int y = 0; y < 40; ++y)
      for (int x = 0; x < 64; ++x) {
        const bool is_it = std::abs(imageOf(with_it, "velocity").at(x, y, 0)) > 1e12;
        const bool is_marked = !is_it && imageOf(without, "mask").at(x, y, 0) > .5f;
        beyond += is_it, marked += is_marked;
        missing += is_marked && imageOf(with_it, "mask").at(x, y, 0) < .5f;
      }
    EXPECT_EQ(missing, 0) << anchor.name;
    EXPECT_GE(marked, 100) << anchor.name;
    EXPECT_GE(beyond, 50) << anchor.name;
  }
}

// Without rays and with displacements per tile and layer, a hybrid equals the post-process filter that blurs its
// layers.
TEST_F(RenderMasks, HybridWithoutRaysEqualsItsGather) {
  const lab::Shot crowd = shotOf("crowd", 64, 40);
  const std::vector<std::string> none = {"mask=none", "composite=alpha_over", "tiles=separate"};
  struct Gather {
    std::string weights, pipeline;
    std::vector<std::string> settings;
  };
  for (const Gather& gather : {Gather{"mcguire2012", "mcguire2012", {"weights=mcguire2012"}},
                               {"uniform", "mcguire2012", {"weights=uniform"}},
                               {"jimenez2014", "jimenez2014", {"cheap=false"}},
                               {"guertin2014", "guertin2014", {"uniform_path=false", "directions=one"}}})
    for (const Anchor& anchor : anchors()) {
      std::vector<std::string> hybrid = none, alone = gather.settings;
      hybrid.insert(hybrid.end(), {"weights=" + gather.weights, "tile=8"});
      alone.push_back("tile=8");
      EXPECT_TRUE(identical(colorOf(render(with(crowd, hybridSteps(), hybrid, anchor.name))),
                            colorOf(render(with(crowd, gather.pipeline, alone, anchor.name)))))
          << gather.weights << " " << anchor.name;
    }
}

// --- Cost and error

TEST_F(RenderMasks, MovingMaskContainsTheOtherMasks) {
  for (const std::string scene : {"crowd", "comb", "slanted_quad"})
    for (const Anchor& anchor : anchors()) {
      lab::Shot shot = shotOf(scene, 64, 40);
      image::Image moving = imageOf(marked(shot, "moving", {}, anchor.name), "mask");
      for (const char* taps : {"mask_taps=1", "mask_taps=4"}) {
        image::Image seed = imageOf(marked(shot, "paper", {taps, "own_edge=false"}, anchor.name), "mask");
        EXPECT_EQ(countMissing(seed, moving), 0) << scene << " " << anchor.name << " " << taps;
        EXPECT_GE(countMarked(seed), 1) << scene;
      }
      image::Image relative = imageOf(marked(shot, "disocclusion", {}, anchor.name), "mask");
      EXPECT_EQ(countMissing(relative, moving), 0) << scene << " " << anchor.name;
    }
}

TEST_F(RenderMasks, StaticPixelsAreNotMarked) {
  lab::Shot still = shotOf("crowd", 64, 40, {{"speed", 0}});
  for (const char* mask : {"none", "paper", "disocclusion", "moving"})
    EXPECT_EQ(countMarked(imageOf(marked(still, mask), "mask")), 0) << mask;
  // The bar moves by 20 px: tiles farther than that from its path stay unmarked.
  Columns moving = markedIn(marked(shotOf("bar", 256, 16), "moving"));
  EXPECT_LE(moving.front(), 96 - 20);
  EXPECT_GE(moving.front(), 96 - 20 - 2 * 8);
  EXPECT_GE(moving.back(), 159);
  EXPECT_LE(moving.back(), 160 + 2 * 8);
}

// Invalid displacements: NaN counts as 0, infinity as motion.
TEST_F(RenderMasks, InvalidDisplacementsCountAsZeroOrAsMotion) {
  const Path project = sourceFolder() / "tests/oracle/project";
  lab::Workbench damaged(Home({project, home().shipped()}, home().data(), home().program()), bench());
  const lab::Picture picture = damaged.render(with(shotOf("bar", 128, 16), "damaged_masks", {}, "end"));
  for (int x = 0; x < 8; ++x) {
    const bool moves = x / 2 == 1 || x / 2 == 2 || x % 2 == 1;  // infinite, or by 5 px down
    EXPECT_EQ(imageOf(picture, "mask").at(x, 8, 0) > .5f, moves) << x;
  }
}

// Silhouettes between surfaces with equal motion uncover nothing.
TEST_F(RenderMasks, EqualMotionIsNotMarkedByRelativeMotion) {
  lab::Shot alike = shotOf(
      "cards", 128, 8,
      {{"left0", 40}, {"right0", 72}, {"z0", 0}, {"d0", 16}, {"left1", -80}, {"right1", 208}, {"z1", -20}, {"d1", 16}});
  EXPECT_EQ(countMarked(imageOf(marked(alike, "disocclusion"), "mask")), 0);
  EXPECT_GT(countMarked(imageOf(marked(alike, "paper"), "mask")), 0);
}

// Cards that move across each other. The rms error is .33 without a mask, .063 with `paper`, .057 with `disocclusion`
// and .070 with the larger masks. The larger masks are worse at 36 pixels, most of all at the left border, where the
// band enters the picture: no layer holds the band there, so the revealed background is taken instead of a fallback.
TEST_F(RenderMasks, DisocclusionMaskHasLessErrorThanLargerMasks) {
  lab::Shot crowd = shotOf("crowd", 64, 40);
  image::Image exact = truth(crowd);
  std::map<std::string, double> error;
  for (const char* mask : {"none", "paper", "disocclusion", "moving", "all"}) {
    lab::Picture picture = marked(crowd, mask, {"edge=silhouette", "samples=32"});
    error[mask] = rmsDifference(colorOf(picture), exact);
  }
  for (const char* mask : {"paper", "disocclusion", "moving", "all"}) EXPECT_LE(error[mask], error["none"] / 4) << mask;
  EXPECT_LE(error["disocclusion"], error["paper"]);
  EXPECT_LE(error["disocclusion"], error["all"]);
  EXPECT_NEAR(error["moving"], error["all"], 1e-3);  // static pixels that stay uncovered need no rays
}

}  // namespace render_masks_test
}  // namespace strobe::oracle
