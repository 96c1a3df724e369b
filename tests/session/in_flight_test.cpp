// SPDX-License-Identifier: MIT
// Several frames under way at once: each equals the same frame alone, and they finish in order.
#include <gtest/gtest.h>

#include "base/files.h"
#include "common/source.h"
#include "lab/batch.h"
#include "lab/drawing.h"
#include "session/home.h"
#include "shader/backends.h"

namespace strobe::session {
namespace in_flight_test {

namespace fs = std::filesystem;
using lab::Drawing;
using lab::Shot;

class InFlightTest : public SessionTest {
 protected:
  static constexpr size_t kInFlight = 3;

  InFlightTest() : flying_(EditableHome::home(), bench()) { flying_.frames_in_flight = kInFlight; }

  // Fills the scene's defaults into the shot.
  static std::unique_ptr<Drawing> drawingOf(lab::Workbench& bench, Shot& shot) {
    std::shared_ptr<const lab::Evaluation> evaluation = bench.evaluate(shot.pipeline, shot.sets);
    std::shared_ptr<lab::HeldScene> scene = bench.scene(shot);
    return std::make_unique<Drawing>(bench, scene, lab::plannedOf(bench, shot, nullptr, evaluation->pipeline),
                                     evaluation);
  }

  // Results of all frames in order, with as many under way as possible.
  static std::vector<graph::FrameResult> drawn(Drawing& drawing, const std::vector<Shot>& shots) {
    std::vector<graph::FrameResult> frames;
    const graph::Graph& graph = drawing.graph();
    for (const Shot& shot : shots) {
      if (graph.underWay() == graph.mostUnderWay()) frames.push_back(drawing.finish());
      drawing.begin(shot);
    }
    while (graph.underWay() > 0) frames.push_back(drawing.finish());
    return frames;
  }

  static void expectSame(const graph::FrameResult& frame, const graph::FrameResult& alone, const std::string& what) {
    EXPECT_EQ(hashes(frame), hashes(alone)) << what;
    EXPECT_EQ(frame.counters, alone.counters) << what;
  }

  // Compares frames of a pipeline from this shot on, under way together and alone.
  void expectSame(Shot shot, int count) {
    lab::Workbench single(EditableHome::home(), bench());
    single.frames_in_flight = 1;
    std::unique_ptr<Drawing> together = drawingOf(flying_, shot), alone = drawingOf(single, shot);
    EXPECT_EQ(together->graph().mostUnderWay(), kInFlight);
    EXPECT_EQ(alone->graph().mostUnderWay(), 1u);
    std::vector<Shot> shots;
    for (int i = 0; i < count; ++i, ++shot.frame) shots.push_back(shot);
    std::vector<graph::FrameResult> frames = drawn(*together, shots);
    ASSERT_EQ(frames.size(), shots.size());
    for (size_t i = 0; i < shots.size(); ++i)
      expectSame(frames[i], alone->draw(shots[i]), fmt::format("{}, frame {}", shot.pipeline, shots[i].frame));
  }

