// SPDX-License-Identifier: MIT
// Flat transforms, and instances that may be flat at some time.
#include "scene/flat.h"

#include <gtest/gtest.h>

#include "scene/motion.h"

namespace strobe::scene {
namespace flat_test {

dmat3 scaling(double x, double y, double z) { return dmat3(x, 0, 0, 0, y, 0, 0, 0, z); }

dmat3 turning(double angle) { return dmat3(glm::mat4_cast(glm::angleAxis(angle, glm::normalize(dvec3(1, 2, 3))))); }

TEST(Flat, OnlySheetsAreFlat) {
  for (double size : {1e-6, 1., 1e6}) {
    EXPECT_TRUE(isFlat(size * scaling(1, 1, 0)));
    EXPECT_TRUE(isFlat(size * turning(.7) * scaling(1, 1e-9, 1) * turning(1.3)));
    EXPECT_FALSE(isFlat(size * turning(.7) * scaling(1, .01, 1) * turning(1.3)));
    EXPECT_FALSE(isFlat(size * scaling(1, 0, 0)));
  }
  EXPECT_FALSE(isFlat(scaling(0, 0, 0)));
  EXPECT_FALSE(isFlat(scaling(1, NAN, 1)));
  // A scale along the object's axes transforms rays to object space exactly; a scale across these axes does not.
  EXPECT_FALSE(isFlat(turning(.7) * scaling(1, 1e-5, 1)));
  EXPECT_TRUE(isFlat(scaling(1, 1e-5, 1) * turning(.7)));
  // A line: two small scales.
  EXPECT_FALSE(isFlat(turning(.7) * scaling(1000, .001, .001)));
}

// A square with a scale keyed over a second.
bool mayFlatten(const std::vector<dvec3>& scales, Track::Interpolation interpolation = Track::Interpolation::Linear) {
  Scene scene;
  scene.materials.emplace_back();
  scene.meshes.emplace_back();
  scene.nodes.resize(2);
  scene.nodes[1].mesh = 0;
  scene.nodes[1].parent = 0;
  Track track{0, Track::Target::Scale, interpolation, {}, {}};
  const size_t values = interpolation == Track::Interpolation::CubicSpline ? 3 : 1;
  for (size_t i = 0; i < scales.size(); ++i) {
    if (i % values == 0) track.times.push_back(double(track.times.size()));
    track.values.push_back(dvec4(scales[i], 0));
  }
  scene.animations.push_back({"clip", {track}, 1});
  return instancesOf(scene).at(0).flattens;
}

TEST(Flat, FindsScalesThatMayVanishAlongOneAxis) {
  EXPECT_TRUE(mayFlatten({{1, 1, 1}, {1, 1, 0}}));
  EXPECT_TRUE(mayFlatten({{1, 1, 1}, {1, 1, -1}}));
  EXPECT_TRUE(mayFlatten({{1, 1, 0}, {2, 2, 0}}));
  EXPECT_FALSE(mayFlatten({{1, 1, 1}, {1, 1, .1}}));
  EXPECT_FALSE(mayFlatten({{-1, 1, 1}, {-2, 1, 1}}));
  // A uniform scale that starts at a point is never flat.
  EXPECT_FALSE(mayFlatten({{0, 0, 0}, {1, 1, 1}}));
  EXPECT_FALSE(mayFlatten({{0, 0, 0}, {1, 2, 1}}));
  // In-tangent, value, out-tangent: y drops below 0 between its keys.
  const auto cubic = Track::Interpolation::CubicSpline;
  EXPECT_TRUE(mayFlatten({{0, 0, 0}, {1, 1, 1}, {0, -9, 0}, {0, 9, 0}, {1, 1, 1}, {0, 0, 0}}, cubic));
  EXPECT_FALSE(mayFlatten({{0, 0, 0}, {1, 1, 1}, {0, -1, 0}, {0, 1, 0}, {1, 1, 1}, {0, 0, 0}}, cubic));
}

// A scale of 0 is the limit of positive scales, so that the front side stays the same.
TEST(Flat, SheetsKeepTheirHandedness) {
  auto determinant = [](const dvec3& scale) {
    return glm::determinant(dmat3(Transform{dvec3(0), dquat(.8, .6, 0, 0), scale}.matrix()));
  };
  EXPECT_GT(determinant({1, 1, 0}), 0);
  EXPECT_LT(determinant({-1, 1, 0}), 0);
  EXPECT_GT(determinant({-1, -1, 0}), 0);
  EXPECT_LT(std::abs(determinant({1, 1, 0})), 1e-11);
}

}  // namespace flat_test
}  // namespace strobe::scene
