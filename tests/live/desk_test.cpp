// SPDX-License-Identifier: MIT
// The state of the window, tested without a window.
#include "live/desk.h"

#include <cmath>

#include "oracle/render.h"

namespace strobe::live {
namespace desk_test {

using DeskTest = oracle::RenderTest;

// The first frame also compiles its pipelines: it is drawn again, so that its times are known before a change.
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

double meanDifference(const image::Image& one, const image::Image& other, int x, int y) {
  double sum = 0;
  for (int c = 0; c < 3; ++c) sum += std::abs(double(one.at(x, y, c)) - other.at(x, y, c));
  return sum / 3;
}

std::vector<double> colourOf(const Side& side, int x, int y) {
  return {side.color.at(x, y, 0), side.color.at(x, y, 1), side.color.at(x, y, 2)};
}

// Values under the pointer, and their side, in every mode.
TEST_F(DeskTest, ValuesAreOfTheSideUnderThePointer) {
  DeskOptions options;
  options.shot = oracle::with(oracle::shotOf("half_plane", 32, 16, {{"edge", 24}, {"d_f", 20}}), "none");
  options.versus = "ground_truth";
  options.versus_sets = {{"samples", int64_t(5)}};
  Desk desk(bench(), options);
  EXPECT_EQ(desk.look().mode, Mode::Wipe) << "the wipe shows B from the start";
  while (desk.busy()) desk.turn();
  const int x = 12, y = 8, line = 16;
  ASSERT_NE(colourOf(desk.a(), x, y), colourOf(*desk.b(), x, y));
  auto expect = [&](int at, int window_frame, char side) {
    const std::vector<PixelValue> values = desk.valuesAt(at, y, window_frame);
    ASSERT_EQ(values.size(), 1u);
    EXPECT_EQ(values[0].side, side);
    EXPECT_EQ(values[0].port, "color");
    const Side& shown = side == 'A' ? desk.a() : *desk.b();
    for (size_t c = 0; c < 3; ++c) EXPECT_EQ(values[0].values[c], colourOf(shown, at, y)[c]) << at;
  };
  for (int at : {0, line - 1}) expect(at, 0, 'A');
  for (int at : {line, 31}) expect(at, 0, 'B');
  desk.look().wipe = 0.25;
  expect(x, 0, 'B');
  desk.setMode(Mode::Single);
  expect(x, 0, 'A');
  desk.look().single_b = true;
  expect(x, 0, 'B');
  desk.setMode(Mode::Flicker);
  expect(x, 0, 'A');
  expect(x, 12, 'B');
  desk.setMode(Mode::Difference);
  std::vector<PixelValue> values = desk.valuesAt(x, y, 0);
  ASSERT_EQ(values.size(), 3u);
  EXPECT_EQ(values[0].values[0], meanDifference(desk.a().color, desk.b()->color, x, y));
  EXPECT_EQ(values[1].side, 'A');
  EXPECT_EQ(values[2].values, colourOf(*desk.b(), x, y));
  desk.setMode(Mode::Error);
  desk.turn();
  values = desk.valuesAt(x, y, 0);
  ASSERT_EQ(values.size(), 2u);
  EXPECT_EQ(values[0].side, 'B') << "the pixel is right of the wipe line";
  EXPECT_EQ(values[0].values[0], meanDifference(desk.b()->color, desk.truth().mean(), x, y));
  EXPECT_TRUE(desk.valuesAt(32, y, 0).empty());
}

// Legends describe the colours of the picture; two halves with the same meaning share a legend.
TEST_F(DeskTest, LegendsDescribeThePicture) {
  DeskOptions options;
  options.shot = oracle::with(oracle::shotOf("half_plane", 32, 16, {{"edge", 8}, {"d_f", 20}}), "none");
  options.versus = "ground_truth";
  options.versus_sets = {{"samples", int64_t(1)}};
  Desk desk(bench(), options);
  while (desk.busy()) desk.turn();
  desk.picture(0);
  EXPECT_EQ(desk.legends()[0].kind, image::Legend::Kind::none) << "colours have no legend";
  desk.viewPort("velocity");
  while (desk.busy()) desk.turn();
  desk.picture(0);
  EXPECT_EQ(desk.legends()[0].kind, image::Legend::Kind::wheel);
  EXPECT_EQ(desk.legends()[0].high, 20);
  EXPECT_EQ(desk.legends()[1].kind, image::Legend::Kind::none);
  desk.setMode(Mode::Difference);
  desk.look().gain = 8;
  desk.picture(0);
  EXPECT_EQ(desk.legends()[0], (image::Legend{image::Legend::Kind::bar, 0, 0.125, "mean |A - B|"}));
  EXPECT_GT(image::pictureOf(desk.legends()[0]).width, 100);
}

// Frames are drawn until the value has settled, without a change of the shot. A value set by the user ends the budget.
TEST_F(DeskTest, BudgetSetsTheQuality) {
  DeskOptions options;
  options.shot = oracle::with(oracle::shotOf("bar", 32, 16), "adaptive");
  options.budget_ms = 1e6;
  Desk desk(bench(), options);
  auto settled = [&] {
    for (int i = 0; i < 100 && desk.busy(); ++i) desk.turn();
    EXPECT_FALSE(desk.busy());
    const plan::PipelineDesc& pipeline = desk.a().session->running().evaluation().pipeline;
    return std::get<double>(*plan::valueOf(pipeline, BudgetKeeper::param(desk.a())->name));
  };
  EXPECT_EQ(settled(), 1);
  EXPECT_TRUE(desk.budget().budget()->isMet());
  const int drawn = desk.a().frames_drawn;
  EXPECT_LT(drawn, 50);
  desk.turn();
  EXPECT_EQ(desk.a().frames_drawn, drawn) << "a settled picture is not drawn again";
  desk.budget().set(1e-6);
  desk.turn();
  EXPECT_EQ(settled(), 0);
  EXPECT_FALSE(desk.budget().budget()->isMet());
  desk.sides().set("quality", "0.5", "window");
  EXPECT_EQ(settled(), 0.5);
  EXPECT_EQ(desk.budget().ms(), 0);
  desk.budget().set(1e6);
  desk.sides().usePipeline("none");
  while (desk.busy()) desk.turn();
  EXPECT_EQ(BudgetKeeper::param(desk.a()), nullptr);
  desk.sides().usePipeline("adaptive");
  EXPECT_EQ(settled(), 1) << "the budget applies to the next pipeline with a quality";
}

// An orbit about the surface under the pointer keeps its depth and pixel.
TEST_F(DeskTest, OrbitKeepsTheDepthUnderThePointer) {
  DeskOptions options;
  options.shot.scene = "living_room";
  options.shot.pipeline = "none";
  options.shot.width = 96, options.shot.height = 54;
  Desk desk(bench(), options);
  auto settle = [&] {
    while (desk.busy()) desk.turn();
  };
  settle();
  for (const auto& [x, y] : {std::pair(48, 27), std::pair(20, 40), std::pair(80, 45)}) {
    ASSERT_TRUE(desk.a().depthAt(x, y));
    // The scene's camera may roll and has more than seven digits: replace it by a rounded viewpoint without roll.
    desk.sides().setViewpoint(desk.sides().viewpoint());
    settle();
    const double before = *desk.a().depthAt(x, y);
    const dvec3 pivot = desk.sides().pivotAt(dvec2(x + 0.5, y + 0.5));
    desk.sides().setViewpoint(orbited(desk.sides().viewpoint(), pivot, 0.02, 0.01));
    settle();
    EXPECT_NEAR(*desk.a().depthAt(x, y), before, 1e-4 * before) << x << ", " << y;
    desk.sides().giveCameraBack();
    settle();
  }
}

}  // namespace desk_test
}  // namespace strobe::live
