// SPDX-License-Identifier: MIT
// Parts of the invariant suite: the exact mean along a motion, unneeded declarations, reduction of failing cases.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "stability/box_filter.h"
#include "stability/shrink.h"
#include "stability/suite.h"
#include "stability/variants.h"

namespace strobe::stability {
namespace parts_test {

// ---- Mean along a motion

image::Image steps(int width, int height) {
  image::Image picture(width, height, 4);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      for (int c = 0; c < 4; ++c) picture.at(x, y, c) = float((x * 7 + y * 3 + c) % 11);
  return picture;
}

TEST(MeanAlong, StepGivesItsShareOfThePath) {
  image::Image picture(20, 1, 3);
  for (int x = 10; x < 20; ++x)
    for (int c = 0; c < 3; ++c) picture.at(x, 0, c) = 1;
  // Over the exposure, pixel 6 shows x from 14.5 to 6.5; 3.5 px of this path are dark.
  Mean mean = meanAlong(picture, 6, 0, 8, 0, {-1, 0});
  EXPECT_NEAR(mean.color[0], 4.5 / 8, 1e-12);
  EXPECT_DOUBLE_EQ(mean.variation[0], 1);
  EXPECT_TRUE(mean.inside);
  EXPECT_NEAR(meanAlong(picture, 6, 0, 8, 0, {0, 1}).color[0], 0, 1e-12);
  EXPECT_NEAR(meanAlong(picture, 9, 0, 8, 0, {-.5, .5}).color[0], 3.5 / 8, 1e-12);
  EXPECT_FALSE(meanAlong(picture, 15, 0, 8, 0, {-1, 0}).inside);
}

TEST(MeanAlong, EqualsTheMeanOfManySamples) {
  image::Image picture = steps(40, 40);
  const double motions[][2] = {{7.25, 0}, {0, -3.5}, {5.0625, 4.3125}, {-9.5, 2.25}, {6, 6}};
  for (const auto& d : motions)
    for (const ExposureInterval& window :
         {ExposureInterval{-1, 0}, ExposureInterval{-.5, .5}, ExposureInterval{0, 1}}) {
      double sum = 0;
      int count = 200000;
      for (int i = 0; i < count; ++i) {
        double t = window.from + (window.to - window.from) * (i + .5) / count;
        sum += picture.at(int(std::floor(20.5 - d[0] * t)), int(std::floor(19.5 - d[1] * t)), 0);
      }
      EXPECT_NEAR(meanAlong(picture, 20, 19, d[0], d[1], window).color[0], sum / count, 1e-3) << d[0] << " " << d[1];
    }
}

// ---- Declarations

// For a pipeline checked alone, unneeded declarations of its passes and values are not reported.
TEST(Stale, SinglePipelineReportsOnlyItsOwnDeclarations) {
  StabilityReport report;
  for (const char* where : {"pipeline smear", "pass shade", "color_format = fp16"})
    report.declarations[where] = {where, "linear", "rounded", 60, 0};
  report.declarations["needed"] = {"pipeline smear", "convex", "rounded", 60, 1};
  report.declarations["too few cases"] = {"pipeline smear", "still", "rounded", 59, 0};
  EXPECT_EQ(stale({report}).size(), 3u);
  std::vector<Declaration> own = stale({report}, false);
  ASSERT_EQ(own.size(), 1u);
  EXPECT_EQ(own[0].where, "pipeline smear");
}

// ---- Reduction

script::Settings settingsOf(const lab::Shot& shot) {
  script::Settings sets = shot.sets;
  std::sort(sets.begin(), sets.end());
  return sets;
}

TEST(Shrunk, KeepsTheCauseOfTheFailure) {
  lab::Shot shot = sized({}, 64, 40);
  shot.anchor = "start";
  for (const auto& [name, value] : script::Settings{{"weights", "x"},
                                                    {"scene.seed", 7},
                                                    {"scene.cards", 6},
                                                    {"scene.boxes", 2},
                                                    {"samples", 23},
                                                    {"tile", 8},
                                                    {"depth", 3}})
    shot = with(shot, name, value);
  plan::PipelineDesc pipeline;
  pipeline.params.resize(2);
  pipeline.params[0].name = "samples", pipeline.params[0].role = plan::Role::SampleCount;
  pipeline.params[1].name = "tile", pipeline.params[1].role = plan::Role::Tile;
  int tried = 0;
  auto fails = [&](const lab::Shot& one) {
    ++tried;
    auto value = [&](const std::string& name) {
      for (const auto& [set, text] : one.sets)
        if (set == name) return std::stod(plan::textOf(text));
      return 0.0;
    };
    if (one.width == 16) throw Error("too small to render");
    return value("scene.cards") >= 2 && value("samples") >= 3;
  };
  lab::Shot small = shrunk(shot, pipeline, {{"weights", "x"}}, fails, 1000);
  EXPECT_EQ(small.anchor, "end");
  EXPECT_EQ(small.width, 24);
  EXPECT_EQ(settingsOf(small), (script::Settings{{"samples", 3},
                                                 {"scene.cards", 2},
                                                 {"scene.height", 24},
                                                 {"scene.lit", 0},
                                                 {"scene.perspective", 0},
                                                 {"scene.reach", 3},
                                                 {"scene.seed", 7},
                                                 {"scene.textured", 0},
                                                 {"scene.width", 24},
                                                 {"tile", 1},
                                                 {"weights", "x"}}));
  tried = 0;
  shrunk(shot, pipeline, {}, fails, 10);
  EXPECT_EQ(tried, 10);
}

}  // namespace parts_test
}  // namespace strobe::stability