  lab::Workbench flying_;  // shares the device of bench()
};

TEST_F(InFlightTest, FramesTogetherEqualFramesAlone) {
  for (const char* pipeline : {"none", "hybrid", "oberberger2022", "eevee"}) expectSame(smallShot(pipeline), 7);
}

TEST_F(InFlightTest, FramesWithRaysOverAListEqualFramesAlone) {
  const Path tests = sourceFolder() / "tests";
  for (const char* file : {"passes/traced.lua", "shaders/traced.glsl"})
    home_.write(file, readText(tests / "oracle/project" / file));
  home_.write("scripts/pipelines/rays_over_a_list.lua", readText(tests / "session/pipelines/rays_over_a_list.lua"));
  for (const shader::BackendRow& row : shader::backends()) {
    if (!shader::isPresent(row, bench().device().info())) continue;
    Shot shot = smallShot("rays_over_a_list");
    lab::putSetting(shot.sets, "scene.d_b", std::string("0"));  // static pixels are not on the list
    shot.backend = row.name;
    expectSame(shot, 7);
  }
}

TEST_F(InFlightTest, FramesWithDeformationEqualFramesAlone) {
  std::optional<Path> data = EditableHome::home().data();
  if (!data || !fs::exists(*data / "scenes/khronos_samples/CesiumMan.glb"))
    GTEST_SKIP() << "no shared scenes (set STROBE_DATA)";
  for (const shader::BackendRow& row : shader::backends()) {
    if (!shader::isPresent(row, bench().device().info())) continue;
    Shot shot;
    shot.pipeline = "hybrid";
    shot.scene = *data / "scenes/khronos_samples/CesiumMan.glb";
    shot.width = 64, shot.height = 40, shot.fps = 12, shot.frame = 6;
    shot.backend = row.name;
    expectSame(shot, 5);
  }
}

// An image kept from frame to frame includes all frames before. A changed value takes effect in the next frame that
// begins.
TEST_F(InFlightTest, HistoriesAndValuesFollowTheOrderOfFrames) {
  writeRunningMean(home_);
  Shot shot = smallShot("running_mean");
  std::unique_ptr<Drawing> drawing = drawingOf(flying_, shot);
  auto weight = [&] { return drawing->finish().outputs.at("sum").floats.values[3]; };
  auto become = [&](double value) {
    shot.sets.push_back({"weight", value});
    auto evaluation = flying_.evaluate(shot.pipeline, shot.sets);
    drawing->become(lab::plannedOf(flying_, shot, nullptr, evaluation->pipeline), evaluation);
  };
  drawing->begin(shot);
  drawing->begin(shot);
  become(2);
  drawing->begin(shot);
  EXPECT_EQ(weight(), 1);
  become(4);
  drawing->begin(shot);
  EXPECT_EQ(weight(), 2);
  EXPECT_EQ(weight(), 4);
  EXPECT_EQ(weight(), 8);
  drawing->begin(shot);
  drawing->graph().forgetHistories();
  drawing->begin(shot);
  EXPECT_EQ(weight(), 12);
  EXPECT_EQ(weight(), 4);
}

TEST_F(InFlightTest, AbandonedFramesAreDropped) {
  Shot shot = smallShot("hybrid");
  std::unique_ptr<Drawing> drawing = drawingOf(flying_, shot);
  const graph::FrameResult alone = drawing->draw(shot);
  Shot other = shot;
  other.frame = 3;
  drawing->begin(other);
  drawing->begin(other);
  expectSame(drawing->draw(shot), alone, "after two others");
  EXPECT_EQ(drawing->graph().underWay(), 0u);
  // Another graph takes over resources that the device still uses, and a third graph takes over the scene.
  drawing->begin(other);
  auto evaluation = flying_.evaluate(shot.pipeline, shot.sets);
  std::vector<std::string> problems;
  Drawing next(flying_, drawing->held(), lab::plannedOf(flying_, shot, nullptr, evaluation->pipeline), evaluation,
               drawing.get(), &problems);
  expectSame(next.draw(shot), alone, "of the next graph");
  next.begin(other);
  drawing.reset();
  expectSame(next.finish(), drawingOf(flying_, other)->draw(other), "begun before another ends");
}

// A frame whose poses are refused does not change the frames under way.
TEST_F(InFlightTest, RefusedFramesChangeNoOtherFrame) {
  home_.write("scripts/scenes/leaves.lua", R"(local scene = require "strobe.scene"
local grey = scene.material { name = "grey", color = { 0.5, 0.5, 0.5 } }
return scene {
  name = "leaves",
  nodes = {
    scene.node { name = "wall", shape = scene.quad { size = { 9, 9 } }, position = { 0, 0, -6 }, material = grey },
    scene.node { name = "box", shape = scene.box { size = { 1, 1, 1 } }, material = grey },
    scene.node { name = "grows", children = {
      scene.node { name = "far", shape = scene.box { size = { 1, 1, 1 } }, position = { 0, 0, 1e9 }, material = grey } } },
    scene.node { name = "camera", camera = scene.camera { name = "main", fov = 60 } },
  },
  animations = { scene.animation { name = "go", duration = 10, tracks = {
    scene.track { node = "box", times = { 0, 1 }, values = { { -1, 0, -4 }, { 1, 0, -4 } } },
    scene.track { node = "grows", target = "scale", times = { 0, 1, 1.01 },
                  values = { { 1, 1, 1 }, { 1, 1, 1 }, { 1e9, 1e9, 1e9 } } } } } },
}
)");
  Shot shot;
  shot.pipeline = "hybrid", shot.scene = "leaves", shot.width = 64, shot.height = 36, shot.frame = 4;
  lab::Workbench single(EditableHome::home(), bench());
  std::unique_ptr<Drawing> drawing = drawingOf(flying_, shot), alone = drawingOf(single, shot);
  Shot next = shot, gone = shot;
  next.frame = 9, gone.frame = 40;
  drawing->begin(shot);
  EXPECT_THROW(drawing->begin(gone), Error);
  drawing->begin(next);
  EXPECT_THROW(drawing->begin(gone), Error);
  drawing->begin(shot);
  expectSame(drawing->finish(), alone->draw(shot), "before");
  expectSame(drawing->finish(), alone->draw(next), "between");
  expectSame(drawing->finish(), alone->draw(shot), "after");
}

TEST_F(InFlightTest, SubpixelSamplesAreUnderWayTogether) {
  Shot shot = smallShot("hybrid");
  shot.aa = 7;
  expectSame(flying_.render(shot).frame, bench().render(shot).frame, "seven samples");
}

// The host waits for the iterations of a long loop, so no other frame may be under way.
TEST_F(InFlightTest, FramesWithALongLoopRunAlone) {
  Shot shot = smallShot("ground_truth");
  std::unique_ptr<Drawing> drawing = drawingOf(flying_, shot);
  EXPECT_EQ(drawing->graph().mostUnderWay(), 1u);
  drawing->begin(shot);
  EXPECT_EQ(hashes(drawing->finish()), hashes(bench().render(shot).frame));
}

// Shots that share a scene are timed in turn, and each has its own interval.
TEST_F(InFlightTest, FramesAreTimed) {
  lab::Batch batch(flying_);
  std::vector<Shot> shots = {smallShot("none"), smallShot("hybrid"), smallShot("ground_truth")};
  lab::putSetting(shots[2].sets, "samples", std::string("16"));
  for (const lab::Timing& timing : batch.timeInTurn(shots, {2, 2})) {
    ASSERT_EQ(timing.interval_ms.size(), 2u);
    EXPECT_EQ(timing.ms.size(), 2u);
    for (double ms : timing.interval_ms) EXPECT_GT(ms, 0);
  }
}

}  // namespace in_flight_test
}  // namespace strobe::session
