// SPDX-License-Identifier: MIT
// Number of frames that the window plays before it starts again.
#include <gtest/gtest.h>

#include "common/home.h"
#include "scene/bend.h"
#include "scene/clips.h"
#include "scene/json_scene.h"
#include "scene/motion.h"
#include "script/evaluate.h"

namespace strobe::live {
namespace loop_test {

scene::Scene sceneOf(double loop_s, double clip_s) {
  scene::Scene scene;
  scene.loop_s = loop_s;
  scene.animations.resize(1);
  scene.animations[0].duration = clip_s;
  return scene;
}

TEST(Loop, IsOfTheSceneOrTheLongestClipOrTwoSeconds) {
  EXPECT_EQ(scene::loopFrames(sceneOf(0.5, 3), 24), 12);
  EXPECT_EQ(scene::loopFrames(sceneOf(0, 3), 24), 72);
  EXPECT_EQ(scene::loopFrames(sceneOf(0, 0), 24), 48);
  EXPECT_EQ(scene::loopFrames(sceneOf(0.001, 0), 24), 1);
  for (int frames = 1; frames <= 200; ++frames)
    EXPECT_EQ(scene::loopFrames(sceneOf(0, float(frames / 24.)), 24), frames);
}

// The vase's centre across the picture of the living room, from -1 (left edge) to 1.
TEST(Loop, HasTheVaseOfTheLivingRoomInEveryFrame) {
  const Json description = script::evaluateScene(home(), "living_room", {{"scene.pixels", "60"}});
  const scene::Painter unpainted = [](scene::Pattern pattern) {
    pattern.width = pattern.height = 1;
    return scene::paintPattern(pattern);
  };
  const double fps = description["shot"]["fps"].get<double>();
  const scene::Scene scene = scene::sceneFromJson(description, "living_room",
                                                  {{"width", true, 1, 1e4},
                                                   {"height", true, 1, 1e4},
                                                   {"fps", false, 1, 1e3},
                                                   {"frame", true, 0, 1e4},
                                                   {"exposure", false, 0, 10}},
                                                  unpainted);
  const scene::Poser poser(scene, scene::cameraNode(scene, "main"));
  auto across = [&](int frame) {
    const scene::Pose pose = poser.at(frame / fps);
    const dmat4 vase = poser.nodesAt(frame / fps, frame / fps).at(size_t(scene::nodeByName(scene, "vase")));
    const dvec4 seen = glm::inverse(pose.world_from_camera) * vase[3];
    return seen.x / -seen.z / std::tan(pose.camera.vertical_fov / 2) / (16. / 9);
  };
  const int last = scene::loopFrames(scene, fps);
  EXPECT_LT(across(last), 1);
  EXPECT_GT(across(last + 2), 1) << "the loop has all frames with the vase";
}

}  // namespace loop_test
}  // namespace strobe::live
