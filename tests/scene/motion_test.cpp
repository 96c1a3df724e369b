// SPDX-License-Identifier: MIT
// Poses compared with closed forms that share no code: polynomials, angles, written-out matrix products.
#include "scene/motion.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "common/refusal.h"
#include "math/constants.h"

namespace strobe::scene {
namespace motion_test {

// Error of a few double operations on numbers near 1.
constexpr double kTiny = 1e-12;

void expectNear(const dvec3& got, const dvec3& want, double tolerance = kTiny) {
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(got[i], want[i], tolerance) << "component " << i;
}

Track track(Track::Target target, Track::Interpolation how, std::vector<double> times, std::vector<dvec4> values) {
  return {0, target, how, std::move(times), std::move(values)};
}

Node named(const std::string& name, int parent = -1) {
  Node node;
  node.name = name;
  node.parent = parent;
  return node;
}

// One mesh at the origin of node 0, camera at the last node.
Scene sceneWithCamera(std::vector<Node> nodes) {
  Scene scene;
  scene.name = "test";
  scene.nodes = std::move(nodes);
  scene.meshes.resize(1);
  scene.cameras.resize(1);
  scene.cameras[0].name = "main";
  Node camera = named("eye");
  camera.camera = 0;
  scene.nodes.push_back(camera);
  return scene;
}

TEST(Track, LinearIsTheChord) {
  Track t = track(Track::Target::Translation, Track::Interpolation::Linear, {1, 3}, {{0, 1, 2, 0}, {4, 1, -2, 0}});
  expectNear(dvec3(valueAt(t, 1.5)), {1, 1, 1});
  expectNear(dvec3(valueAt(t, 0)), {0, 1, 2});
  expectNear(dvec3(valueAt(t, 9)), {4, 1, -2});
}

TEST(Track, StepJumpsAtItsKeyOnly) {
  Track t =
      track(Track::Target::Scale, Track::Interpolation::Step, {0, 1, 2}, {{1, 1, 1, 0}, {2, 2, 2, 0}, {3, 3, 3, 0}});
  EXPECT_EQ(valueAt(t, std::nextafter(1.0, 0.0)).x, 1);
  EXPECT_EQ(valueAt(t, 1).x, 2);
  EXPECT_EQ(valueAt(t, std::nextafter(2.0, 0.0)).x, 2);
  EXPECT_EQ(valueAt(t, 2).x, 3);
}

// A cubic equals its Hermite interpolant: x(s) = s^3 - 2s + 1 on [1, 4], with its derivative as tangents.
TEST(Track, CubicSplineReproducesACubic) {
  auto x = [](double s) { return s * s * s - 2 * s + 1; };
  auto slope = [](double s) { return 3 * s * s - 2; };
  std::vector<dvec4> values;
  for (double key : {1.0, 2.5, 4.0}) {
    for (double v : {slope(key), x(key), slope(key)}) values.push_back(dvec4(v, 2 * v, 0, 0));
  }
  Track t = track(Track::Target::Translation, Track::Interpolation::CubicSpline, {1, 2.5, 4}, values);
  for (double s = 1; s <= 4; s += 0.125) EXPECT_NEAR(valueAt(t, s).y, 2 * x(s), 1e-10) << s;
}

TEST(Track, RotationTurnsAtConstantRateAlongTheShorterArc) {
  double half = kPi / 3;  // 120 degrees about z; the second key's sign makes a naive mix take the long way
  Track t = track(Track::Target::Rotation, Track::Interpolation::Linear, {0, 1},
                  {{0, 0, 0, 1}, {0, 0, -std::sin(half), -std::cos(half)}});
  for (double s : {0.0, 0.1, 0.25, 0.5, 0.9, 1.0}) {
    dvec4 q = valueAt(t, s);
    EXPECT_NEAR(std::abs(q.z), std::sin(half * s), kTiny);
    EXPECT_NEAR(std::abs(q.w), std::cos(half * s), kTiny);
    EXPECT_NEAR(glm::length(q), 1, kTiny);
  }
}

TEST(Track, ClipsRepeatPastTheirEnd) {
  EXPECT_EQ(clipTime(-1, 2), -1);
  EXPECT_EQ(clipTime(2, 2), 2);
  EXPECT_EQ(clipTime(2.5, 2), 0.5);
  EXPECT_EQ(clipTime(4, 2), 0);
  EXPECT_EQ(clipTime(7, 0), 0);
  EXPECT_EQ(clipTime(2 * (1 + 1e-8), 2), 2);
  EXPECT_EQ(clipTime(4 * (1 - 1e-8), 2), 0);
}

// Keys on frames 0 to `last`, stored as floats; x is the share of the clip. Exporters divide by the rate or multiply by
// a rounded 1 / rate.
Scene keyedOnFrames(int last, int fps, bool by_product, Track::Interpolation how = Track::Interpolation::Linear) {
  Node box = named("box");
  box.mesh = 0;
  Scene scene = sceneWithCamera({box});
  Animation clip;
  clip.tracks.push_back(track(Track::Target::Translation, how, {}, {}));
  for (int frame = 0; frame <= last; ++frame) {
    clip.tracks[0].times.push_back(by_product ? float(frame) * (1.f / float(fps)) : float(frame / double(fps)));
    clip.tracks[0].values.push_back({frame / double(last), 0, 0, 0});
  }
  clip.duration = clip.tracks[0].times.back();
  scene.animations.push_back(clip);
  return scene;
}

// Calls `check(scene, last, fps)` for every clip length up to 200 frames.
void forEachLength(Track::Interpolation how, const std::function<void(const Scene&, int, double)>& check) {
  for (int fps : {24, 25, 30, 60})
    for (int last = 1; last <= 200; ++last)
      for (bool by_product : {false, true}) check(keyedOnFrames(last, fps, by_product, how), last, fps);
}

TEST(Poser, LastFrameOfAClipShowsItsLastKey) {
  forEachLength(Track::Interpolation::Linear, [](const Scene& scene, int last, double fps) {
    const Poser poser(scene, 1);
    auto place = [&](double time_s) { return poser.at(time_s).world_from_instance[0][3].x; };
    // Times have a relative error below 1e-7, and positions the same relative error.
    EXPECT_NEAR(place(last / fps), 1, 1e-7 * last) << last << " " << fps;
    EXPECT_NEAR(place((last + 0.5) / fps), 0.5 / last, 1e-6) << last << " " << fps;
    const Animation& clip = scene.animations[0];
    EXPECT_FALSE(beginsAgain(clip, (last - 1) / fps, last / fps)) << last << " " << fps;
    EXPECT_TRUE(beginsAgain(clip, (last - 0.5) / fps, (last + 0.25) / fps)) << last << " " << fps;
    EXPECT_TRUE(beginsAgain(clip, last / fps, (last + 0.5) / fps)) << last << " " << fps;
  });
}

TEST(Poser, StepIsAtItsKeyOnTheFrameOfTheKey) {
  forEachLength(Track::Interpolation::Step, [](const Scene& scene, int last, double fps) {
    const Poser poser(scene, 1);
    for (int frame = last; frame >= std::max(0, last - 3); --frame)
      EXPECT_EQ(poser.at(frame / fps).world_from_instance[0][3].x, frame / double(last)) << frame << " " << fps;
  });
}

TEST(Poser, CutOnAFrameIsBeforeThatFrame) {
  for (double fps : {24., 25., 30., 60.})
    for (int frame = 1; frame <= 200; ++frame) {
      const std::vector<double> cuts = {double(float(frame / fps))};
      EXPECT_TRUE(comesToACut(cuts, (frame - 1) / fps, frame / fps)) << frame << " " << fps;
      EXPECT_FALSE(comesToACut(cuts, frame / fps, (frame + 1) / fps)) << frame << " " << fps;
    }
}

// A node with keys at its rest pose keeps its matrix, for any matrix.
TEST(Poser, AnimatedMatrixKeepsItsShear) {
  const dmat4 shear(1, 0, 0, 0, 1, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1);
  const dmat4 turn = glm::mat4_cast(glm::angleAxis(0.7, glm::normalize(dvec3(1, 2, 3))));
  const dmat4 mirror = glm::scale(dmat4(1), dvec3(-2, 3, 0.5)), shift = glm::translate(dmat4(1), dvec3(1, 2, 3));
  const dmat4 flat = glm::scale(dmat4(1), dvec3(0, 2, 1)), needle = glm::scale(dmat4(1), dvec3(0, 2, 0));
  const dmat4 folded(1, 2, 0, 0, 2, 4, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1);  // two columns along one line
  for (const dmat4& matrix :
       {shear, turn, mirror, shift * turn * mirror, turn * shear * mirror, mirror * turn * mirror, turn * flat,
        turn * flat * shear, turn * needle, turn * folded, dmat4(0) + shift - shift}) {
    Node box = named("box");
    box.mesh = 0;
    box.matrix = matrix;
    (*box.matrix)[3].w = 1;
    Scene scene = sceneWithCamera({box});
    splitMatrix(scene.nodes[0]);
    const Node& node = scene.nodes[0];
    scene.animations.emplace_back();
    auto key = [&](Track::Target target, const dvec4& value) {
      scene.animations[0].tracks.push_back(track(target, Track::Interpolation::Linear, {0}, {value}));
    };
    key(Track::Target::Translation, dvec4(node.transform.translation, 0));
    key(Track::Target::Rotation, dvec4(node.transform.rotation.x, node.transform.rotation.y, node.transform.rotation.z,
                                       node.transform.rotation.w));
    key(Track::Target::Scale, dvec4(node.transform.scale, 0));
    // A mesh flattened by its matrix is posed by its vertices.
    auto worldOf = [](const Pose& pose) {
      return pose.bends[0].joints.empty() ? pose.world_from_instance[0] : pose.bends[0].joints[0];
    };
    const dmat4 keyed = worldOf(Poser(scene, 1).at(0)), rest = worldOf(Poser(scene, 1, "none").at(0));
    for (int c = 0; c < 4; ++c) {
      // A scale of 0 is posed as 2^-40 of the length of the scale, at most 2.3e-12 here.
      EXPECT_LE(glm::distance(keyed[c], (*box.matrix)[c]), 4 * kTiny) << c;
      EXPECT_LE(glm::distance(rest[c], (*box.matrix)[c]), 4 * kTiny) << c;
    }
  }
}

TEST(Poser, HierarchyMayBeInAnyOrder) {
  Node child = named("child", 1);  // its parent has a later index
  child.transform.translation = {1, 0, 0};
  child.mesh = 0;
  Node parent = named("parent");
  parent.transform.translation = {0, 5, 0};
  parent.transform.rotation = glm::angleAxis(kPi / 2, dvec3(0, 0, 1));
  parent.transform.scale = {2, 2, 2};
  Scene scene = sceneWithCamera({child, parent});
  scene.meshes[0].origin = {0, 1, 0};
  Pose pose = Poser(scene, cameraNode(scene, "")).at(0);
  // (1,0,0)+(0,1,0), scaled by 2, rotated by a quarter about z, moved by y = 5: (2,2,0) -> (-2,2,0) -> (-2,7,0).
  expectNear(dvec3(pose.world_from_instance.at(0)[3]), {-2, 7, 0});
}

TEST(Poser, CyclesAreRefusedByName) {
  Scene scene = sceneWithCamera({named("a", 1), named("b", 0)});
  const std::string refused = testing::refusalOf([&] { Poser poser(scene, -1); });
  EXPECT_NE(refused.find("its own ancestor"), std::string::npos) << refused;
}

TEST(Poser, ConstantMotionIsInWorldAxesUnderARotatedParent) {
  Node parent = named("parent");
  parent.transform.rotation = glm::angleAxis(0.7, glm::normalize(dvec3(1, 2, 3)));
  Node child = named("child", 0);
  child.transform.translation = {3, 0, 0};
  child.mesh = 0;
  Scene scene = sceneWithCamera({parent, child});
  scene.meshes[0].origin = {0, 0, 2};
  ConstantMotion motion;
  motion.node = 1;
  motion.velocity = {1, 0, -2};
  motion.axis = {0, 1, 0};
  motion.angular_velocity = kPi;
  motion.rest_time = 10;
  scene.motions.push_back(motion);

  Poser poser(scene, 2);
  dvec3 pivot = glm::mat3_cast(parent.transform.rotation) * dvec3(3, 0, 0);
  dvec3 arm = glm::mat3_cast(parent.transform.rotation) * dvec3(0, 0, 2);
  expectNear(dvec3(poser.at(10).world_from_instance[0][3]), pivot + arm);
  // After half a second, a quarter turn about world y maps (x, y, z) to (z, y, -x).
  expectNear(dvec3(poser.at(10.5).world_from_instance[0][3]), pivot + dvec3(arm.z, arm.y, -arm.x) + dvec3(0.5, 0, -1));
}

TEST(Poser, ChildrenFollowAMovingParent) {
  Node parent = named("parent");
  Node child = named("child", 0);
  child.transform.translation = {1, 0, 0};
  child.mesh = 0;
  Scene scene = sceneWithCamera({parent, child});
  ConstantMotion motion;
  motion.axis = {0, 0, 1};
  motion.angular_velocity = kPi / 2;
  motion.velocity = {2, 0, 0};
  motion.node = 0;
  scene.motions.push_back(motion);
  expectNear(dvec3(Poser(scene, 2).at(1).world_from_instance[0][3]), {2, 1, 0});
}

TEST(Poser, AnimationDrivesOnlyItsChannels) {
  Node box = named("box");
  box.transform.scale = {2, 3, 4};
  box.transform.translation = {9, 9, 9};
  box.mesh = 0;
  Scene scene = sceneWithCamera({box});
  Animation clip;
  clip.name = "slide";
  clip.duration = 2;
  clip.tracks.push_back(
      track(Track::Target::Translation, Track::Interpolation::Linear, {0, 2}, {{0, 0, 0, 0}, {2, 0, 0, 0}}));
  scene.animations.push_back(clip);
  Poser poser(scene, 1);
  expectNear(dvec3(poser.at(0.5).world_from_instance[0] * dvec4(1, 1, 1, 1)), {2.5, 3, 4});
  expectNear(dvec3(poser.at(2.5).world_from_instance[0][3]), {0.5, 0, 0});  // starts again
  expectNear(dvec3(poser.at(-3).world_from_instance[0][3]), {0, 0, 0});
  expectNear(dvec3(Poser(scene, 1, "none").at(0.5).world_from_instance[0][3]), {9, 9, 9});
  EXPECT_THROW(Poser(scene, 1, "slid"), Error);
}

TEST(Poser, HeldStepLeavesNoStreak) {
  Node box = named("box");
  box.mesh = 0;
  Scene scene = sceneWithCamera({box});
  Animation clip;
  clip.duration = 2;
  clip.tracks.push_back(track(Track::Target::Translation, Track::Interpolation::Step, {0, 1, 2},
                              {{0, 0, 0, 0}, {5, 0, 0, 0}, {6, 0, 0, 0}}));
  scene.animations.push_back(clip);
  Poser poser(scene, 1);
  EXPECT_EQ(poser.at(0.99).world_from_instance[0][3].x, 0);
  EXPECT_EQ(poser.at(1.01).world_from_instance[0][3].x, 5);
  EXPECT_EQ(poser.at(0.99, 1.01).world_from_instance[0][3].x, 5);
}

TEST(Poser, CameraFrameHasUnitScaleAndIsNotMirrored) {
  Scene scene = sceneWithCamera({named("box")});
  scene.nodes[1].transform.scale = {-3, 3, 3};
  scene.nodes[1].transform.translation = {1, 2, 3};
  dmat4 frame = Poser(scene, 1).at(0).world_from_camera;
  EXPECT_NEAR(glm::determinant(dmat3(frame)), 1, kTiny);
  expectNear(dvec3(frame[2]), {0, 0, 1});
  expectNear(dvec3(frame[1]), {0, 1, 0});
  expectNear(dvec3(frame[3]), {1, 2, 3});
}

TEST(Instances, IncludeGpuInstancesAndMirroring) {
  Node node = named("many");
  node.mesh = 0;
  node.transform.scale = {-1, 1, 1};
  node.instances = {glm::translate(dmat4(1), dvec3(1, 0, 0)), glm::scale(dmat4(1), dvec3(1, -1, 1))};
  Scene scene = sceneWithCamera({named("empty"), node});
  std::vector<Instance> instances = instancesOf(scene);
  ASSERT_EQ(instances.size(), 2u);
  EXPECT_EQ(instances[0].node, 1);
  const Pose pose = Poser(scene, 2).at(0);
  EXPECT_LT(glm::determinant(pose.world_from_instance[0]), 0);
  EXPECT_GT(glm::determinant(pose.world_from_instance[1]), 0);
  expectNear(dvec3(pose.world_from_instance[0][3]), {-1, 0, 0});
}

TEST(Cameras, UnknownNameListsThem) {
  Scene scene = sceneWithCamera({named("box")});
  EXPECT_EQ(cameraNode(scene, "main"), 1);
  EXPECT_EQ(cameraNode(scene, "eye"), 1);
  const std::string refused = testing::refusalOf([&] { cameraNode(scene, "mian"); });
  EXPECT_NE(refused.find("did you mean 'main'?"), std::string::npos) << refused;
}

TEST(MotionOptions, ArePerFrameAndNamed) {
  Scene scene = sceneWithCamera({named("vase"), named("a=b")});
  ConstantMotion move = moveFromOption(scene, "vase=0.5,0,-1e-1", 24, 2);
  EXPECT_EQ(move.node, 0);
  expectNear(move.velocity, {12, 0, -2.4});
  EXPECT_EQ(move.rest_time, 2);
  ConstantMotion spin = spinFromOption(scene, "a=b=0,2,0,90", 10, 0);
  EXPECT_EQ(spin.node, 1);
  expectNear(spin.axis, {0, 1, 0});
  EXPECT_NEAR(spin.angular_velocity, 5 * kPi, kTiny);
}

TEST(MotionOptions, MistakesAreExplained) {
  Scene scene = sceneWithCamera({named("vase")});
  for (const char* bad :
       {"vase", "=1,2,3", "vase=1,2", "vase=1,2,x", "vase=1,2,3,4", "vase=1,2,inf", "vase=", "vsae=1,2,3"}) {
    EXPECT_THROW(moveFromOption(scene, bad, 24, 0), Error) << bad;
  }
  EXPECT_THROW(spinFromOption(scene, "vase=0,0,0,5", 24, 0), Error);
  const std::string refused = testing::refusalOf([&] { moveFromOption(scene, "vsae=1,2,3", 24, 0); });
  EXPECT_NE(refused.find("did you mean 'vase'?"), std::string::npos) << refused;
}

}  // namespace motion_test
}  // namespace strobe::scene
