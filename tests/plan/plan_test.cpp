// SPDX-License-Identifier: MIT
// Order, culling, sizes, memory, parameters, canonical form and refusals of a compiled pipeline.
#include "plan/plan.h"

#include <gtest/gtest.h>

#include <set>

#include "base/json.h"
#include "plan/builder.h"
#include "plan/canonical.h"
#include "plan/formats.h"
#include "plan/random_pipeline.h"
#include "plan/settings.h"

namespace strobe::plan::test {
namespace plan_test {

CompileOptions optionsOf(int width, int height) {
  CompileOptions options;
  options.width = width, options.height = height;
  return options;
}

Plan compiled(const PipelineDesc& pipeline) { return compile(pipeline, optionsOf(64, 32)); }

std::vector<std::string> order(const Plan& plan) {
  std::vector<std::string> names;
  for (const PlanNode& node : plan.nodes) names.push_back(plan.pipeline.nodes[node.node].name);
  return names;
}

const VirtualImage& image(const Plan& plan, const std::string& name) { return plan.images.at(findImage(plan, name)); }

std::string refusal(const PipelineDesc& pipeline, const CompileOptions& options = optionsOf(64, 32)) {
  try {
    compile(pipeline, options);
  } catch (const Error& error) {
    return error.what();
  }
  return "accepted";
}

std::string refusalOf(const PassDesc& pass) {
  try {
    checkPass(pass);
  } catch (const Error& error) {
    return error.what();
  }
  return "accepted";
}

using Names = std::vector<std::string>;

// first -> second -> third -> color
Builder chain() {
  Builder b;
  b.compute("first", {}, {"x"});
  b.compute("second", {{"x", "first.x"}}, {"y"});
  b.compute("third", {{"y", "second.y"}}, {"z"});
  b.output("color", "third.z");
  return b;
}

TEST(Order, FollowsDependenciesThenCalls) {
  Builder b;
  b.compute("late", {{"x", "early.x"}}, {"y"});
  b.compute("other", {}, {"x"});
  b.compute("early", {}, {"x"});
  b.compute("end", {{"a", "late.y"}, {"b", "other.x"}}, {"z"});
  b.output("color", "end.z");
  EXPECT_EQ(order(compiled(b.pipeline)), (Names{"other", "early", "late", "end"}));
}

TEST(Order, KeepsALoopTogether) {
  Builder b;
  b.beginLoop("shutter", 5);
  b.compute("a", {}, {"x"});
  b.endLoop();
  b.compute("outside", {}, {"x"});
  b.loop = "shutter";
  b.compute("b", {{"x", "a.x"}, {"o", "outside.x"}}, {}, {"sum"});
  b.endLoop();
  b.output("color", "b.sum");
  Plan plan = compiled(b.pipeline);
  EXPECT_EQ(order(plan), (Names{"outside", "a", "b"}));
  ASSERT_EQ(plan.steps.size(), 4u);  // clear, outside, loop, read-back
  EXPECT_EQ(plan.steps[2].kind, Step::Kind::Loop);
  EXPECT_EQ(plan.steps[2].body.size(), 2u);
  EXPECT_EQ(plan.loops.at(0).count, 5);
  EXPECT_EQ(plan.loops.at(0).times, "midpoint");
}

TEST(Order, PrintsACycleAsAPath) {
  Builder b;
  b.compute("a", {{"in", "c.x"}}, {"x"});
  b.compute("b", {{"in", "a.x"}}, {"x"});
  b.compute("c", {{"in", "b.x"}}, {"x"});
  b.compute("free", {}, {"x"});
  b.output("color", "free.x");
  EXPECT_EQ(refusal(b.pipeline), "test.lua:1: cycle: a -> b -> c -> a");
}

TEST(Order, RefusesANodeThatReadsItself) {
  Builder b;
  b.compute("a", {{"in", "a.x"}}, {"x"});
  b.output("color", "a.x");
  EXPECT_EQ(refusal(b.pipeline), "test.lua:1: cycle: a -> a");
}

TEST(Order, RefusesACycleThroughALoop) {
  Builder b;
  b.beginLoop("shutter", 2);
  b.compute("a", {}, {"x"});
  b.endLoop();
  b.compute("outside", {{"x", "a.x"}}, {"x"});
  b.loop = "shutter";
  b.compute("b", {{"o", "outside.x"}}, {}, {"sum"});
  b.endLoop();
  b.output("color", "b.sum");
  EXPECT_EQ(refusal(b.pipeline),
            "test.lua:1: cycle through a loop, whose nodes run together: loop shutter -> outside -> loop shutter");
}

TEST(Culling, OmitsNodesThatNoOutputNeeds) {
  Builder b = chain();
  b.compute("spare", {{"x", "first.x"}}, {"y"});
  b.compute("spare_too", {{"y", "spare.y"}}, {"z"});
  Plan plan = compiled(b.pipeline);
  EXPECT_EQ(order(plan), (Names{"first", "second", "third"}));
  ASSERT_EQ(plan.culled.size(), 2u);
  EXPECT_EQ(plan.culled[0].name, "spare");
  EXPECT_EQ(plan.culled[0].reason, "not needed by any output");
  EXPECT_EQ(findImage(plan, "spare.y"), -1);
}

TEST(Culling, TapKeepsItsDependencies) {
  Builder b = chain();
  b.compute("spare", {{"x", "first.x"}}, {"y"});
  CompileOptions options = optionsOf(64, 32);
  options.taps = {"spare.y"};
  Plan plan = compile(b.pipeline, options);
  EXPECT_TRUE(plan.culled.empty());
  EXPECT_TRUE(image(plan, "spare.y").kept);
  EXPECT_EQ(plan.taps.at(0).second, findImage(plan, "spare.y"));
}

TEST(Culling, LoopKeepsItsStopCondition) {
  Builder b;
  b.beginLoop("shutter", 8, "measure.done");
  b.compute("add", {}, {}, {"sum"});
  PassDesc& measure = b.compute("measure", {{"sum", "add.sum"}}, {"done"});
  measure.size.kind = SizeDesc::Kind::Fixed;
  measure.size.width = measure.size.height = 1;
  b.compute("unused", {}, {"x"});
  b.endLoop();
  b.output("color", "add.sum");
  Plan plan = compiled(b.pipeline);
  EXPECT_EQ(order(plan), (Names{"add", "measure"}));
  EXPECT_EQ(plan.loops.at(0).until, findImage(plan, "measure.done"));
  EXPECT_EQ(plan.steps.at(1).body.back().kind, Step::Kind::ReadImage);
}

TEST(Sizes, AreOfFrameFixedPortOrDividedRoundingUp) {
  Builder b;
  b.compute("first", {}, {"x"});
  PassDesc& tiles = b.compute("tiles", {{"x", "first.x"}}, {"max"});
  tiles.size.kind = SizeDesc::Kind::Port;
  tiles.size.port = "x";
  tiles.size.divide = "tile";
  tiles.params = {intParam("tile", 20, 1, 256)};
  PassDesc& near = b.compute("near", {{"max", "tiles.max"}}, {"max"});
  near.size.kind = SizeDesc::Kind::Port;
  near.size.port = "max";
  PassDesc& one = b.compute("one", {{"max", "near.max"}}, {"x"});
  one.size.kind = SizeDesc::Kind::Fixed;
  one.size.width = 3, one.size.height = 2;
  b.compute("last", {{"x", "one.x"}}, {"color"});
  b.output("color", "last.color");
  Plan plan = compile(b.pipeline, optionsOf(1920, 1081));
  auto size = [&](const char* name) { return std::pair(image(plan, name).width, image(plan, name).height); };
  EXPECT_EQ(size("first.x"), std::pair(1920, 1081));
  EXPECT_EQ(size("tiles.max"), std::pair(96, 55));
  EXPECT_EQ(size("near.max"), std::pair(96, 55));
  EXPECT_EQ(size("one.x"), std::pair(3, 2));
  EXPECT_EQ(size("last.color"), std::pair(1920, 1081));
}

// Outputs with a value per pixel: the picture, region masks, truth's error. The error's place is the size declaration
// that differs from the frame, in whichever pass it is.
TEST(Sizes, PixelOutputsHaveTheSizeOfTheFrame) {
  Builder b;
  b.compute("first", {}, {"x"});
  PassDesc& tiles = b.compute("tiles", {{"x", "first.x"}}, {"max"});
  tiles.size = {SizeDesc::Kind::Port, "x", "tile", 0, 0, {"passes/tiles.lua", 7}};
  tiles.params = {intParam("tile", 20, 1, 256)};
  PassDesc& near = b.compute("near", {{"max", "tiles.max"}}, {"max"});
  near.size = {SizeDesc::Kind::Port, "max", "", 0, 0, {"passes/near.lua", 5}};
  PassDesc& fixed = b.compute("fixed", {}, {"x"});
  fixed.size = {SizeDesc::Kind::Fixed, "", "", 64, 36, {"passes/fixed.lua", 3}};
  auto refusal = [&](const std::string& color, const std::string& name, const std::string& source) -> std::string {
    PipelineDesc pipeline = b.pipeline;
    pipeline.outputs = {{"color", color}, {name, source}};
    if (name == "inner") pipeline.regions = {{"inner", "where it blurs"}};
    if (name == "error") pipeline.kind = PipelineDesc::Kind::Truth;
    try {
      requireWholeOutputs(compile(pipeline, optionsOf(64, 36)));
    } catch (const Error& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_EQ(refusal("first.x", "tile", "near.max"), "") << "any other output may have any size";
  EXPECT_EQ(refusal("near.max", "other", "first.x"),
            "passes/tiles.lua:7: output 'color' of pipeline 'test' is 'near.max', which is 4x2 in a frame of 64x36; it "
            "has to be as large as the frame, and pass 'tiles' decides its size");
  EXPECT_TRUE(refusal("fixed.x", "other", "first.x").starts_with("passes/fixed.lua:3: output 'color'"))
      << "the fixed size equals the frame's by chance";
  EXPECT_TRUE(refusal("first.x", "inner", "tiles.max").starts_with("passes/tiles.lua:7: output 'inner'"));
  EXPECT_TRUE(refusal("first.x", "error", "near.max").starts_with("passes/tiles.lua:7: output 'error'"));
}

TEST(Params, OverridesDefaultByBindingPipelineAndSetting) {
  Builder b;
  b.compute("first", {}, {"x"}).params = {intParam("a", 1, 0, 99), intParam("b", 2, 0, 99), intParam("c", 3, 0, 99),
                                          intParam("d", 4, 0, 99)};
  b.node("first").params = {{"b", bound(int64_t{20})}, {"c", following("live")}, {"d", following("live")}};
  b.pipeline.params = {intParam("live", 30, 0, 99)};
  b.output("color", "first.x");

  auto values = [](const Plan& plan) {
    std::vector<int64_t> list;
    for (const auto& [name, value] : plan.nodes.at(0).params) list.push_back(std::get<int64_t>(value));
    return list;
  };
  EXPECT_EQ(values(compiled(b.pipeline)), (std::vector<int64_t>{1, 20, 30, 30}));
  b.pipeline.values = {{"live", int64_t{31}}};
  EXPECT_EQ(values(compiled(b.pipeline)), (std::vector<int64_t>{1, 20, 31, 31}));
  Plan plan = compiled(withSettings(b.pipeline, {{"live", int64_t{32}}, {"first.d", int64_t{44}}}));
  EXPECT_EQ(values(plan), (std::vector<int64_t>{1, 20, 32, 44}));
  EXPECT_EQ(std::get<int64_t>(plan.pipeline.values.at(0).second), 32);
}

TEST(Params, LoopsFollowThePipeline) {
  Builder b;
  b.beginLoop("shutter", 1);
  b.compute("add", {}, {}, {"sum"});
  b.endLoop();
  b.output("color", "add.sum");
  b.pipeline.params = {intParam("samples", 16, 1, 1024)};
  b.pipeline.loops[0].count = following("samples");
  b.pipeline.loops[0].times = bound(std::string("stratified"));
  b.pipeline.loops[0].slices = bound(int64_t{4});
  b.pipeline.values = {{"samples", int64_t{7}}};
  Plan plan = compiled(b.pipeline);
  EXPECT_EQ(plan.loops.at(0).count, 7);
  EXPECT_EQ(plan.loops.at(0).times, "stratified");
  EXPECT_EQ(plan.loops.at(0).slices, 4);
}

TEST(Params, LoopsOverFramesGiveTheirHistoryLength) {
  Builder b;
  for (const char* name : {"shutter", "earlier"}) {
    b.beginLoop(name, 2);
    b.compute(name + std::string("_sum"), {}, {}, {"sum"});
    b.endLoop();
    b.output(name == std::string("earlier") ? "color" : name, name + std::string("_sum.sum"));
  }
  b.pipeline.params = {intParam("poses", 3, 1, 1024)};
  b.pipeline.values = {{"poses", int64_t{3}}};
  for (LoopDesc& loop : b.pipeline.loops) loop.slices = following("poses");
  EXPECT_EQ(earlierFrames(b.pipeline), 0);
  b.pipeline.loops[1].times = bound(std::string("frames"));
  EXPECT_EQ(earlierFrames(b.pipeline), 2 * 3);
  EXPECT_EQ(compile(b.pipeline, optionsOf(64, 32)).loops.at(1).times, "frames");
  b.pipeline.values = {{"poses", int64_t{1000}}};
  EXPECT_EQ(earlierFrames(b.pipeline), 64);
}

// Each iteration of a loop over parts of the exposure draws all pixels, even outside the moving rectangle.
TEST(Loops, OverPartsDrawAllPixels) {
  Builder b;
  b.beginLoop("steps", 4);
  PassDesc& pass = b.compute("draw", {}, {"x"});
  ParamDesc once;
  once.name = "once", once.type = ParamDesc::Type::Bool, once.role = Role::StillOnce, once.default_value = true;
  pass.params = {once};
  pass.without = {{"moving_rect", {{"x", ""}}}};
  b.node("draw").params = {{"once", bound(true)}};
  b.endLoop();
  b.output("color", "draw.x");
  EXPECT_TRUE(compiled(b.pipeline).nodes.at(0).static_once);
  b.node("draw").params = {{"once", bound(false)}};
  EXPECT_TRUE(compiled(b.pipeline).nodes.at(0).in_moving_rect);
  EXPECT_FALSE(hasParts(b.pipeline));

  b.pipeline.loops[0].times = bound(std::string(kPartTimes));
  EXPECT_TRUE(hasParts(b.pipeline));
  for (bool once_set : {true, false}) {
    b.node("draw").params = {{"once", bound(once_set)}};
    Plan plan = compiled(b.pipeline);
    EXPECT_TRUE(plan.loops.at(0).drawsParts());
    EXPECT_FALSE(plan.nodes.at(0).static_once);
    EXPECT_FALSE(plan.nodes.at(0).in_moving_rect);
    EXPECT_NE(describe(plan).find("loop steps: 4 times, each over a part of the exposure"), std::string::npos);
  }
}

TEST(Loops, OverPartsHaveNoSampleTimes) {
  Builder b;
  b.beginLoop("steps", 4);
  b.compute("draw", {}, {"x"});
  b.endLoop();
  b.output("color", "draw.x");
  b.pipeline.loops[0].times = bound(std::string(kPartTimes));
  b.pipeline.loops[0].slices = bound(int64_t{2});
  EXPECT_NE(refusal(b.pipeline).find("slices of loop 'steps' must be 1"), std::string::npos) << refusal(b.pipeline);
  b.pipeline.loops[0].slices = bound(int64_t{1});
  b.node("draw").time = "sample";
  EXPECT_NE(refusal(b.pipeline).find("node 'draw' has time 'sample'"), std::string::npos) << refusal(b.pipeline);
}

TEST(Memory, AliasesAChain) {
  Builder b;
  b.compute("n0", {}, {"x"});
  for (int i = 1; i < 8; ++i) {
    b.compute(fmt::format("n{}", i), {{"x", fmt::format("n{}.x", i - 1)}}, {"x"});
  }
  b.output("color", "n7.x");
  Plan plan = compiled(b.pipeline);
  EXPECT_EQ(plan.images.size(), 8u);
  EXPECT_EQ(plan.slots.size(), 3u);  // two alternate, and the output has its own
  EXPECT_EQ(bytesUnaliased(plan), 8u * 64 * 32 * 4);
  EXPECT_EQ(bytesAliased(plan), 3u * 64 * 32 * 4);
}

// A buffer has a head of four numbers, then a number per pixel; it shares memory only with buffers.
TEST(Memory, BuffersHaveAHead) {
  Builder b;
  b.compute("a", {}, {"x buffer32ui"});
  b.compute("b", {{"x", "a.x"}}, {"x r32ui"});
  b.compute("c", {{"x", "b.x"}}, {"x buffer32ui"});
  b.compute("d", {{"x", "c.x"}}, {"x"});
  b.output("color", "d.x");
  Plan plan = compiled(b.pipeline);
  EXPECT_EQ(plan.slots.size(), 3u);
  EXPECT_EQ(plan.images.at(0).slot, plan.images.at(2).slot);
  EXPECT_EQ(plan.slots.at(0).bytes, 64u * 32 * 4 + 16);
}

// A pass over a list waits for the list's groups and its entries.
TEST(Buffers, RunOverAListReadsItsGroups) {
  Builder b;
  b.compute("list", {}, {"x buffer32ui"});
  PassDesc& over = b.compute("over", {{"x", "list.x"}}, {"y"});
  over.over = "x", over.writes[0].cleared = true;
  b.output("color", "over.y");
  Plan plan = compiled(b.pipeline);
  EXPECT_EQ(plan.nodes.at(1).over, plan.nodes.at(0).writes.at(0));
  uint32_t stages = 0, access = 0;
  for (const Step& step : plan.steps)
    for (const Barrier& barrier : step.barriers)
      if (step.kind == Step::Kind::Pass && step.index == 1 && barrier.image == plan.nodes.at(1).over)
        stages |= barrier.dst_stages, access |= barrier.dst_access;
  EXPECT_TRUE(plan.images.at(size_t(plan.nodes.at(1).over)).cleared);
  EXPECT_EQ(stages, kStageCompute | kStageIndirect);
  EXPECT_EQ(access, kAccessStorageRead | kAccessIndirectRead);
  EXPECT_NE(describe(plan).find("over list.x"), std::string::npos);
}

ParamDesc choiceParam(const std::string& name, const std::vector<std::string>& choices) {
  ParamDesc param;
  param.name = name;
  param.type = ParamDesc::Type::Choice;
  param.choices = choices;
  param.default_value = choices.front();
  return param;
}

// Two nodes of one pass that writes rg32f for `full` and rg16f for `half`; a third node reads both images.
Builder twoFormats(const std::string& second) {
  Builder b;
  PassDesc& pass = b.compute("store", {}, {"v rg32f"});
  pass.params = {choiceParam("precision", {"full", "half"})};
  pass.writes[0].format_by = "precision";
  pass.writes[0].formats = {{"full", "rg32f"}, {"half", "rg16f"}};
  NodeDesc again = b.node("store");
  again.name = "again";
  again.params = {{"precision", bound(second)}};
  b.pipeline.nodes.push_back(again);
  b.compute("use", {{"a", "store.v"}, {"b", "again.v"}}, {"x"});
  b.output("color", "use.x");
  return b;
}

TEST(ChosenFormats, AreIndependentPerNode) {
  Plan plan = compiled(twoFormats("half").pipeline);
  EXPECT_EQ(image(plan, "store.v").format, "rg32f");
  EXPECT_EQ(image(plan, "again.v").format, "rg16f");
  uint64_t texels = 64 * 32;
  EXPECT_EQ(bytesUnaliased(plan), texels * (8 + 4 + 4));  // 8 of rg32f, 4 of rg16f, 4 of the reader's r32f
  EXPECT_NE(image(plan, "store.v").slot, image(plan, "again.v").slot);
  std::string text = describe(plan);
  EXPECT_NE(text.find("v rg32f"), std::string::npos) << text;
  EXPECT_NE(text.find("v rg16f"), std::string::npos) << text;
  EXPECT_EQ(toJson(plan)["images"][1]["format"], "rg16f");
}

TEST(ChosenFormats, FollowPipelineAndSettings) {
  Builder b = twoFormats("full");
  std::string full = hashOf(compiled(b.pipeline));
  EXPECT_NE(full, hashOf(compiled(twoFormats("half").pipeline)));
  b.pipeline.params = {choiceParam("precision", {"full", "half"})};
  b.node("store").params = {{"precision", following("precision")}};
  EXPECT_EQ(image(compiled(b.pipeline), "store.v").format, "rg32f");
  b.pipeline.values = {{"precision", std::string("half")}};
  EXPECT_EQ(image(compiled(b.pipeline), "store.v").format, "rg16f");
  b.pipeline.values = {{"precision", std::string("full")}};
  Plan plan = compiled(withSettings(b.pipeline, {{"again.precision", std::string("half")}}));
  EXPECT_EQ(image(plan, "store.v").format, "rg32f");
  EXPECT_EQ(image(plan, "again.v").format, "rg16f");
}

TEST(ChosenFormats, MistakesAreRefused) {
  auto refused = [](auto change) {
    Builder b = twoFormats("half");
    b.pipeline.passes[0].writes[0].place = {"passes/store.lua", 4};
    change(b.pipeline.passes[0].writes[0]);
    return refusalOf(b.pipeline.passes[0]);
  };
  EXPECT_EQ(refused([](PortDesc& port) { port.format_by = "precison"; }),
            "passes/store.lua:4: pass 'store': the format of 'v' is chosen by 'precison', which is not a parameter of "
            "the pass; did you mean 'precision'?");
  EXPECT_EQ(refused([](PortDesc& port) { port.formats.pop_back(); }),
            "passes/store.lua:4: pass 'store': the format of 'v' is chosen by 'precision', but 'formats' does not have "
            "one format for each choice");
  EXPECT_EQ(refused([](PortDesc& port) { port.formats[1].second = "rg16"; }),
            "passes/store.lua:4: pass 'store': the format of 'v' is chosen by 'precision', but format 'rg16' is "
            "unknown; did you mean 'rg16f'?");
  EXPECT_EQ(refused([](PortDesc& port) { port.formats[1].second = "rg32ui"; }),
            "passes/store.lua:4: pass 'store': the format of 'v' is chosen by 'precision', but the formats mix "
            "unsigned integers and numbers");
}

TEST(ChosenFormats, LoopStopsOnTheChosenFormat) {
  Builder b;
  b.beginLoop("shutter", 8, "measure.done");
  PassDesc& measure = b.compute("measure", {}, {"done"});
  measure.size.kind = SizeDesc::Kind::Fixed;
  measure.size.width = measure.size.height = 1;
  measure.params = {choiceParam("precision", {"full", "half"})};
  measure.writes[0].format_by = "precision";
  measure.writes[0].formats = {{"full", "r32f"}, {"half", "rg16f"}};
  b.endLoop();
  b.output("color", "measure.done");
  EXPECT_EQ(refusal(b.pipeline), "accepted");
  b.node("measure").params = {{"precision", bound(std::string("half"))}};
  EXPECT_NE(refusal(b.pipeline).find("stops on 'measure.done', which is not r32f"), std::string::npos);
}

TEST(Memory, UsageFollowsFromThePorts) {
  Builder b;
  b.raster("draw", {}, {"x"});
  b.compute("add", {{"x", "draw.x"}}, {"y"}, {"sum"});
  b.output("color", "add.sum");
  Plan plan = compiled(b.pipeline);
  EXPECT_EQ(image(plan, "draw.x").usage, kUsageColorAttachment | kUsageSampled);
  EXPECT_EQ(image(plan, "draw.@depth").usage, uint32_t{kUsageDepthAttachment});
  EXPECT_EQ(image(plan, "draw.@depth").format, "d32f");
  EXPECT_EQ(image(plan, "add.y").usage, uint32_t{kUsageStorage});
  EXPECT_EQ(image(plan, "add.sum").usage, kUsageStorage | kUsageTransferTarget | kUsageTransferSource);
}

// Checked against the definition of lifetimes: no two images in one slot are alive in one step.
TEST(Memory, RandomPipelinesNeverOverlap) {
  int shared = 0;
  for (uint32_t seed = 0; seed < 500; ++seed) {
    RandomPipeline random = randomPipeline(seed);
    Plan plan = compile(random.pipeline, random.options);
    for (size_t i = 0; i < plan.images.size(); ++i) {
      for (size_t j = i + 1; j < plan.images.size(); ++j) {
        const VirtualImage& a = plan.images[i];
        const VirtualImage& b = plan.images[j];
        if (a.slot != b.slot) continue;
        ++shared;
        EXPECT_TRUE(a.last < b.first || b.last < a.first) << "seed " << seed << ": " << a.name << ", " << b.name;
        EXPECT_TRUE(a.format == b.format && a.width == b.width && a.height == b.height) << a.name << ", " << b.name;
        EXPECT_FALSE(a.kept || b.kept || a.update || b.update) << "seed " << seed << ": " << a.name << ", " << b.name;
      }
    }
  }
  EXPECT_GT(shared, 500);
}

TEST(Canonical, IsEqualForEqualPlans) {
  for (uint32_t seed = 0; seed < 50; ++seed) {
    RandomPipeline random = randomPipeline(seed);
    std::string first = toJson(compile(random.pipeline, random.options)).dump();
    EXPECT_EQ(first, toJson(compile(random.pipeline, random.options)).dump());
  }
  EXPECT_EQ(hashOf(compiled(chain().pipeline)), hashOf(compiled(chain().pipeline)));
}

TEST(Canonical, DistinguishesPlans) {
  Builder b = chain();
  std::string hash = hashOf(compiled(b.pipeline));
  EXPECT_NE(hash, hashOf(compile(b.pipeline, optionsOf(64, 33))));
  b.pipeline.passes[1].params = {intParam("n", 1, 0, 9)};
  std::string with_param = hashOf(compiled(b.pipeline));
  EXPECT_NE(hash, with_param);
  b.node("second").params = {{"n", bound(int64_t{2})}};
  EXPECT_NE(with_param, hashOf(compiled(b.pipeline)));
}

// Documentation and places do not change the executed plan.
TEST(Canonical, IgnoresTextsForPeople) {
  Builder b = chain();
  std::string hash = hashOf(compiled(b.pipeline));
  b.pipeline.doc = "other";
  b.pipeline.passes[0].doc = "other";
  b.node("first").place.line = 77;
  EXPECT_EQ(hash, hashOf(compiled(b.pipeline)));
}

TEST(Refusals, UnknownNodeAndPort) {
  Builder b = chain();
  b.node("third").inputs = {{"y", "secnd.y"}};
  EXPECT_EQ(refusal(b.pipeline),
            "test.lua:3: node 'third' reads 'secnd.y', but node 'secnd' is unknown; did you mean 'second'?");
  b.node("third").inputs = {{"y", "second.yy"}};
  EXPECT_EQ(refusal(b.pipeline),
            "test.lua:3: node 'third' reads 'second.yy', but pass 'second' does not write 'yy'; did you mean 'y'?");
  b.node("third").inputs = {{"why", "second.y"}, {"y", "second.y"}};
  EXPECT_EQ(refusal(b.pipeline), "test.lua:3: pass 'third' has no input 'why'; did you mean 'y'?");
  b.node("third").inputs = {};
  EXPECT_EQ(refusal(b.pipeline), "test.lua:3: node 'third' lacks the input 'y' of pass 'third'");
}

TEST(Refusals, ReadBeforeWritten) {
  Builder b = chain();
  b.node("third").inputs = {{"y", "second.x"}};
  EXPECT_EQ(refusal(b.pipeline),
            "test.lua:3: node 'third' reads 'second.x' before it is written: node 'second' only reads it");
}

TEST(Refusals, NumbersReadAsUnsignedAndBack) {
  Builder b;
  b.compute("first", {}, {"x r32ui"});
  b.compute("second", {{"x", "first.x"}}, {"y"});
  b.output("color", "second.y");
  EXPECT_EQ(refusal(b.pipeline), "accepted");
  b.pipeline.passes[1].reads[0].uint = false;
  b.pipeline.passes[0].writes[0].place = {"passes/first.lua", 4};
  EXPECT_EQ(refusal(b.pipeline),
            "test.lua:2: node 'second' reads 'x' as numbers, but 'first.x' is r32ui (passes/first.lua:4)");
}

TEST(Refusals, BuffersReadAsImagesAndBack) {
  Builder b;
  b.compute("first", {}, {"x buffer32ui"});
  b.compute("second", {{"x", "first.x"}}, {"y"});
  b.output("color", "second.y");
  EXPECT_EQ(refusal(b.pipeline), "accepted");
  b.output("list", "first.x");
  EXPECT_EQ(refusal(b.pipeline), "test.lua: output 'list' is 'first.x', a buffer instead of an image");
  b.pipeline.outputs.pop_back();
  b.pipeline.passes[1].reads[0].buffer = false;
  b.pipeline.passes[0].writes[0].place = {"passes/first.lua", 4};
  EXPECT_EQ(refusal(b.pipeline),
            "test.lua:2: node 'second' reads 'x' as an image, but 'first.x' is buffer32ui (passes/first.lua:4)");
}

TEST(Refusals, OptionalInputsCannotDecideASize) {
  Builder b = chain();
  b.pipeline.passes[2].reads[0].optional = true;
  b.node("third").inputs = {};
  Plan plan = compiled(b.pipeline);
  EXPECT_EQ(order(plan), (Names{"third"}));
  EXPECT_EQ(plan.nodes.at(0).reads, std::vector<int>{-1});
  b.pipeline.passes[2].size.kind = SizeDesc::Kind::Port;
  b.pipeline.passes[2].size.port = "y";
  EXPECT_EQ(refusal(b.pipeline), "test.lua:3: node 'third' is as large as its input 'y', which is not wired");
}

TEST(Refusals, TwoWriters) {
  Builder b = chain();
  b.pipeline.nodes[1].name = "first";
  EXPECT_EQ(refusal(b.pipeline), "test.lua: two nodes named 'first'");
  Builder c = chain();
  c.pipeline.passes[0].updates.push_back(c.pipeline.passes[0].writes[0]);
  EXPECT_EQ(refusalOf(c.pipeline.passes[0]), "passes/first.lua:1: pass 'first': two writes are named 'x'");
  c.pipeline.passes[0].writes = c.pipeline.passes[0].updates = {};
  EXPECT_EQ(refusalOf(c.pipeline.passes[0]), "passes/first.lua:1: pass 'first': it writes nothing");
}

TEST(Refusals, FilteredReads) {
  Builder b = chain();
  PortDesc& read = b.pipeline.passes[1].reads[0];
  read.linear = read.pointwise = true;
  const std::string both = "pass 'second': read '" + read.name + "' is both ";
  EXPECT_EQ(refusalOf(b.pipeline.passes[1]), both + "pointwise and linear");
  read.uint = true;
  EXPECT_EQ(refusalOf(b.pipeline.passes[1]), both + "uint and linear");
}

TEST(Refusals, Parameters) {
  Builder b = chain();
  b.pipeline.passes[0].params = {intParam("tile", 20, 1, 256)};
  b.node("first").params = {{"tle", bound(int64_t{1})}};
  EXPECT_EQ(refusal(b.pipeline), "pass 'first' has no parameter 'tle'; did you mean 'tile'?");
  b.node("first").params = {{"tile", following("sice")}};
  b.pipeline.values = {{"size", int64_t{4}}};
  EXPECT_EQ(refusal(b.pipeline), "pipeline 'test' has no parameter 'sice'; did you mean 'size'?");
  b.node("first").params = {{"tile", bound(int64_t{257})}};
  EXPECT_NE(refusal(b.pipeline).find("'tile' = 257"), std::string::npos) << refusal(b.pipeline);
}

TEST(Refusals, Loops) {
  Builder b;
  b.beginLoop("shutter", 0);
  b.compute("add", {}, {}, {"sum"});
  b.endLoop();
  b.output("color", "add.sum");
  EXPECT_NE(refusal(b.pipeline).find("count of loop 'shutter' must be an integer from 1"), std::string::npos);
  b.pipeline.loops[0].count = bound(int64_t{2});
  b.pipeline.loops[0].until = "add.sum";
  EXPECT_EQ(refusal(b.pipeline), "test.lua:100: loop 'shutter' stops on 'add.sum', which is 64x32 instead of 1x1");
  b.pipeline.loops[0].until = "";
  b.pipeline.loops[0].first = 3, b.pipeline.loops[0].parts = 4;
  EXPECT_EQ(refusal(b.pipeline),
            "test.lua:100: loop 'shutter' takes 2 parts of 4 from number 3 on, which is out of range");
  b.pipeline.loops[0].first = 2;
  b.node("add").loop = "shuter";
  EXPECT_EQ(refusal(b.pipeline), "test.lua:1: node 'add' is in unknown loop 'shuter'; did you mean 'shutter'?");
  b.node("add").loop = "";
  b.node("add").time = "sample";
  EXPECT_EQ(refusal(b.pipeline), "test.lua:1: node 'add' has time 'sample' but is not in a loop");
}

TEST(Refusals, SizesAndOutputs) {
  Builder b = chain();
  EXPECT_NE(refusal(b.pipeline, optionsOf(0, 32)), "accepted");
  EXPECT_NE(refusal(b.pipeline, optionsOf(64, 1 << 20)), "accepted");
  CompileOptions options = optionsOf(64, 32);
  options.taps = {"first.y"};
  EXPECT_NE(refusal(b.pipeline, options), "accepted");
  b.pipeline.outputs = {{"depth", "third.z"}};
  EXPECT_EQ(refusal(b.pipeline), "test.lua: pipeline 'test' has no output 'color'");
}

TEST(Refusals, RaysAtATimeWithoutAStructure) {
  Builder b;
  b.trace("rays", {}, {"hit"});
  b.output("color", "rays.hit");
  b.node("rays").time = "shutter_open";
  EXPECT_EQ(refusal(b.pipeline),
            "test.lua:1: trace node 'rays' has time 'shutter_open'; rays trace the scene at the raster time or, in a "
            "loop, at the sample");
}

TEST(Refusals, AllAtOnce) {
  Builder b = chain();
  b.node("second").inputs = {{"x", "frist.x"}};
  b.node("third").inputs = {{"y", "secnd.y"}};
  std::string text = refusal(b.pipeline);
  EXPECT_NE(text.find("'frist.x'"), std::string::npos);
  EXPECT_NE(text.find("'secnd.y'"), std::string::npos);
}

}  // namespace plan_test
}  // namespace strobe::plan::test
