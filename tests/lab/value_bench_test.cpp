// SPDX-License-Identifier: MIT
// What values cost: memory that can be counted by hand, differences against the pictures themselves.
#include "lab/value_bench.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "oracle/render.h"

namespace strobe::lab {
namespace {

class ValueBench : public oracle::RenderTest {};

TEST_F(ValueBench, SettingsAreTakenApart) {
  using Settings = std::vector<std::pair<std::string, std::string>>;
  EXPECT_EQ(settingsOf("tile=8"), (Settings{{"tile", "8"}}));
  EXPECT_EQ(settingsOf("tile=8,gather.samples=3"), (Settings{{"tile", "8"}, {"gather.samples", "3"}}));
  for (const char* bad : {"tile", "=8", "tile=8,samples"}) EXPECT_THROW(settingsOf(bad), Error) << bad;
}

TEST_F(ValueBench, TellsBytesDifferencesAndLimits) {
  oracle::Numbers bar = {{"d_f", 5.03}, {"left", 16}, {"right", 32}, {"foreground", 70000}};
  Shot shot = oracle::with(oracle::shotOf("bar", 48, 8, bar), "mcguire2012", {"limit=10"});
  Picture plain = render(shot), half = render(oracle::with(shot, "mcguire2012", {"color_format=fp16"}));
  image::Image reference = oracle::colorOf(half);
  auto costs = benchValues(bench(), shot, {"velocity_format=fp16", "color_format=fp16", "limit=10"}, 2, reference);
  ASSERT_EQ(costs.size(), 4u);
  double per_pixel = costs[0].bytes_per_pixel;
  EXPECT_EQ(costs[1].bytes_per_pixel, per_pixel - 4);  // rg32f to rg16f
  EXPECT_EQ(costs[2].bytes_per_pixel, per_pixel - 8);  // rgba32f to rgba16f
  EXPECT_EQ(costs[3].bytes_per_pixel, per_pixel);
  EXPECT_EQ(costs[0].image_bytes, uint64_t(per_pixel * 48 * 8));
  EXPECT_EQ(costs[0].rms, 0);
  EXPECT_EQ(costs[3].largest, 0);
  EXPECT_NEAR(costs[2].rms, oracle::rmsDifference(oracle::colorOf(plain), reference), 1e-3);
  EXPECT_NEAR(costs[2].largest, 70000 - 65504, 0.1);  // the bar where nothing else is, a sum of 16 taps in fp32
  EXPECT_EQ(costs[2].error, 0);
  EXPECT_GT(*costs[0].error, 0);
  EXPECT_EQ(costs[2].limits.at("shade.color_clamped"), 16u * 8);
  EXPECT_TRUE(costs[0].limits.empty());
  for (const ValueCost& cost : costs) EXPECT_GT(cost.gpu_ms, 0);
  std::string table = tableOf(costs);
  EXPECT_EQ(std::count(table.begin(), table.end(), '\n'), 7) << table;  // two of the head, four rows, a limit
}

}  // namespace
}  // namespace strobe::lab
