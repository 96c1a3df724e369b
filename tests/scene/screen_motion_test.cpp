// SPDX-License-Identifier: MIT
// Screen-space motion of objects: simple cases, and random cases compared with inside points, posed and projected one
// by one.
#include "scene/screen_motion.h"

#include <gtest/gtest.h>

#include <functional>
#include <random>

#include "scene/motion.h"

namespace strobe::scene {
namespace screen_motion_test {

constexpr double kFrame = 1.0 / 24;
constexpr int kWidth = 400, kHeight = 300;

// 300 px at a depth of 10 m span 10 m.
constexpr double kMetre = 30;

FrameView frameAtOne() { return {kFrame, 0.5 * kFrame, kFrame, 0, {}, kWidth, kHeight}; }

// Boxes by node, `size` in each direction from `at`; the last node is the camera at the origin, looking along -z.
class Boxes {
 public:
  Boxes() {
    scene_.materials.resize(1);
    scene_.cameras.resize(1);
    scene_.cameras[0].vertical_fov = 2 * std::atan(0.5);
    add(dvec3(0), dvec3(0));
    scene_.nodes[0].mesh = -1;
    scene_.nodes[0].camera = 0;
  }

  int add(const dvec3& at, const dvec3& size) {
    Mesh& mesh = scene_.meshes.emplace_back();
    Geometry& geometry = mesh.geometries.emplace_back();
    for (int i = 0; i < 8; ++i) {
      dvec3 sign(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1);
      geometry.vertices.push_back({vec3(size * sign * 0.5), vec3(0, 0, 1)});
    }
    geometry.indices = {0, 1, 2};
    Node& node = scene_.nodes.emplace_back();
    node.mesh = int(scene_.meshes.size()) - 1;
    node.transform.translation = at;
    return int(scene_.nodes.size()) - 1;
  }

  // Motion per frame interval.
  void move(int node, const dvec3& by) { motionOf(node).velocity = by / kFrame; }
  void spin(int node, const dvec3& axis, double radians) {
    motionOf(node).axis = glm::normalize(axis);
    motionOf(node).angular_velocity = radians / kFrame;
  }

  const Scene& scene() const { return scene_; }

  ScreenMotion motion() const {
    Poser poser(scene_, 0);
    return screenMotionOf(
        scene_, [&](double time_s) { return poser.at(time_s); }, frameAtOne());
  }

  // Path of the box at `node`.
  ScreenPath path(int node = 1) const { return motion().paths.at(size_t(node) - 1); }

 private:
  ConstantMotion& motionOf(int node) {
    for (ConstantMotion& motion : scene_.motions)
      if (motion.node == node) return motion;
    scene_.motions.emplace_back().node = node;
    scene_.motions.back().rest_time = kFrame;
    return scene_.motions.back();
  }

