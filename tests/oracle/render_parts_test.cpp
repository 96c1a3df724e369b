// SPDX-License-Identifier: MIT
// A loop over parts of the exposure draws each part as a separate frame whose exposure is the part, bit for bit, and
// does not affect the drawings after it.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "common/source.h"
#include "oracle/render.h"

namespace strobe::oracle {
namespace render_parts_test {

const std::string kPartsThenRaster = sourceFolder() / "tests/oracle/pipelines/parts_then_raster.lua";
const std::vector<std::string> kObjects = {"ball=0.35,0.1,0", "box=0.3,0,0.15"};
const std::vector<std::string> kAll = {"ball=0.35,0.1,0", "box=0.3,0,0.15", "wall=-0.4,0,0", "camera=0.25,0,0"};

// Lit solids with shadows. At 16 frames per second the times of frames and of their parts are exact.
lab::Shot solids(const std::vector<std::string>& moves) {
  lab::Shot shot = shotOf("solids", 96, 64);
  shot.moves = moves;
  shot.fps = 16;
  shot.rest_frame = 0;
  return shot;
}

class RenderParts : public RenderTest {
 protected:
  static void expectSame(const lab::Picture& parts, const std::string& prefix, const lab::Picture& frame) {
    for (const char* output : {"color", "depth", "normal", "velocity"})
      EXPECT_TRUE(identical(imageOf(parts, prefix + output), imageOf(frame, output))) << output;
  }

  // Position of a node in the order of execution.
  static size_t place(const lab::Picture& picture, const std::string& node) {
    const auto& times = picture.frame.times;
    auto named = [&](const graph::StepTime& time) { return time.name == node; };
    return size_t(std::find_if(times.begin(), times.end(), named) - times.begin());
  }
};

// In an exposure of four frames from frame 0 on, the second half is an exposure of two frames centred on frame 3.
TEST_F(RenderParts, PartsEqualSeparateFrames) {
  for (const auto& moves : {kObjects, kAll}) {
    lab::Shot whole = with(solids(moves), kPartsThenRaster, {"parts=2"}, "start"), part = solids(moves);
    whole.exposure = 4, whole.frame = 0;
    part.exposure = 2, part.frame = 3;
    const lab::Picture alone = render(with(part, "none", {}, "centre"));
    expectSame(render(whole), "part_", alone);
    EXPECT_GT(rms(imageOf(alone, "velocity")), 1);
  }
}

// A displacement extrapolated from the frame before a part is scaled to the part's share of the exposure.
TEST_F(RenderParts, PartsExtrapolateFromTheFrameBefore) {
  lab::Shot whole = with(solids(kAll), kPartsThenRaster, {"part_gbuffer.displacement=extrapolated"}, "start");
  lab::Shot part = with(solids(kAll), "none", {"gbuffer.displacement=extrapolated"}, "centre");
  whole.exposure = 4, whole.frame = 0;
  part.exposure = 2, part.frame = 3;
  expectSame(render(whole), "part_", render(part));
}

// After the loop, poses, rays and frame data belong to the frame again, with every ray tracing backend. More than four
// parts are waited for one by one.
TEST_F(RenderParts, PartsDoNotChangeTheFrame) {
  for (const std::string& backend : backends())
    for (const Anchor& anchor : anchors())
      for (int count : {3, 7}) {
        SCOPED_TRACE(fmt::format("{} {} {}", backend, anchor.name, count));
        lab::Shot shot = solids(kAll);
        shot.backend = backend;
        const lab::Picture frame = render(with(shot, "none", {}, anchor.name));
        const lab::Picture parts = render(with(shot, kPartsThenRaster, {fmt::format("parts={}", count)}, anchor.name));
        expectSame(parts, "", frame);
        EXPECT_FALSE(identical(imageOf(parts, "part_color"), colorOf(frame)));
        EXPECT_EQ(iterationsOf(parts, "parts"), count);
        EXPECT_LT(place(parts, "part_shade"), place(parts, "shade"));
      }
}

// The parts have equal weight under the curve, whose integral is the square of the time: the last of four begins at
// sqrt(3/4).
TEST_F(RenderParts, PartsHaveEqualWeight) {
  lab::Shot shot =
      with(shotOf("bar", 96, 8, {{"left", 30}, {"right", 60}, {"d_f", 20}}), kPartsThenRaster, {"parts=4"});
  shot.shutter_curve = "0,1";
  const image::Image velocity = imageOf(render(shot), "part_velocity");
  EXPECT_NEAR(velocity.at(48, 4, 0), 20 * (1 - std::sqrt(.75)), 1e-4);
}

}  // namespace render_parts_test
}  // namespace strobe::oracle
