// SPDX-License-Identifier: MIT
// Nodes that a plan omits if a fact does not hold, and their stand-ins.
#include "plan/omission.h"

#include <gtest/gtest.h>

#include "base/json.h"
#include "plan/builder.h"
#include "plan/canonical.h"
#include "plan/plan.h"

namespace strobe::plan::test {
namespace omission_test {

using Names = std::vector<std::string>;

WithoutDesc without(const std::string& name, std::vector<std::pair<std::string, std::string>> writes) {
  return {name, std::move(writes), {"passes/x.lua", 9}};
}

Plan planned(const Builder& b, const Names& absent, const Names& taps = {}, const std::set<std::string>& outputs = {}) {
  CompileOptions options;
  options.width = 64, options.height = 32;
  options.absent = absent;
  options.taps = taps;
  options.outputs = outputs;
  return compile(b.pipeline, options);
}

Names order(const Plan& plan) {
  Names names;
  for (const PlanNode& node : plan.nodes) names.push_back(plan.pipeline.nodes[size_t(node.node)].name);
  return names;
}

std::string imageOf(const Plan& plan, const std::string& output) {
  for (const auto* images : {&plan.outputs, &plan.taps})
    for (const auto& [name, image] : *images)
      if (name == output) return plan.images[size_t(image)].name;
  return "none";
}

std::string reason(const Plan& plan, const std::string& node) {
  for (const CulledNode& culled : plan.culled)
    if (culled.name == node) return culled.reason;
  return "runs";
}

// Names of images that a step clears.
Names cleared(const Plan& plan) {
  Names names;
  for (const Step& step : plan.steps)
    if (step.kind == Step::Kind::ClearImage) names.push_back(plan.images[size_t(step.index)].name);
  return names;
}

// base -> tiles -> filter(base, tiles) -> color
Builder filtered() {
  Builder b;
  b.compute("base", {}, {"x"});
  b.compute("tiles", {{"x", "base.x"}}, {"y"});
  b.compute("filter", {{"x", "base.x"}, {"y", "tiles.y"}}, {"z"}).without = {without("motion", {{"z", "x"}})};
  b.output("color", "filter.z");
  return b;
}

TEST(Omission, WithAllFactsEverythingRuns) {
  Plan plan = planned(filtered(), {});
  EXPECT_EQ(order(plan), (Names{"base", "tiles", "filter"}));
  EXPECT_TRUE(plan.culled.empty());
}

TEST(Omission, ReadStandsInAndInputsOfTheNodeAreOmitted) {
  Plan plan = planned(filtered(), {"motion"});
  EXPECT_EQ(order(plan), Names{"base"});
  EXPECT_EQ(imageOf(plan, "color"), "base.x");
  EXPECT_EQ(reason(plan, "filter"), "nothing moves in this frame: z = x");
  EXPECT_EQ(reason(plan, "tiles"), "needed only by nodes that do not run");
  EXPECT_EQ(plan.images.size(), 1u);
}

TEST(Omission, StandInsOfStandInsAreResolved) {
  Builder b = filtered();
  b.compute("second", {{"x", "filter.z"}}, {"z"}).without = {without("motion", {{"z", "x"}})};
  b.output("other", "second.z");
  Plan plan = planned(b, {"motion"});
  EXPECT_EQ(order(plan), Names{"base"});
  EXPECT_EQ(imageOf(plan, "other"), "base.x");
}

TEST(Omission, ReadersOfTheNodeReadTheStandIn) {
  Builder b = filtered();
  b.compute("reader", {{"z", "filter.z"}}, {"w"});
  b.output("other", "reader.w");
  Plan plan = planned(b, {"motion"});
  EXPECT_EQ(order(plan), (Names{"base", "reader"}));
  EXPECT_EQ(plan.images[size_t(plan.nodes[1].reads[0])].name, "base.x");
}

// base -> mask (0 without motion) -> rays (0 where the mask is) -> end
Builder masked() {
  Builder b;
  b.compute("base", {}, {"x"});
  b.compute("mask", {{"x", "base.x"}}, {"m r8_unorm"}).without = {without("motion", {{"m", ""}})};
  PassDesc& rays = b.compute("rays", {{"x", "base.x"}, {"m", "mask.m"}}, {"a rgba16f", "b rg32ui"});
  rays.without = {without("m", {{"a", ""}, {"b", ""}})};
  rays.size.kind = SizeDesc::Kind::Port;
  rays.size.port = "x";
  b.compute("end", {{"a", "rays.a"}}, {"z"});
  b.output("color", "end.z");
  b.output("ids", "rays.b");
  return b;
}

// ---- Pixels outside the moving rectangle

// "There" is outside the moving rectangle: base -> mask (0 there) -> filter (base there) -> color
Builder reached(const std::string& filtered_format) {
  Builder b;
  b.compute("base", {}, {"x rgba16f"});
  b.compute("mask", {{"x", "base.x"}}, {"m r8_unorm"}).without = {without("moving_rect", {{"m", ""}})};
  b.compute("filter", {{"x", "base.x"}, {"m", "mask.m"}}, {"z " + filtered_format}).without = {
      without("moving_rect", {{"z", "x"}})};
  b.output("color", "filter.z");
  return b;
}

Names copied(const Plan& plan) {
  Names names;
  for (const Step& step : plan.steps)
    if (step.kind == Step::Kind::CopyOutside) {
      const VirtualImage& image = plan.images[size_t(step.index)];
      names.push_back(plan.images[size_t(image.outside)].name + " to " + image.name);
    }
  return names;
}

TEST(Omission, OutsideTheMovingRectReadsAreCopiedAndZerosCleared) {
  Plan plan = planned(reached("rgba16f"), {});
  EXPECT_EQ(order(plan), (Names{"base", "mask", "filter"}));
  EXPECT_FALSE(plan.nodes[0].in_moving_rect);
  EXPECT_TRUE(plan.nodes[1].in_moving_rect && plan.nodes[2].in_moving_rect);
  EXPECT_EQ(cleared(plan), Names{"mask.m"});
  EXPECT_EQ(copied(plan), Names{"base.x to filter.z"});
  EXPECT_TRUE(plan.images[size_t(findImage(plan, "base.x"))].usage & kUsageTransferSource);
}

TEST(Omission, StandInOutsideNeedsTheFormatOfTheWrite) {
  Plan plan = planned(reached("rgba32f"), {});
  EXPECT_TRUE(plan.nodes[1].in_moving_rect);
  EXPECT_FALSE(plan.nodes[2].in_moving_rect);
  EXPECT_TRUE(copied(plan).empty());
}

// A pass needs the moving rectangle if its stand-in does: `last` copies the filter's own output, not the filter's
// stand-in.
TEST(Omission, StandInOutsideIsNotOfAPassThatRunsThere) {
  for (const std::string format : {"rgba16f", "rgba32f"}) {
    Builder b = reached(format);
    b.compute("last", {{"x", "filter.z"}}, {"z " + format}).without = {without("moving_rect", {{"z", "x"}})};
    b.output("other", "last.z");
    Plan plan = planned(b, {});
    EXPECT_EQ(plan.nodes[3].in_moving_rect, plan.nodes[2].in_moving_rect) << format;
  }
}

// base -> filter (base outside) -> last (filter's output outside) -> color
TEST(Omission, CopiesOnlyPixelsThatAreReadOutside) {
  for (bool pointwise : {false, true})
    for (bool is_output : {false, true}) {
      Builder b;
      b.compute("base", {}, {"x rgba16f"});
      b.compute("filter", {{"x", "base.x"}}, {"z rgba16f"}).without = {without("moving_rect", {{"z", "x"}})};
      PassDesc& last = b.compute("last", {{"x", "filter.z"}}, {"z rgba16f"});
      last.without = {without("moving_rect", {{"z", "x"}})};
      last.reads[0].pointwise = pointwise;
      b.output("color", "last.z");
      if (is_output) b.output("filtered", "filter.z");
      Names copies = {"base.x to last.z"};
      if (!pointwise || is_output) copies.insert(copies.begin(), "base.x to filter.z");
      EXPECT_EQ(copied(planned(b, {})), copies) << pointwise << is_output;
    }
}

// A pixel of a smaller image is another pixel.
TEST(Omission, CopiesPixelsReadAtAnotherSize) {
  Builder b;
  b.compute("base", {}, {"x rgba16f"});
  b.compute("filter", {{"x", "base.x"}}, {"z rgba16f"}).without = {without("moving_rect", {{"z", "x"}})};
  PassDesc& last = b.compute("last", {{"x", "filter.z"}}, {"m r8_unorm"});
  last.without = {without("moving_rect", {{"m", ""}})};
  last.reads[0].pointwise = true;
  last.size = {SizeDesc::Kind::Fixed, "", "", 2, 2};
  b.output("color", "last.m");
  EXPECT_EQ(copied(planned(b, {})), Names{"base.x to filter.z"});
}

// The stop condition is read back even if no pass writes it.
TEST(Omission, StopConditionRunsOutsideToo) {
  for (bool stops : {false, true}) {
    Builder b;
    b.compute("base", {}, {"x"}).size = {SizeDesc::Kind::Fixed, "", "", 1, 1};
    b.beginLoop("times", 4, stops ? "stop.y" : "");
    PassDesc& stop = b.compute("stop", {{"x", "base.x"}}, {"y"});
    stop.size = {SizeDesc::Kind::Fixed, "", "", 1, 1};
    stop.without = {without("moving_rect", {{"y", "x"}})};
    b.compute("sum", {{"y", "stop.y"}}, {}, {"s"});
    b.endLoop();
    b.output("color", "sum.s");
    EXPECT_EQ(planned(b, {}).nodes[1].in_moving_rect, !stops);
  }
}

// These images are zero outside the moving rectangle from frame to frame; no other image may use their memory.
TEST(Omission, ZerosOutsideShareMemoryAmongThemselves) {
  Builder b;
  b.compute("a", {}, {"x"});
  b.compute("b", {{"x", "a.x"}}, {"y"}).without = {without("moving_rect", {{"y", ""}})};
  b.compute("c", {{"y", "b.y"}}, {"z"});
  b.compute("d", {{"z", "c.z"}}, {"y"}).without = {without("moving_rect", {{"y", ""}})};
  b.compute("e", {{"y", "d.y"}}, {"z"});
  b.output("color", "e.z");
  Plan plan = planned(b, {});
  auto slot = [&](const char* name) { return plan.images[size_t(findImage(plan, name))].slot; };
  EXPECT_EQ(slot("b.y"), slot("d.y"));
  EXPECT_NE(slot("b.y"), slot("a.x"));
  EXPECT_NE(slot("b.y"), slot("c.z"));
}

TEST(Omission, ZerosAreClearedOnceAndOmitDependentNodes) {
  Plan plan = planned(masked(), {"motion"});
  EXPECT_EQ(order(plan), Names{"end"});
  EXPECT_EQ(cleared(plan), (Names{"rays.a", "rays.b"}));
  const VirtualImage& ids = plan.images[size_t(findImage(plan, "rays.b"))];
  EXPECT_EQ(ids.format, "rg32ui");
  EXPECT_EQ(ids.width, 64);
  EXPECT_TRUE(ids.zero && ids.kept && ids.usage & kUsageTransferTarget && ids.usage & kUsageTransferSource);
  EXPECT_EQ(reason(plan, "rays"), "'m' is 0 everywhere: a = 0, b = 0");
  EXPECT_EQ(reason(plan, "base"), "needed only by nodes that do not run");
}

TEST(Omission, ZerosLiveFromTheirClearToTheirLastReader) {
  Plan plan = planned(masked(), {"motion"});
  const VirtualImage& a = plan.images[size_t(findImage(plan, "rays.a"))];
  EXPECT_EQ(plan.steps[size_t(a.first)].kind, Step::Kind::ClearImage);
  EXPECT_EQ(plan.steps[size_t(a.last)].kind, Step::Kind::Pass);
}

// base -> mask (0 without motion) -> layer (reads the mask) -> filter (uses `layer` and `mask` only with the mask)
Builder layered() {
  Builder b;
  b.compute("base", {}, {"x"});
  b.compute("mask", {{"x", "base.x"}}, {"m"}).without = {without("motion", {{"m", ""}})};
  b.compute("layer", {{"m", "mask.m"}}, {"l"});
  PassDesc& filter = b.compute("filter", {{"x", "base.x"}, {"layer", "layer.l"}, {"mask", "mask.m"}}, {"z"});
  for (PortDesc& read : filter.reads)
    if (read.name != "x") read.optional = true, read.needs = {"mask"};
  b.output("color", "filter.z");
  return b;
}

TEST(Omission, UselessReadIsNotWired) {
  Plan plan = planned(layered(), {"motion"});
  EXPECT_EQ(order(plan), (Names{"base", "filter"}));
  EXPECT_EQ(plan.nodes[1].reads, (std::vector<int>{plan.nodes[1].reads[0], -1, -1}));
  EXPECT_TRUE(cleared(plan).empty());
  EXPECT_EQ(order(planned(layered(), {})).size(), 4u);
}

// One of several needed images is enough.
TEST(Omission, ReadThatNeedsAnyOfSeveralStaysWithOne) {
  Builder b = layered();
  for (PortDesc& read : b.pipeline.passes.back().reads)
    if (read.name == "layer") read.needs = {"mask", "x"};
  EXPECT_EQ(order(planned(b, {"motion"})), (Names{"base", "layer", "filter"}));
}

TEST(Omission, NeedsAreChecked) {
  auto refused = [](const std::string& needed, bool optional) -> std::string {
    PassDesc pass = layered().pipeline.passes.back();
    for (PortDesc& read : pass.reads)
      if (read.name == "layer") read.needs = {needed}, read.optional = optional;
    try {
      checkPass(pass);
      return "";
    } catch (const Error& error) {
      return error.what();
    }
  };
  EXPECT_EQ(refused("mask", true), "");
  EXPECT_NE(refused("fog", true).find("read 'layer' needs 'fog', which is not a read"), std::string::npos);
  EXPECT_NE(refused("mask", false).find("read 'layer' has 'needs', but is always wired"), std::string::npos);
}

TEST(Omission, NodeWithAnotherFormatOrSizeRuns) {
  Builder format = filtered();
  format.pipeline.passes[2].writes[0].format = "rgba32f";
  EXPECT_EQ(order(planned(format, {"motion"})).size(), 3u);
  Builder size = filtered();
  size.pipeline.passes[2].size = {SizeDesc::Kind::Fixed, "", "", 8, 8};
  EXPECT_EQ(order(planned(size, {"motion"})).size(), 3u);
}

TEST(Omission, TapOfAnOmittedNodeIsItsStandIn) {
  Plan plan = planned(filtered(), {"motion"}, {"filter.z"});
  EXPECT_EQ(imageOf(plan, "filter.z"), "base.x");
  Plan zeros = planned(masked(), {"motion"}, {"mask.m"});
  EXPECT_EQ(imageOf(zeros, "mask.m"), "mask.m");
  EXPECT_EQ(cleared(zeros).size(), 3u);
}

TEST(Omission, TapOfAnInputRunsTheInput) {
  EXPECT_EQ(order(planned(filtered(), {"motion"}, {"tiles.y"})), (Names{"base", "tiles"}));
}

TEST(Omission, AppliesInLoops) {
  Builder b;
  b.compute("base", {}, {"x"});
  b.beginLoop("times", 4);
  b.compute("inside", {{"x", "base.x"}}, {"y"}).without = {without("motion", {{"y", "x"}})};
  b.compute("sum", {{"y", "inside.y"}}, {}, {"s"});
  b.endLoop();
  b.output("color", "sum.s");
  Plan plan = planned(b, {"motion"});
  EXPECT_EQ(order(plan), (Names{"base", "sum"}));
  EXPECT_EQ(plan.images[size_t(plan.nodes[1].reads[0])].name, "base.x");
}

TEST(Omission, EmptyLoopIsOmitted) {
  Builder b;
  b.compute("base", {}, {"x"});
  b.beginLoop("times", 4);
  b.compute("inside", {{"x", "base.x"}}, {"y"}).without = {without("motion", {{"y", "x"}})};
  b.endLoop();
  b.output("color", "inside.y");
  EXPECT_TRUE(planned(b, {"motion"}).loops.empty());
}

TEST(Omission, StopConditionOfALoopRuns) {
  Builder b;
  b.compute("base", {}, {"x"}).size = {SizeDesc::Kind::Fixed, "", "", 1, 1};
  b.beginLoop("times", 4, "stop.y");
  PassDesc& stop = b.compute("stop", {{"x", "base.x"}}, {"y"});
  stop.size = {SizeDesc::Kind::Fixed, "", "", 1, 1};
  stop.without = {without("motion", {{"y", ""}})};
  b.compute("sum", {{"x", "base.x"}}, {}, {"s"});
  b.endLoop();
  b.output("color", "sum.s");
  EXPECT_EQ(reason(planned(b, {"motion"}), "stop"), "runs");
}

TEST(Omission, HistoriesStandInUnchanged) {
  Builder b;
  b.compute("base", {}, {"x"});
  b.compute("sum", {{"x", "base.x"}}, {}, {"s"}).updates[0].history = true;
  b.compute("filter", {{"s", "sum.s"}}, {"z"}).without = {without("motion", {{"z", "s"}})};
  b.output("color", "filter.z");
  Plan plan = planned(b, {"motion"});
  EXPECT_EQ(order(plan), (Names{"base", "sum"}));
  EXPECT_TRUE(plan.images[size_t(findImage(plan, "sum.s"))].history);
}

TEST(Omission, UnrequestedOutputsAreCulled) {
  Plan plan = planned(masked(), {}, {}, {"ids"});
  EXPECT_EQ(order(plan), (Names{"base", "mask", "rays"}));
  EXPECT_EQ(plan.outputs.size(), 1u);
  EXPECT_EQ(reason(plan, "end"), "not needed by any requested output");
}

// Plans have equal shapes if they differ only in facts that no shader and no node uses.
TEST(Omission, ShapesDifferWhereShadersDo) {
  Builder b;
  b.compute("base", {}, {"x"});
  b.output("color", "base.x");
  EXPECT_EQ(shapeOf(planned(b, {})), shapeOf(planned(b, {"motion"})));
  EXPECT_NE(shapeOf(planned(b, {})), shapeOf(planned(b, {"alpha"})));
  EXPECT_NE(shapeOf(planned(filtered(), {})), shapeOf(planned(filtered(), {"motion"})));
}

std::string refusal(const WithoutDesc& one) {
  PassDesc pass = masked().pipeline.passes[2];
  pass.without = {one};
  try {
    checkPass(pass);
  } catch (const Error& error) {
    return error.what();
  }
  return "accepted";
}

TEST(Without, IsChecked) {
  EXPECT_EQ(refusal(without("m", {{"a", "x"}, {"b", ""}})), "accepted");
  EXPECT_EQ(refusal(without("noise", {{"a", ""}, {"b", ""}})),
            "passes/x.lua:9: pass 'rays' if_no: 'noise' must be either a fact or a read");
  EXPECT_EQ(refusal(without("m", {{"a", ""}})), "passes/x.lua:9: pass 'rays' if_no: 'b' is missing");
  EXPECT_EQ(refusal(without("m", {{"a", ""}, {"b", "x"}})),
            "passes/x.lua:9: pass 'rays' if_no: 'b' and 'x' hold different numbers");
  EXPECT_EQ(refusal(without("m", {{"a", "y"}, {"b", ""}})),
            "passes/x.lua:9: pass 'rays' if_no: 'y' is not a read that is always wired");
}

// An image is cleared directly before its pass, so that other images use its memory until then.
TEST(Cleared, IsZeroWhenItsPassBegins) {
  Builder b;
  b.compute("base", {}, {"x"});
  b.compute("sparse", {{"x", "base.x"}}, {"y"});
  b.compute("end", {{"y", "sparse.y"}}, {"z"});
  b.output("color", "end.z");
  b.pipeline.passes.at(1).writes.at(0).cleared = true;
  Plan plan = planned(b, {});
  ASSERT_EQ(plan.steps.size(), 5u);  // base, clear, sparse, end, read-back
  EXPECT_EQ(plan.steps[1].kind, Step::Kind::ClearImage);
  EXPECT_EQ(plan.images[size_t(plan.steps[1].index)].name, "sparse.y");
  EXPECT_EQ(plan.images[size_t(plan.steps[1].index)].first, 1);
  uint32_t waited = 0;
  for (const Barrier& barrier : plan.steps[2].barriers) waited |= barrier.src_stages;
  EXPECT_TRUE(waited & kStageTransfer);
}

}  // namespace omission_test
}  // namespace strobe::plan::test
