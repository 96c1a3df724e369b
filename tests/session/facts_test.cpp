// SPDX-License-Identifier: MIT
// Facts of a frame in sessions and batches: when motion pauses, the plan changes.
#include <gtest/gtest.h>

#include "lab/batch.h"
#include "lab/record.h"
#include "plan/plan.h"
#include "session/home.h"

namespace strobe::session {
namespace facts_test {

using lab::Session;
using lab::Shot;

// A box before a wall. The box starts to move after 12 frames.
const char* kScene = R"(local scene = require "strobe.scene"
local grey = scene.material { name = "grey", color = { 0.5, 0.5, 0.5 } }
return scene {
  name = "pause",
  nodes = {
    scene.node { name = "wall", shape = scene.quad { size = { 9, 9 } }, position = { 0, 0, -6 }, material = grey },
    scene.node { name = "box", shape = scene.box { size = { 1, 1, 1 } }, material = grey },
    scene.node { name = "camera", camera = scene.camera { name = "main", fov = 60 } },
  },
  animations = { scene.animation { name = "go", duration = 10, tracks = { scene.track {
    node = "box", times = { 0, 0.5, 1.5 }, values = { { -1, 0, -4 }, { -1, 0, -4 }, { 3, 0, -4 } } } } } },
}
)";
constexpr int kStill = 6, kMoving = 18;

class FactsTest : public SessionTest {
 protected:
  FactsTest() { home_.write("scripts/scenes/pause.lua", kScene); }

  static Shot shotAt(const std::string& pipeline, int frame) {
    Shot shot;
    shot.pipeline = pipeline;
    shot.scene = "pause";
    shot.width = 64, shot.height = 36, shot.frame = frame;
    return shot;
  }
  static bool rests(const Session& session) { return plan::lacks(session.plan(), "motion"); }
};

TEST_F(FactsTest, ChangedFactsMakeANewPlan) {
  Session session(bench(), shotAt("hybrid", kStill));
  EXPECT_TRUE(rests(session));
  size_t still = session.plan().nodes.size();
  session.set("frame", std::to_string(kMoving), "window");
  EXPECT_FALSE(rests(session));
  EXPECT_GT(session.plan().nodes.size(), still);
  EXPECT_EQ(hashes(session.draw()), hashes(bench().render(shotAt("hybrid", kMoving)).frame));
  int compilations = bench().compilations();
  session.set("frame", std::to_string(kStill), "window");
  EXPECT_EQ(session.plan().nodes.size(), still);
  EXPECT_EQ(hashes(session.draw()), hashes(bench().render(shotAt("hybrid", kStill)).frame));
  EXPECT_EQ(bench().compilations(), compilations);
}

TEST_F(FactsTest, EqualFactsKeepThePlan) {
  Session session(bench(), shotAt("hybrid", kStill));
  const plan::Plan* plan = &session.plan();
  session.set("frame", std::to_string(kStill + 1), "window");
  EXPECT_EQ(plan, &session.plan());
}

TEST_F(FactsTest, OmittedPassesCanBeTapped) {
  Session session(bench(), shotAt("hybrid_layered", kStill));
  std::vector<std::string> ports = session.ports();
  EXPECT_TRUE(std::count(ports.begin(), ports.end(), "composite.blurred"));
  session.tap({"composite.blurred", "mask.mask"});
  graph::FrameResult frame = session.draw();
  EXPECT_EQ(lab::hashOf(frame.taps.at("composite.blurred")), lab::hashOf(frame.outputs.at("color")));
  for (float value : frame.taps.at("mask.mask").floats.values) EXPECT_EQ(value, 0);
  session.set("frame", std::to_string(kMoving), "window");
  EXPECT_EQ(session.draw().taps.size(), 2u);
}

TEST_F(FactsTest, EverythingCanBeModelled) {
  Session session(bench(), shotAt("hybrid", kStill));
  auto before = hashes(session.draw());
  session.set("model_everything", "true", "window");
  EXPECT_TRUE(session.plan().absent.empty());
  EXPECT_EQ(hashes(session.draw()), before);
}

TEST_F(FactsTest, BatchesKeepPlansOfDifferentFactsApart) {
  lab::Batch batch(bench());
  for (int frame : {kStill, kMoving, kStill}) {
    auto picture = batch.picture(shotAt("hybrid", frame));
    EXPECT_EQ(hashes(picture->frame), hashes(bench().render(shotAt("hybrid", frame)).frame)) << frame;
  }
  Shot everything = shotAt("hybrid", kStill);
  everything.model_everything = true;
  EXPECT_NE(batch.contentOf(everything), batch.contentOf(shotAt("hybrid", kStill)));
  EXPECT_LT(batch.planOf(shotAt("hybrid", kStill))->nodes.size(), batch.planOf(everything)->nodes.size());
}

TEST_F(FactsTest, TimedFramesRunOnlyThePassesOfTheColour) {
  lab::Batch batch(bench());
  std::vector<Shot> shots = {shotAt("none", kStill), shotAt("hybrid", kStill)};
  std::vector<lab::Timing> timings = batch.timeInTurn(shots, {.least = 1, .most = 1});
  auto passesOf = [](const lab::Timing& timing) {
    std::vector<std::string> names;
    for (const auto& [name, ms] : timing.passes) names.push_back(name);
    return names;
  };
  EXPECT_EQ(passesOf(timings[0]), (std::vector<std::string>{"visibility", "shade"}));
  EXPECT_EQ(passesOf(timings[1]), passesOf(timings[0]));
  EXPECT_EQ(batch.color(shots[0])->values, batch.color(shots[1])->values);
}

}  // namespace facts_test
}  // namespace strobe::session
