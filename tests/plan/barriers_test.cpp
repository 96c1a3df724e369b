// SPDX-License-Identifier: MIT
// A barrier for each class of hazard, verified by replaying the plan in a model of the device's memory. The replay
// fails if any one of these barriers is removed.
#include <gtest/gtest.h>

#include <functional>

#include "plan/builder.h"
#include "plan/random_pipeline.h"
#include "plan/replay.h"

namespace strobe::plan::test {
namespace barriers_test {

Plan compiled(const PipelineDesc& pipeline, PipelineStage trace_stage = kStageCompute) {
  CompileOptions options;
  options.width = 64, options.height = 32;
  options.trace_stage = trace_stage;
  return compile(pipeline, options);
}

std::string joined(const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& line : lines) text += line + "\n";
  return text;
}

using BarrierList = std::vector<Barrier> Step::*;

// Calls `visit` for each list of recorded barriers.
void visitLists(Plan& plan, const std::function<void(Step&, BarrierList)>& visit) {
  for (Step& step : plan.steps) {
    visit(step, &Step::barriers);
    for (Step& inner : step.body) {
      visit(inner, &Step::barriers);
      if (plan.loops[step.index].count > 1) visit(inner, &Step::barriers_next);
    }
  }
}

// Number of barriers, and number whose single removal leaves the replay without a problem.
struct Removal {
  int barriers = 0;
  int unmissed = 0;
  std::string last_unmissed;
};

Removal removeEach(Plan plan, uint32_t trace_stage) {
  Removal result;
  visitLists(plan, [&](Step& step, BarrierList list) {
    for (size_t i = 0; i < (step.*list).size(); ++i) {
      std::vector<Barrier> whole = step.*list;
      (step.*list).erase((step.*list).begin() + i);
      ++result.barriers;
      if (replayAll(plan, trace_stage).empty()) {
        ++result.unmissed;
        result.last_unmissed = whole[i].image >= 0 ? plan.images[whole[i].image].name : "counters";
      }
      step.*list = whole;
    }
  });
  return result;
}

// The compiled plan is sound, and unsound without any one of its barriers.
void expectExact(const PipelineDesc& pipeline, PipelineStage trace_stage = kStageCompute) {
  Plan plan = compiled(pipeline, trace_stage);
  EXPECT_EQ(joined(replayAll(plan, trace_stage)), "");
  Removal removal = removeEach(plan, trace_stage);
  EXPECT_GT(removal.barriers, 0);
  EXPECT_EQ(removal.unmissed, 0) << removal.last_unmissed;
}

struct Found {
  uint32_t src_stages, src_access, dst_stages, dst_access;
  Hazard hazard;
  bool carried, discard;
  bool operator==(const Found&) const = default;
};

std::ostream& operator<<(std::ostream& out, const Found& found) {
  return out << fmt::format("{:x}:{:x} -> {:x}:{:x} hazard {} carried {} discard {}", found.src_stages,
                            found.src_access, found.dst_stages, found.dst_access, static_cast<int>(found.hazard),
                            found.carried, found.discard);
}

const Step* findPass(const Plan& plan, const std::vector<Step>& steps, const std::string& node) {
  for (const Step& step : steps) {
    bool pass = step.kind == Step::Kind::Pass;
    if (pass && plan.pipeline.nodes[plan.nodes[step.index].node].name == node) return &step;
    if (const Step* inner = findPass(plan, step.body, node)) return inner;
  }
  return nullptr;
}

// Barriers before `node` for the image `image` ("counters" for its counters).
std::vector<Found> before(const Plan& plan, const std::string& node, const std::string& image,
                          BarrierList list = &Step::barriers) {
  std::vector<Found> found;
  const Step* step = findPass(plan, plan.steps, node);
  if (!step) throw std::logic_error("no step " + node);
  for (const Barrier& b : step->*list) {
    std::string name = b.image >= 0 ? plan.images[b.image].name : "counters";
    if (name != image) continue;
    found.push_back({b.src_stages, b.src_access, b.dst_stages, b.dst_access, b.hazard, b.carried, b.discard});
  }
  return found;
}

const uint32_t kStorageReadWrite = kAccessStorageRead | kAccessStorageWrite;

TEST(Barriers, ReadAfterWrite) {
  Builder b;
  b.compute("first", {}, {"x"});
  b.compute("second", {{"x", "first.x"}}, {"y"});
  b.output("color", "second.y");
  expectExact(b.pipeline);
  std::vector<Found> expected = {
      {kStageCompute, kAccessStorageWrite, kStageCompute, kAccessSampledRead, Hazard::ReadAfterWrite, false, false}};
  EXPECT_EQ(before(compiled(b.pipeline), "second", "first.x"), expected);
}

TEST(Barriers, RasterToCompute) {
  Builder b;
  b.raster("draw", {}, {"x"});
  b.compute("look", {{"x", "draw.x"}}, {"y"});
  b.output("color", "look.y");
  expectExact(b.pipeline);
  std::vector<Found> expected = {
      {kStageColor, kAccessColorWrite, kStageCompute, kAccessSampledRead, Hazard::ReadAfterWrite, false, false}};
  EXPECT_EQ(before(compiled(b.pipeline), "look", "draw.x"), expected);
}

TEST(Barriers, TraceToComputeInEachBackend) {
  Builder b;
  b.trace("rays", {}, {"x"});
  b.compute("look", {{"x", "rays.x"}}, {"y"});
  b.output("color", "look.y");
  for (PipelineStage stage : {kStageCompute, kStageTrace}) {
    expectExact(b.pipeline, stage);
    std::vector<Found> expected = {
        {stage, kAccessStorageWrite, kStageCompute, kAccessSampledRead, Hazard::ReadAfterWrite, false, false}};
    EXPECT_EQ(before(compiled(b.pipeline, stage), "look", "rays.x"), expected);
  }
}

TEST(Barriers, ClearToUpdateToReadBack) {
  Builder b;
  b.compute("add", {}, {}, {"sum"});
  b.output("color", "add.sum");
  expectExact(b.pipeline);
  Plan plan = compiled(b.pipeline);
  std::vector<Found> expected = {
      {kStageTransfer, kAccessTransferWrite, kStageCompute, kStorageReadWrite, Hazard::ReadAfterWrite, false, false}};
  EXPECT_EQ(before(plan, "add", "add.sum"), expected);
  const Barrier& out = plan.steps.back().barriers.at(0);
  EXPECT_EQ(plan.steps.back().kind, Step::Kind::ReadImage);
  EXPECT_EQ(out.src_stages, kStageCompute);
  EXPECT_EQ(out.src_access, kAccessStorageWrite);
  EXPECT_EQ(out.dst_stages, kStageTransfer);
  EXPECT_EQ(out.dst_access, kAccessTransferRead);
}

TEST(Barriers, CountersAreClearedCountedAndRead) {
  Builder b;
  b.compute("first", {}, {"x"}).counters = {{"odd", ""}};
  b.output("color", "first.x");
  expectExact(b.pipeline);
  Plan plan = compiled(b.pipeline);
  std::vector<Found> expected = {
      {kStageTransfer, kAccessTransferWrite, kStageCompute, kStorageReadWrite, Hazard::ReadAfterWrite, false, true}};
  std::vector<Found> found = before(plan, "first", "counters");
  ASSERT_EQ(found.size(), 1u);
  expected[0].discard = found[0].discard;  // not used by counters
  EXPECT_EQ(found, expected);
  EXPECT_EQ(plan.steps.back().kind, Step::Kind::ReadCounters);
  EXPECT_EQ(plan.steps.back().barriers.at(0).dst_stages, kStageHost);
}

// "third" reuses the slot of "first", which "second" still reads.
TEST(Barriers, WriteAfterReadAcrossAliases) {
  Builder b;
  b.compute("first", {}, {"x"});
  b.compute("second", {{"x", "first.x"}}, {"y"});
  b.compute("third", {{"y", "second.y"}}, {"z"});
  b.compute("fourth", {{"z", "third.z"}}, {"w rgba32f"});
  b.output("color", "fourth.w");
  expectExact(b.pipeline);
  Plan plan = compiled(b.pipeline);
  ASSERT_EQ(plan.images[findImage(plan, "third.z")].slot, plan.images[findImage(plan, "first.x")].slot);
  std::vector<Found> expected = {
      {kStageCompute, kAccessStorageWrite, kStageCompute, kAccessStorageWrite, Hazard::WriteAfterRead, false, true}};
  EXPECT_EQ(before(plan, "third", "third.z"), expected);
}

// "second" reuses the slot of "first.spare" at another stage; no pass reads "first.spare".
TEST(Barriers, WriteAfterWriteAcrossAliases) {
  Builder b;
  b.compute("first", {}, {"spare", "x rgba32f"});
  b.raster("second", {{"x", "first.x"}}, {"y"});
  b.compute("third", {{"y", "second.y"}}, {"z rgba16f"});
  b.output("color", "third.z");
  expectExact(b.pipeline);
  Plan plan = compiled(b.pipeline);
  ASSERT_EQ(plan.images[findImage(plan, "second.y")].slot, plan.images[findImage(plan, "first.spare")].slot);
  std::vector<Found> expected = {
      {kStageCompute, kAccessStorageWrite, kStageColor, kAccessColorWrite, Hazard::WriteAfterWrite, false, true}};
  EXPECT_EQ(before(plan, "second", "second.y"), expected);
}

TEST(Barriers, DepthAttachmentsShareASlot) {
  Builder b;
  b.raster("first", {}, {"x"});
  b.raster("second", {{"x", "first.x"}}, {"y"});
  b.output("color", "second.y");
  expectExact(b.pipeline);
  Plan plan = compiled(b.pipeline);
  uint32_t read_write = kAccessDepthRead | kAccessDepthWrite;
  std::vector<Found> expected = {
      {kStageDepth, kAccessDepthWrite, kStageDepth, read_write, Hazard::WriteAfterWrite, false, true}};
  EXPECT_EQ(before(plan, "second", "second.@depth"), expected);
}

TEST(Barriers, LoopCarriedWriteAfterRead) {
  Builder b;
  b.beginLoop("shutter", 3);
  b.compute("sample", {}, {"x"});
  b.compute("add", {{"x", "sample.x"}}, {}, {"sum"});
  b.endLoop();
  b.output("color", "add.sum");
  expectExact(b.pipeline);
  Plan plan = compiled(b.pipeline);
  EXPECT_TRUE(before(plan, "sample", "sample.x").empty());
  std::vector<Found> write_again = {
      {kStageCompute, kAccessStorageWrite, kStageCompute, kAccessStorageWrite, Hazard::WriteAfterRead, true, false}};
  EXPECT_EQ(before(plan, "sample", "sample.x", &Step::barriers_next), write_again);
  std::vector<Found> add_again = {
      {kStageCompute, kAccessStorageWrite, kStageCompute, kStorageReadWrite, Hazard::ReadAfterWrite, true, false}};
  EXPECT_EQ(before(plan, "add", "add.sum", &Step::barriers_next), add_again);
}

// Atomic operations on a buffer also read the cleared values.
TEST(Barriers, WriterOfABufferReadsTheClearedValues) {
  Builder b;
  b.compute("count", {}, {"x buffer32ui"});
  b.compute("use", {{"x", "count.x"}}, {"y"});
  b.output("color", "use.y");
  expectExact(b.pipeline);
  std::vector<Found> expected = {
      {kStageTransfer, kAccessTransferWrite, kStageCompute, kStorageReadWrite, Hazard::ReadAfterWrite, false, false}};
  EXPECT_EQ(before(compiled(b.pipeline), "count", "count.x"), expected);
}

// The copy of the stop condition ends before the next iteration writes it.
TEST(Barriers, StopConditionIsReadBackInEachIteration) {
  Builder b;
  b.beginLoop("shutter", 3, "add.done");
  PassDesc& add = b.compute("add", {}, {"done"}, {"sum"});
  add.size.kind = SizeDesc::Kind::Fixed;
  add.size.width = add.size.height = 1;
  b.endLoop();
  b.output("color", "add.sum");
  expectExact(b.pipeline);
  std::vector<Found> expected = {{kStageCompute | kStageTransfer, kAccessStorageWrite, kStageCompute,
                                  kAccessStorageWrite, Hazard::WriteAfterRead, true, false}};
  EXPECT_EQ(before(compiled(b.pipeline), "add", "add.done", &Step::barriers_next), expected);
}

// Iteration 0 waits for the steps before the loop, iteration 1 for iteration 0: the lists differ.
TEST(Barriers, FirstIterationReusesASlot) {
  Builder b;
  b.raster("first", {}, {"x"});
  b.compute("second", {{"x", "first.x"}}, {"y rg32f"});
  b.beginLoop("shutter", 3);
  b.compute("sample", {{"y", "second.y"}}, {"z"});
  b.compute("add", {{"z", "sample.z"}}, {}, {"sum"});
  b.endLoop();
  b.output("color", "add.sum");
  expectExact(b.pipeline);
  Plan plan = compiled(b.pipeline);
  ASSERT_EQ(plan.images[findImage(plan, "sample.z")].slot, plan.images[findImage(plan, "first.x")].slot);
  std::vector<Found> takes_over = {{kStageColor | kStageCompute, kAccessColorWrite, kStageCompute, kAccessStorageWrite,
                                    Hazard::WriteAfterRead, false, true}};
  EXPECT_EQ(before(plan, "sample", "sample.z"), takes_over);
  std::vector<Found> again = {
      {kStageCompute, kAccessStorageWrite, kStageCompute, kAccessStorageWrite, Hazard::WriteAfterRead, true, false}};
  EXPECT_EQ(before(plan, "sample", "sample.z", &Step::barriers_next), again);
}

TEST(Barriers, RandomPipelinesAreSound) {
  int barriers = 0, loops = 0, shared = 0;
  for (uint32_t seed = 0; seed < 500; ++seed) {
    RandomPipeline random = randomPipeline(seed);
    Plan plan = compile(random.pipeline, random.options);
    EXPECT_EQ(joined(replayAll(plan, random.options.trace_stage)), "") << "seed " << seed;
    barriers += barrierCount(plan);
    loops += static_cast<int>(plan.loops.size());
    shared += static_cast<int>(plan.images.size() - plan.slots.size());
  }
  // The random pipelines have enough barriers, loops and shared slots.
  EXPECT_GT(barriers, 5000);
  EXPECT_GT(loops, 100);
  EXPECT_GT(shared, 500);
}

// Too few barriers are unsound and too many are slow: random pipelines need each barrier.
TEST(Barriers, RandomPipelinesNeedEveryBarrier) {
  int barriers = 0, unmissed = 0;
  for (uint32_t seed = 0; seed < 60; ++seed) {
    RandomPipeline random = randomPipeline(seed);
    Removal removal = removeEach(compile(random.pipeline, random.options), random.options.trace_stage);
    barriers += removal.barriers;
    unmissed += removal.unmissed;
  }
  EXPECT_GT(barriers, 500);
  EXPECT_EQ(unmissed, 0) << "of " << barriers;
}

// No description compiles to this plan yet (contents kept between frames would); the derivation covers it too.
TEST(Barriers, WriteAfterReadWithoutAnEarlierWrite) {
  Plan plan;
  plan.slots.resize(1);
  plan.images.resize(1);
  Step read, write;
  read.uses = {{{Resource::Kind::Slot, 0}, 0, kStageFragment, kAccessSampledRead}};
  write.uses = {{{Resource::Kind::Slot, 0}, 0, kStageCompute, kAccessStorageWrite}};
  plan.steps = {read, write};
  addBarriers(plan);
  EXPECT_TRUE(plan.steps[0].barriers.empty());
  ASSERT_EQ(plan.steps[1].barriers.size(), 1u);
  const Barrier& barrier = plan.steps[1].barriers[0];
  EXPECT_EQ(barrier.src_stages, uint32_t{kStageFragment});
  EXPECT_EQ(barrier.src_access, 0u);
  EXPECT_EQ(barrier.dst_stages, uint32_t{kStageCompute});
}

}  // namespace barriers_test
}  // namespace strobe::plan::test
