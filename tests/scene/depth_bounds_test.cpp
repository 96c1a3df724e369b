// SPDX-License-Identifier: MIT
#include "scene/depth_bounds.h"

#include <gtest/gtest.h>

#include "base/error.h"
#include "scene/json_scene.h"
#include "scene/motion.h"

namespace strobe::scene {
namespace depth_bounds_test {

// A ball 4 m in front of the camera that moves right, and a wall at 10 m; the camera rotates and moves forward.
Scene sceneOf() {
  return sceneFromJson(Json::parse(R"({"kind":"scene","name":"s","nodes":[
    {"kind":"node","name":"ball","position":[0,0,-4],"shape":{"kind":"shape","type":"sphere","segments":8},
     "motion":{"velocity":[1,0,0]}},
    {"kind":"node","name":"wall","position":[0,0,-10],"shape":{"kind":"shape","type":"box","size":[4,4,1]}},
    {"kind":"node","name":"eye","camera":{"kind":"camera","type":"perspective"},
     "motion":{"velocity":[0,0,-2],"axis":[0,1,0],"degrees_per_second":20}}]})"),
                       "test.lua");
}

dmat4 seen(const Pose& pose, size_t index) {
  return glm::inverse(pose.world_from_camera) * pose.world_from_instance[index];
}

double apart(const dmat4& a, const dmat4& b) {
  double most = 0;
  for (int i = 0; i < 4; ++i) most = std::max(most, glm::length(a[i] - b[i]));
  return most;
}

TEST(DepthBounds, TextIsChecked) {
  for (const char* wrong : {"", "1", "1,2,3,4", "2,1", "-1,2", "1,2,-1", "a,b", "nan,2", "inf,inf", "1,2,inf", "1;2"})
    EXPECT_THROW(DepthBounds::from(wrong), Error) << wrong;
  EXPECT_EQ(DepthBounds::from("1,inf").shareAt(1e30), 1);
}

TEST(DepthBounds, SharesFallSmoothly) {
  const DepthBounds hard = DepthBounds::from("2,5"), soft = DepthBounds::from("2,5,1");
  for (double depth : {2., 3., 5.}) {
    EXPECT_EQ(hard.shareAt(depth), 1);
    EXPECT_EQ(soft.shareAt(depth), 1);
  }
  for (double depth : {1.999, 5.001}) EXPECT_EQ(hard.shareAt(depth), 0);
  EXPECT_EQ(soft.shareAt(1.5), 0.5);
  EXPECT_EQ(soft.shareAt(5.5), 0.5);
  EXPECT_EQ(soft.shareAt(5.25), 0.84375);
  EXPECT_EQ(soft.shareAt(6), 0);
  EXPECT_EQ(soft.shareAt(-3), 0);
}

TEST(DepthBounds, ObjectsOutsideAreStaticToTheCamera) {
  const Scene scene = sceneOf();
  Poser poser(scene, cameraNode(scene, ""));
  auto pose_at = [&](double time_s) { return poser.at(time_s); };
  const Pose capture = pose_at(0);
  const std::vector<double> shares = motionShares(scene, capture, DepthBounds::from("3,5"));
  EXPECT_EQ(shares, (std::vector<double>{1, 0}));
  for (double time_s : {-0.5, 0.25, 1.0}) {
    const Pose pose = boundedPose(pose_at, shares, 0, time_s), true_pose = pose_at(time_s);
    EXPECT_EQ(pose.world_from_camera, true_pose.world_from_camera);
    EXPECT_EQ(pose.world_from_instance[0], true_pose.world_from_instance[0]);
    EXPECT_LE(apart(seen(pose, 1), seen(capture, 1)), 1e-12);
    EXPECT_GT(apart(seen(true_pose, 1), seen(capture, 1)), 0.1);
    const Pose half = boundedPose(pose_at, {0.5, 1}, 0, time_s);
    EXPECT_LE(apart(seen(half, 0), seen(pose_at(time_s / 2), 0)), 1e-12);
    EXPECT_EQ(half.world_from_instance[1], true_pose.world_from_instance[1]);
  }
}

}  // namespace depth_bounds_test
}  // namespace strobe::scene
