// SPDX-License-Identifier: MIT
// The user-controlled camera: invariants, and positions known in closed form.
#include "live/camera.h"

#include <gtest/gtest.h>

#include <cstdio>

namespace strobe::live {
namespace camera_test {

constexpr double kTiny = 1e-12;  // error of a few double operations on numbers near 1

void expectNear(const dvec3& value, const dvec3& wanted, double tolerance = kTiny) {
  EXPECT_LT(glm::length(value - wanted), tolerance) << value.x << " " << value.y << " " << value.z;
}

const Viewpoint kAhead{{0, 0, 5}, {0, 0, 0}};

TEST(Camera, AxesAreARightHandedFrame) {
  expectNear(forwardOf(kAhead), {0, 0, -1});
  expectNear(rightOf(kAhead), {1, 0, 0});
  expectNear(upOf(kAhead), {0, 1, 0});
  Viewpoint oblique{{3, 2, 1}, {-1, 0.5, -4}};
  expectNear(glm::cross(rightOf(oblique), upOf(oblique)), -forwardOf(oblique));
}

TEST(Camera, ViewpointHasTheCamerasDirection) {
  dmat4 world_from_camera = glm::inverse(glm::lookAt(dvec3(1, 2, 3), dvec3(-2, 0, 1), dvec3(0, 1, 0)));
  Viewpoint view = viewpointOf(world_from_camera, 2.5);
  expectNear(view.eye, {1, 2, 3});
  expectNear(forwardOf(view), glm::normalize(dvec3(-3, -2, -2)));
  EXPECT_NEAR(glm::length(view.target - view.eye), 2.5, kTiny);
}

TEST(Camera, QuarterOrbitIsBesideTheTarget) {
  expectNear(orbited(kAhead, kAhead.target, glm::radians(90.0), 0).eye, {5, 0, 0});
  Viewpoint above = orbited(kAhead, kAhead.target, 0, glm::radians(30.0));
  expectNear(above.eye, {0, 2.5, 5 * std::cos(glm::radians(30.0))});
}

TEST(Camera, OrbitKeepsTargetAndDistance) {
  Viewpoint view{{3, 2, 1}, {-1, 0.5, -4}};
  double distance = glm::length(view.target - view.eye);
  for (int i = 0; i < 100; ++i) view = orbited(view, {-1, 0.5, -4}, 0.37, i % 2 ? 0.2 : -0.15);
  expectNear(view.target, {-1, 0.5, -4}, 1e-10);                      // 100 steps
  EXPECT_NEAR(glm::length(view.target - view.eye), distance, 1e-10);  // 100 steps
}

// The surface under the pointer at the start of a drag stays under the pointer, at the same depth.
TEST(Camera, OrbitKeepsItsPivotOnScreen) {
  Viewpoint view{{3, 2, 1}, {-1, 0.5, -4}};
  const dvec2 from_middle_px(-37, 21);
  const double metres_per_px = 0.01, depth = 2.4;
  const dvec3 pivot = pointAt(view, from_middle_px, metres_per_px, depth);
  EXPECT_NEAR(glm::dot(pivot - view.eye, forwardOf(view)), depth, kTiny);
  for (int i = 0; i < 20; ++i) {
    view = orbited(view, pivot, 0.2, i % 2 ? 0.2 : -0.15);
    expectNear(pointAt(view, from_middle_px, metres_per_px, depth), pivot, 1e-11);  // 20 steps
    EXPECT_NEAR(glm::length(view.target - view.eye), std::sqrt(43.25), 1e-11);
  }
}

TEST(Camera, RoundedViewIsShortAsText) {
  const Viewpoint view = rounded(turned({{1.0 / 3, -2e-5 / 3, 1234.5678901234}, {0, 1, 0}}, 0.123, 0.4));
  EXPECT_LE(toText(view).size(), 6 * 13u) << toText(view);
  EXPECT_EQ(rounded(view), view);
  expectNear(view.eye, {1.0 / 3, -2e-5 / 3, 1234.5678901234},
             5e-4);  // half a unit of the last digit of the largest component
}

TEST(Camera, PolesAreNeverReached) {
  Viewpoint top = orbited(kAhead, kAhead.target, 0, 10);
  EXPECT_GT(top.eye.y, 4.99);
  EXPECT_GT(glm::length(glm::cross(forwardOf(top), dvec3(0, 1, 0))), 0.008);
  Viewpoint down = turned(kAhead, 0, -10);
  EXPECT_LT(forwardOf(down).y, -0.99);
  EXPECT_GT(orbited(top, top.target, 1, 0).eye.y, 4.99);
}

TEST(Camera, TurningRightLooksRight) {
  Viewpoint view = turned(kAhead, glm::radians(90.0), 0);
  expectNear(view.eye, {0, 0, 5});
  expectNear(forwardOf(view), {1, 0, 0});
}

TEST(Camera, PannedPointStaysUnderThePointer) {
  // A field of view of 90 degrees spans 10 m at a distance of 5 m: 0.1 m per pixel of 100.
  Viewpoint view = panned(kAhead, 10, 20, 100, glm::radians(90.0));
  expectNear(view.eye, {-1, 2, 5});
  expectNear(view.target, {-1, 2, 0});
}

TEST(Camera, DollyScalesTheDistanceAndStops) {
  expectNear(dollied(kAhead, 0.5).eye, {0, 0, 2.5});
  expectNear(dollied(kAhead, 1e-9).eye, {0, 0, 1e-3});
  expectNear(dollied(dollied(kAhead, 1.25), 0.8).eye, kAhead.eye);
}

TEST(Camera, FlyingKeepsTheDirection) {
  Viewpoint view = flown(kAhead, {1, 2, 3});
  expectNear(view.eye, {1, 2, 2});
  expectNear(forwardOf(view), {0, 0, -1});
}

TEST(Camera, TextReadsBackTheSame) {
  Viewpoint view{{0.1, 1.0 / 3, -2}, {1e-7, 4, 5.5}};
  double v[6];
  ASSERT_EQ(std::sscanf(toText(view).c_str(), "%lf,%lf,%lf,%lf,%lf,%lf", v, v + 1, v + 2, v + 3, v + 4, v + 5), 6);
  EXPECT_EQ(Viewpoint({{v[0], v[1], v[2]}, {v[3], v[4], v[5]}}), view);
}

}  // namespace camera_test
}  // namespace strobe::live
