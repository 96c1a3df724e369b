// SPDX-License-Identifier: MIT
// Bytes that passes read and write, counted by hand.
#include "plan/traffic.h"

#include <gtest/gtest.h>

#include "plan/builder.h"

namespace strobe::plan::test {
namespace traffic_test {

constexpr uint64_t kWidth = 10, kHeight = 6, kTexels = kWidth * kHeight;

Traffic trafficOf(const Plan& plan, const std::string& name) {
  std::vector<Traffic> traffic = trafficOf(plan);
  EXPECT_EQ(traffic.size(), plan.nodes.size());
  for (size_t i = 0; i < plan.nodes.size(); ++i)
    if (plan.pipeline.nodes[size_t(plan.nodes[i].node)].name == name) return traffic[i];
  ADD_FAILURE() << name;
  return {};
}

Plan compiled(const Builder& b) {
  CompileOptions options;
  options.width = int(kWidth), options.height = int(kHeight);
  return compile(b.pipeline, options);
}

TEST(Traffic, CountsTheTexelsOfEveryPort) {
  Builder b;
  b.raster("draw", {}, {"color rgba16f", "id rg32ui"});
  b.compute("twice", {{"a", "draw.color"}, {"b", "draw.color"}}, {"x r8_unorm"}, {"sum rg32f"});
  b.output("color", "twice.x");
  Plan plan = compiled(b);
  Traffic draw = trafficOf(plan, "draw"), twice = trafficOf(plan, "twice");
  EXPECT_EQ(draw.read, 0u);
  EXPECT_EQ(draw.written, kTexels * (8 + 8 + 4)) << "colour, ids and depth";
  EXPECT_EQ(twice.read, kTexels * (8 + 8)) << "an image read by two ports counts once; also the sum";
  EXPECT_EQ(twice.written, kTexels * (1 + 8));
  EXPECT_EQ(twice.bytes(), twice.read + twice.written);
}

TEST(Traffic, CountsEachImageAtItsSizeForOneExecution) {
  Builder b;
  b.compute("all", {}, {"x"});
  PassDesc& tiles = b.compute("tiles", {{"x", "all.x"}}, {"most rg16f"});
  tiles.size = {SizeDesc::Kind::Port, "x", "side"};
  tiles.params = {intParam("side", 4, 1, 64)};
  b.beginLoop("again", 3);
  PassDesc& last = b.compute("last", {{"most", "tiles.most"}}, {"y rgba32f"});
  last.size = {SizeDesc::Kind::Fixed, "", "", 5, 1};
  b.endLoop();
  b.output("color", "last.y");
  Plan plan = compiled(b);
  EXPECT_EQ(trafficOf(plan, "tiles").read, kTexels * 4);
  EXPECT_EQ(trafficOf(plan, "tiles").written, 3 * 2 * 4u) << "10 x 6 in tiles of 4, rounded up";
  EXPECT_EQ(trafficOf(plan, "last").read, 3 * 2 * 4u);
  EXPECT_EQ(trafficOf(plan, "last").written, 5 * 16u) << "one of three iterations";
}

}  // namespace traffic_test
}  // namespace strobe::plan::test
