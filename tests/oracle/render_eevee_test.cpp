// SPDX-License-Identifier: MIT
// The pipeline eevee between its two limits: one step is a gather at the middle of the exposure, many steps are an
// accumulation buffer. In between, against exposures in closed form.
#include <fmt/format.h>

#include <cmath>

#include "oracle/render.h"

namespace strobe::oracle {
namespace render_eevee_test {

constexpr int kWidth = 256, kRows = 8, kRow = 4;

class RenderEevee : public RenderTest {
 protected:
  static image::Image drawn(const lab::Shot& shot, int steps, const std::string& anchor,
                            std::vector<std::string> settings = {}) {
    settings.push_back(fmt::format("steps={}", steps));
    return colorOf(render(with(shot, "eevee", settings, anchor)));
  }

  // Largest error of a row against exact exposures.
  template <class ExactAt>
  static double worst(const image::Image& color, const ExactAt& exact, int first = 0, int last = kWidth) {
    double error = 0;
    for (int x = first; x < last; ++x) error = std::max(error, std::abs(color.at(x, kRow, 0) - exact(x)));
    return error;
  }
};

lab::Shot solids() {
  lab::Shot shot = shotOf("solids", 96, 64);
  shot.moves = {"ball=0.7,0.2,0", "box=0.6,0,0.3", "wall=-0.8,0,0", "camera=0.5,0,0"};
  return shot;
}

// --- One step

// With the anchor `centre` the middle of the exposure is the raster time: the picture equals the gather's own pipeline,
// bit for bit.
TEST_F(RenderEevee, OneStepIsAGather) {
  struct Gather {
    std::string weights, pipeline;
    std::vector<std::string> settings;
  };
  const Gather gathers[] = {{"guertin2014", "guertin2014", {}},
                            {"guertin2014", "guertin2014", {"directions=one", "jitter=ign"}},
                            {"jimenez2014", "jimenez2014", {"tile=20"}},
                            {"mcguire2012", "mcguire2012", {"directions=one"}},
                            {"uniform", "mcguire2012", {"weights=uniform"}}};
  for (const lab::Shot& shot : {solids(), shotOf("textured_bar", 96, 32, {{"left", 30}, {"right", 60}, {"d_b", -9}})})
    for (const Gather& gather : gathers) {
      std::vector<std::string> settings = gather.settings;
      settings.push_back("weights=" + gather.weights);
      const image::Image own = colorOf(render(with(shot, gather.pipeline, gather.settings, "centre")));
      EXPECT_TRUE(identical(drawn(shot, 1, "centre", settings), own)) << fmt::format("{}", fmt::join(settings, " "));
      EXPECT_FALSE(identical(own, colorOf(render(with(shot, "none", {}, "centre")))));
    }
}

// All outputs but the colour belong to the raster time, for any number of steps.
TEST_F(RenderEevee, OtherOutputsBelongToTheRasterTime) {
  for (const Anchor& anchor : anchors()) {
    const lab::Picture none = render(with(solids(), "none", {}, anchor.name));
    const lab::Picture eevee = render(with(solids(), "eevee", {}, anchor.name));
    for (const char* output : {"depth", "normal", "velocity"})
      EXPECT_TRUE(identical(imageOf(eevee, output), imageOf(none, output))) << anchor.name << ' ' << output;
  }
}

// A single step has even weight over the whole exposure, with any shutter curve.
TEST_F(RenderEevee, OneStepHasEvenWeight) {
  lab::Shot shot = shotOf("bar", kWidth, kRows);
  const image::Image even = drawn(shot, 1, "end");
  shot.shutter_curve = "triangle";
  EXPECT_TRUE(identical(drawn(shot, 1, "end"), even));
  EXPECT_FALSE(identical(drawn(shot, 2, "end"), even));
}

// --- Many steps

// Steps with motion of at most a pixel are not blurred, so 64 steps equal an accumulation buffer at the same times.
// With fewer steps the difference shrinks from one count to the next.
TEST_F(RenderEevee, ManyStepsAreAnAccumulationBuffer) {
  lab::Shot stripes = shotOf("textured_bar", 96, 8, {{"left", 30}, {"right", 60}, {"d_f", 20}, {"d_b", -12}});
  for (const lab::Shot& shot : {stripes, shotOf("wedge", 64, 64)})
    for (const Anchor& anchor : anchors()) {
      double before = 1;
      for (int steps : {1, 4, 16, 64}) {
        const image::Image many = colorOf(render(
            with(shot, "accumulation", {fmt::format("samples={}", std::max(steps, 32)), "reuse=none"}, anchor.name)));
        const double error = rmsDifference(drawn(shot, steps, anchor.name), many);
        EXPECT_LT(error, steps == 64 ? 1e-5 : before) << shot.scene << ' ' << anchor.name << ' ' << steps;
        before = error;
      }
    }
}

// Each step is shaded with the shadows at its time.
TEST_F(RenderEevee, ManyStepsEqualTruthWithMovingShadows) {
  const lab::Shot shot = shotOf("crowd", 64, 40);
  for (const Anchor& anchor : anchors()) {
    auto truth = [&](const std::string& shading) {
      return colorOf(render(with(shot, "ground_truth", {"mode=raster", "samples=32", shading}, anchor.name)));
    };
    const image::Image color = drawn(shot, 32, anchor.name), full = truth("shading=full");
    EXPECT_LT(rmsDifference(color, full), 1e-4) << anchor.name;
    EXPECT_GT(rmsDifference(truth("shading=frozen"), full), 1e-3) << anchor.name;
  }
}

// --- Closed forms

// Share of time while a bar at constant velocity covers a pixel, by taps of equal weight. In the step when the edge
// passes, the edge and each tap are rounded to pixels, half a pixel each; a tap stands for 1/16 of a step.
TEST_F(RenderEevee, CoverageIsExactToAPixel) {
  constexpr double kMoved = 40;
  lab::Shot shot = shotOf("bar", kWidth, kRows, {{"d_f", kMoved}});
  for (const Anchor& anchor : anchors())
    for (int steps : {1, 2, 3, 4, 8}) {
      const image::Image color = drawn(shot, steps, anchor.name, {"weights=uniform"});
      auto exact = [&](int x) { return barAtCentre(96, 160, kMoved, anchor.window, x); };
      EXPECT_LT(worst(color, exact), 1 / kMoved + .5 / (16 * steps) + 1e-4) << anchor.name << ' ' << steps;
    }
}

// A bar that moves right and back has no displacement over the exposure. Eight steps follow it.
TEST_F(RenderEevee, StepsFollowMotionThatTurnsBack) {
  lab::Shot shot = shotOf("bent", 96, kRows,
                          {{"left", 30}, {"right", 60}, {"before", 40}, {"after", -40}, {"light", 0}, {"dark", 0}});
  auto exact = [](int x) {
    return .45 * (barAtCentre(30, 60, 40, {-.5, 0}, x) + barAtCentre(30, 60, -40, {0, .5}, x));
  };
  const image::Image one = drawn(shot, 1, "centre", {"weights=uniform"});
  EXPECT_TRUE(identical(one, colorOf(render(with(shot, "none", {}, "centre")))));
  EXPECT_GT(worst(one, exact, 0, 96), .8);
  EXPECT_LT(worst(drawn(shot, 8, "centre", {"weights=uniform"}), exact, 0, 96), .05);
}

// With a shutter curve the steps have equal weight, and each step is even: the first of four steps under the triangle
// ends after sqrt(1/8) of the exposure.
TEST_F(RenderEevee, StepsHaveEqualWeight) {
  constexpr double kMoved = 60;
  const double first = std::sqrt(.125), ends[] = {0, first, .5, 1 - first, 1};
  lab::Shot shot = shotOf("bar", kWidth, kRows, {{"d_f", kMoved}});
  shot.shutter_curve = "triangle";
  for (const Anchor& anchor : anchors()) {
    auto exact = [&](int x) {
      double sum = 0;
      for (int k = 0; k < 4; ++k)
        sum += barAtCentre(96, 160, kMoved, {anchor.window.open + ends[k], anchor.window.open + ends[k + 1]}, x) / 4;
      return sum;
    };
    // Largest weight of a pixel: 1/(60 * .146) of a middle step.
    const double pixel = 1 / (4 * kMoved * (.5 - first));
    EXPECT_LT(worst(drawn(shot, 4, anchor.name, {"weights=uniform"}), exact), pixel + .5 / 64 + 1e-4) << anchor.name;
  }
}

}  // namespace render_eevee_test
}  // namespace strobe::oracle