  Scene scene_;
};

std::string textOf(const ScreenPath& path) {
  return std::string(path.curved ? "curved " : "") + (path.turns ? "turns " : "") +
         (path.may_be_occluded ? "covered " : "");
}

std::string textOf(const PixelArea& area) {
  std::string text;
  for (int value : {area.x0, area.y0, area.x1, area.y1}) text += (text.empty() ? "" : " ") + std::to_string(value);
  return text;
}

const dvec3 kCard(2, 2, 0), kBox(2, 2, 2);

TEST(ScreenMotion, SlidingCardIsStraight) {
  Boxes boxes;
  int card = boxes.add({0, 0, -10}, kCard);
  boxes.add({0, 0, -15}, {30, 30, 0});
  EXPECT_EQ(textOf(boxes.path()), "");
  boxes.move(card, {2, 1, 0});
  EXPECT_EQ(textOf(boxes.path()), "");
  EXPECT_EQ(boxes.motion().moving_rect.x1,
            int(std::ceil(kWidth / 2.0 + kMetre + 2 + kMetre * std::hypot(1, 0.5) / 32)));
}

// The rectangle includes lines and curves fitted to uneven motion, and extrapolated positions.
TEST(ScreenMotion, UnevenMotionExtendsTheRectangle) {
  Boxes boxes;
  int card = boxes.add({0, 0, -10}, kCard);
  boxes.move(card, {2, 0, 0});
  Poser poser(boxes.scene(), 0);
  // `gone` maps elapsed frames to frames of motion.
  auto left_edge = [&](const std::function<double(double)>& gone) {
    auto pose_at = [&](double time_s) { return poser.at(gone(time_s / kFrame) * kFrame); };
    return screenMotionOf(boxes.scene(), pose_at, frameAtOne()).moving_rect.x0;
  };
  const double even_px = left_edge([](double frames) { return frames; });
  EXPECT_NEAR(even_px, kWidth / 2.0 - 2 * kMetre - 2, 2);
  // In the middle of the exposure the card is a quarter frame ahead; the leftmost position is unchanged.
  const double ahead_px = 0.25 * 2 * kMetre;
  EXPECT_NEAR(left_edge([](double frames) { return frames + 4 * std::max(frames - 0.5, 0.0) * (1 - frames); }),
              even_px - 2 * ahead_px, 3);
  // Twice the speed before the exposure: extrapolated to half a frame's motion further left than at shutter open.
  EXPECT_NEAR(left_edge([](double frames) { return frames < 0.5 ? 3 * frames - 1 : frames; }),
              even_px - 0.5 * 2 * kMetre, 2);
}

// The moving area at a pose includes a margin of two pixels and lies within the moving rectangle.
TEST(ScreenMotion, AreaAtAPoseIsWithinTheRectangle) {
  Boxes boxes;
  int card = boxes.add({0, 0, -10}, kCard);
  boxes.move(card, {2, 0, 0});
  const ScreenMotion motion = boxes.motion();
  Poser poser(boxes.scene(), 0);
  ASSERT_TRUE(motion.area_at);
  const PixelArea now = motion.area_at(poser.at(kFrame)), before = motion.area_at(poser.at(0.75 * kFrame));
  EXPECT_EQ(now.x1, int(std::ceil(kWidth / 2.0 + kMetre + 2)));
  EXPECT_EQ(before.x1, int(std::ceil(kWidth / 2.0 + 0.5 * kMetre + 2)));
  EXPECT_EQ(now.y0, before.y0);
  for (const PixelArea& area : {now, before}) {
    EXPECT_GE(area.x0, motion.moving_rect.x0);
    EXPECT_LE(area.x1, motion.moving_rect.x1);
  }

  Boxes behind;
  behind.move(behind.add({0, 0, 1}, kCard), {1, 0, 0});
  EXPECT_FALSE(behind.motion().area_at) << "not clearly in front of the camera";
}

// The card was static until the previous frame and then slides: with earlier frames, the motion is not uniform.
TEST(ScreenMotion, EarlierFramesCurveThePath) {
  Boxes boxes;
  boxes.move(boxes.add({0, 0, -10}, kCard), {2, 1, 0});
  Poser poser(boxes.scene(), 0);
  auto pose_at = [&](double time_s) { return poser.at(std::max(time_s, 0.0)); };
  FrameView frame = frameAtOne();
  EXPECT_FALSE(screenMotionOf(boxes.scene(), pose_at, frame).paths.at(0).curved);
  frame.earlier_s = {-kFrame};
  EXPECT_TRUE(screenMotionOf(boxes.scene(), pose_at, frame).paths.at(0).curved);
}

TEST(ScreenMotion, BoxWithDepthTurns) {
  Boxes boxes;
  boxes.move(boxes.add({0, 0, -10}, kBox), {2, 0, 0});
  EXPECT_EQ(textOf(boxes.path()), "turns covered ");
}

TEST(ScreenMotion, RotationAndApproachAreCurved) {
  Boxes spun, nearer;
  spun.spin(spun.add({0, 0, -10}, kCard), {0, 0, 1}, 0.5);
  EXPECT_EQ(textOf(spun.path()), "curved turns covered ");
  nearer.move(nearer.add({1, 0, -10}, kCard), {0, 0, 2});
  EXPECT_EQ(textOf(nearer.path()), "curved turns covered ");
}

TEST(ScreenMotion, CardBehindAnotherMayBeOccluded) {
  for (double depth : {5, 9, 11}) {
    Boxes boxes;
    boxes.move(boxes.add({0, 0, -10}, kCard), {1, 0, 0});
    boxes.add({0, 0, -depth}, {0.1, 0.1, 0});
    EXPECT_EQ(textOf(boxes.path()), depth < 10 ? "covered " : "") << depth;
  }
  Boxes beside;
  beside.move(beside.add({0, 0, -10}, kCard), {1, 0, 0});
  beside.add({0, 2, -5}, {0.1, 0.1, 0});
  EXPECT_EQ(textOf(beside.path()), "");
}

TEST(ScreenMotion, UnknownPathsAreConservative) {
  Boxes behind, round;
  behind.move(behind.add({0, 0, 1}, kCard), {1, 0, 0});
  EXPECT_EQ(textOf(behind.path()), "curved turns covered ");
  EXPECT_EQ(behind.motion().moving_rect.x1 - behind.motion().moving_rect.x0, kWidth);
  round.spin(round.add({0, 0, -10}, kCard), {0, 0, 1}, 400);
  EXPECT_EQ(round.motion().moving_rect.x1 - round.motion().moving_rect.x0, kWidth);
}

// A path classified as straight, or as equal for all points, is so for any inside point.
TEST(ScreenMotion, HoldsForEveryPoint) {
  std::mt19937 random(1);
  auto between = [&](double low, double high) { return std::uniform_real_distribution<double>(low, high)(random); };
  int straight = 0, whole = 0;
  for (int round = 0; round < 400; ++round) {
    Boxes boxes;
    const dvec3 size(between(0.1, 3), between(0.1, 3), round % 3 ? std::pow(10, between(-5, 0)) : 0);
    const int node = boxes.add({between(-4, 4), between(-3, 3), between(-20, -6)}, size);
    const double deep = round % 2 ? std::pow(10, between(-6, -1)) : 0;
    boxes.move(node, {between(-2, 2), between(-2, 2), deep});
    if (round % 5 == 0) boxes.spin(node, {between(-1, 1), between(-1, 1), 1}, std::pow(10, between(-5, -1)));
    const ScreenPath path = boxes.path();
    straight += !path.curved, whole += !path.turns;
    Poser poser(boxes.scene(), 0);
    auto pixel = [&](const dvec3& inside, double part) {
      dvec3 p = poser.at(part * kFrame).world_from_instance[0] * dvec4(inside * size * 0.5, 1);
      return dvec2(p.x, -p.y) / -p.z * double(kHeight);
    };
    const dvec2 first = pixel(dvec3(-1), 1) - pixel(dvec3(-1), 0);
    for (int k = 0; k < 50; ++k) {
      const dvec3 inside(between(-1, 1), between(-1, 1), between(-1, 1));
      const double part = between(0, 1);
      const dvec2 from = pixel(inside, 0), to = pixel(inside, 1);
      if (!path.curved) EXPECT_LE(glm::length(pixel(inside, part) - glm::mix(from, to, part)), 0.05) << round;
      if (!path.turns) EXPECT_LE(glm::length(to - from - first), 0.1) << round;
    }
  }
  EXPECT_GT(straight, 100);
  EXPECT_LT(straight, 400);
  EXPECT_GT(whole, 40);
  EXPECT_LT(whole, straight);
}

}  // namespace screen_motion_test
}  // namespace strobe::scene
