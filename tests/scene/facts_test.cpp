// SPDX-License-Identifier: MIT
// Facts of frames of scenes with one or two nodes: the construction of each scene shows the expected facts.
#include "scene/facts.h"

#include <gtest/gtest.h>

#include "math/constants.h"

namespace strobe::scene {
namespace facts_test {

constexpr double kFrame = 1.0 / 24;

// A triangle at node 0, a light, and a camera at the last node.
Scene still() {
  Scene scene;
  scene.name = "test";
  scene.materials.resize(1);
  scene.meshes.resize(1);
  scene.meshes[0].geometries.push_back({{{}, {}, {}}, {0, 1, 2}});
  scene.lights.resize(1);
  scene.cameras.resize(1);
  scene.nodes.resize(3);
  scene.nodes[0].mesh = scene.nodes[1].light = scene.nodes[2].camera = 0;
  return scene;
}

// Raster time at `frame`, with an exposure of half a frame interval that ends there.
FrameView viewAt(double frame) {
  FrameView view;
  view.raster_s = view.close_s = frame * kFrame;
  view.open_s = view.raster_s - kFrame / 2;
  view.previous_s = view.raster_s - kFrame;
  return view;
}

Facts factsOf(const Scene& scene, const FrameView& view, std::optional<bool> camera_moves = {}) {
  return factsOf(FramePoser(scene, 2, "all", view), camera_moves);
}

bool moves(const Scene& scene, double frame = 1) { return factsOf(scene, viewAt(frame)).motion; }

using Interpolation = Track::Interpolation;

Scene animated(const std::vector<double>& frames, const std::vector<double>& x,
               Interpolation how = Interpolation::Linear) {
  Scene scene = still();
  Track track{0, Track::Target::Translation, how, {}, {}};
  for (double frame : frames) track.times.push_back(frame * kFrame);
  for (double value : x) track.values.push_back({value, 0, 0, 0});
  scene.animations.push_back({"clip", {track}, track.times.back()});
  return scene;
}

Scene spun(int node, double turns_per_frame) {
  Scene scene = still();
  ConstantMotion motion;
  motion.node = node;
  motion.angular_velocity = turns_per_frame * 2 * kPi / kFrame;
  scene.motions.push_back(motion);
  return scene;
}

TEST(Facts, NothingMovesWithoutAnimation) {
  Facts facts = factsOf(still(), viewAt(1));
  EXPECT_FALSE(facts.motion);
  EXPECT_FALSE(facts.camera_moves);
  EXPECT_FALSE(facts.alpha);
  EXPECT_TRUE(facts.shadows);
}

TEST(Facts, NamesTheInstancesThatMove) {
  EXPECT_EQ(factsOf(still(), viewAt(1)).moves, std::vector<bool>(instancesOf(still()).size(), false));
  Scene scene = animated({0, 0.25, 0.5, 0.75, 1}, {0, 1, 0, 1, 0});
  std::vector<bool> expected;
  for (const Instance& instance : instancesOf(scene)) expected.push_back(instance.node == 0);
  EXPECT_EQ(factsOf(scene, viewAt(1)).moves, expected);
}

TEST(Facts, ClipThatReturnsMoves) {
  // The poses at the raster time, shutter open and the previous frame are equal: the node only moves in between.
  EXPECT_TRUE(moves(animated({0, 0.25, 0.5, 0.75, 1}, {0, 1, 0, 1, 0})));
  EXPECT_TRUE(moves(animated({0, 0.5, 1, 2}, {0, 1, 0, 0})));
}

TEST(Facts, ClipAsLongAsAFrameMoves) {
  Scene scene = animated({0, 0.5, 1}, {0, 1, 0});
  for (double frame : {1.0, 2.0, 3.0, 7.0}) EXPECT_TRUE(moves(scene, frame)) << frame;
}

TEST(Facts, FullTurnMoves) {
  for (double turns : {1.0, 2.0, 0.25, 1e-9}) EXPECT_TRUE(moves(spun(0, turns))) << turns;
  EXPECT_FALSE(moves(spun(0, 0)));
}

TEST(Facts, ClipIsStaticOutsideItsKeys) {
  Scene scene = animated({10, 12}, {0, 1});
  EXPECT_FALSE(moves(scene, 5));
  EXPECT_FALSE(moves(scene, 10));
  EXPECT_TRUE(moves(scene, 10.25));
  EXPECT_TRUE(moves(scene, 12));
  // After its end the clip starts again, before its first key.
  EXPECT_TRUE(moves(scene, 12.5));
  EXPECT_FALSE(moves(scene, 18));
}

TEST(Facts, ClipIsStaticBetweenEqualKeys) {
  Scene scene = animated({0, 2, 4, 6}, {0, 1, 1, 2});
  EXPECT_FALSE(moves(scene, 3.5));
  EXPECT_TRUE(moves(scene, 2.5));
  EXPECT_TRUE(moves(scene, 4.5));
}

TEST(Facts, JumpsAreNotMotion) { EXPECT_FALSE(moves(animated({0, 1, 2}, {0, 1, 2}, Interpolation::Step), 1)); }

TEST(Facts, CubicTangentsMove) {
  Scene scene = animated({0, 4}, {0, 0, 1, 1, 0, 0}, Interpolation::CubicSpline);
  EXPECT_TRUE(moves(scene));
  for (dvec4& value : scene.animations[0].tracks[0].values) value = dvec4(3, 0, 0, 0);
  EXPECT_TRUE(moves(scene));  // the tangents are 3
  for (size_t i : {0, 2, 3, 5}) scene.animations[0].tracks[0].values[i] = dvec4(0);
  EXPECT_FALSE(moves(scene));
}

TEST(Facts, PreviousPoseCounts) {
  Scene scene = animated({0, 0.25, 4}, {0, 1, 1});
  EXPECT_TRUE(moves(scene, 1));
  EXPECT_FALSE(moves(scene, 2));
  FrameView view = viewAt(1);
  view.previous_s = view.open_s;
  EXPECT_FALSE(factsOf(scene, view).motion);
}

TEST(Facts, MeshWithoutTrianglesDoesNotMove) {
  Scene scene = spun(0, 0.1);
  scene.meshes[0].geometries[0].indices.clear();
  EXPECT_FALSE(moves(scene));
  scene.nodes[0].mesh = -1;
  EXPECT_FALSE(moves(scene));
}

TEST(Facts, ChildrenOfMovingNodesMove) {
  Scene scene = spun(1, 0.1);
  EXPECT_TRUE(moves(scene)) << "a light";
  scene.nodes[1].light = -1;
  EXPECT_FALSE(moves(scene));
  scene.nodes[0].parent = 1;
  EXPECT_TRUE(moves(scene));
}

TEST(Facts, CameraMovesUnlessReplaced) {
  Scene scene = spun(2, 0.1);
  FrameView view = viewAt(1);
  EXPECT_TRUE(factsOf(scene, view).camera_moves);
  EXPECT_TRUE(factsOf(scene, view).motion);
  EXPECT_FALSE(factsOf(scene, view, false).motion);
  EXPECT_TRUE(factsOf(still(), view, true).motion);
}

TEST(Facts, MotionWithShareZeroIsStatic) {
  FrameView view = viewAt(1);
  view.object_share = 0;
  EXPECT_FALSE(factsOf(spun(0, 0.1), view).motion) << "a triangle";
  EXPECT_FALSE(factsOf(spun(1, 0.1), view).motion) << "a light";
  EXPECT_TRUE(factsOf(spun(2, 0.1), view).motion) << "the camera";
  view.followed = 0;
  EXPECT_TRUE(factsOf(spun(0, 0.1), view).motion) << "a triangle with the camera's share";
  view.camera_share = 0;
  for (int node : {0, 1, 2}) EXPECT_FALSE(factsOf(spun(node, 0.1), view).motion) << node;
  EXPECT_FALSE(factsOf(still(), view, true).motion);
}

TEST(Facts, NothingMovesInAnEmptyInterval) {
  FrameView view = viewAt(1);
  view.open_s = view.previous_s = view.raster_s;
  for (int node : {0, 1, 2}) EXPECT_FALSE(factsOf(spun(node, 0.1), view).motion) << node;
  EXPECT_FALSE(factsOf(animated({0, 4}, {0, 1}), view).motion);
}

TEST(Facts, FrameWithACutIsStatic) {
  Scene scene = spun(0, 0.1);
  scene.cuts = {0.75 * kFrame};
  EXPECT_FALSE(moves(scene, 1));
  EXPECT_TRUE(moves(scene, 2));
}

TEST(Facts, KeysOfLensesAndLightsCount) {
  for (bool of_camera : {true, false}) {
    Scene scene = animated({0, 4}, {1, 1});
    const Track::Target target = of_camera ? Track::Target::FieldOfView : Track::Target::Intensity;
    scene.animations[0].tracks.push_back({0, target, Interpolation::Linear, {0, 4 * kFrame}, {dvec4(1), dvec4(2)}});
    FrameView view = viewAt(1);
    EXPECT_TRUE(factsOf(scene, view).motion) << of_camera;
    (of_camera ? view.camera_share : view.object_share) = 0;
    EXPECT_FALSE(factsOf(scene, view).motion) << of_camera;
  }
}

TEST(Facts, UnplayedAnimationIsStatic) {
  const Scene scene = animated({0, 4}, {0, 1});
  EXPECT_FALSE(factsOf(FramePoser(scene, 2, "none", viewAt(1))).motion);
}

TEST(Facts, AlphaCountsIfItsMaterialIsDrawn) {
  Scene scene = still();
  scene.materials.resize(2);
  scene.materials[1].alpha = Material::Alpha::Mask;
  EXPECT_FALSE(factsOf(scene, viewAt(1)).alpha);
  scene.meshes[0].geometries[0].material = 1;
  EXPECT_TRUE(factsOf(scene, viewAt(1)).alpha);
  scene.nodes[0].mesh = -1;
  EXPECT_FALSE(factsOf(scene, viewAt(1)).alpha);
}

TEST(Facts, ShadowsNeedALightThatCastsThem) {
  Scene scene = still();
  scene.lights[0].shadow = false;
  EXPECT_FALSE(factsOf(scene, viewAt(1)).shadows);
  scene.lights[0].shadow = true;
  scene.nodes[1].light = -1;
  EXPECT_FALSE(factsOf(scene, viewAt(1)).shadows);
}

}  // namespace facts_test
}  // namespace strobe::scene
