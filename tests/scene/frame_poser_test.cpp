// SPDX-License-Identifier: MIT
#include "scene/frame_poser.h"

#include <gtest/gtest.h>

#include "common/refusal.h"
#include "scene/json_scene.h"
#include "scene/motion.h"

namespace strobe::scene {
namespace frame_poser_test {

// A car with a wheel, a ball, a lamp and a camera, each with its own motion at 1 m/s.
Scene sceneWith(const std::string& of_scene, const std::string& of_car, const std::string& of_camera) {
  auto cuts = [](const std::string& times) { return times.empty() ? "" : ",\"cuts\":[" + times + "]"; };
  const std::string sphere = R"("shape":{"kind":"shape","type":"sphere","segments":8})";
  const std::string x = R"("motion":{"velocity":[1,0,0]})";
  std::string text = R"({"kind":"scene","name":"s","nodes":[)";
  text += R"({"kind":"node","name":"car",)" + sphere + "," + x + cuts(of_car) +
          R"(,"children":[{"kind":"node","name":"wheel",)" + sphere + R"(,"motion":{"velocity":[0,1,0]}}]},)";
  text += R"({"kind":"node","name":"ball",)" + sphere + "," + x + "},";
  text += R"({"kind":"node","name":"lamp","light":{"kind":"light","type":"point"},)" + x + "},";
  text +=
      R"({"kind":"node","name":"eye","camera":{"kind":"camera","type":"perspective"},)" + x + cuts(of_camera) + "}]";
  return sceneFromJson(Json::parse(text + cuts(of_scene) + "}"), "test.lua");
}

struct Places {
  dvec3 car, wheel, ball, lamp, eye;
};

Places placesAt(const Scene& scene, const FrameView& times, double time_s) {
  Pose pose = FramePoser(scene, cameraNode(scene, ""), "all", times).at(time_s);
  auto place = [](const dmat4& world) { return dvec3(world[3]); };
  return {place(pose.world_from_instance[0]), place(pose.world_from_instance[1]), place(pose.world_from_instance[2]),
          place(pose.world_from_light[0]), place(pose.world_from_camera)};
}

const FrameView kTimes{2, 1, 2};  // exposure from 1 s to 2 s, raster time at its end

TEST(FramePoser, EqualsThePoserWithoutCuts) {
  Scene scene = sceneWith("", "", "");
  Poser poser(scene, cameraNode(scene, ""));
  FramePoser frame(scene, cameraNode(scene, ""), "all", kTimes);
  for (double time_s : {0., 1., 1.3, 2.}) {
    Pose expected = poser.at(time_s, 2), pose = frame.at(time_s);
    EXPECT_EQ(pose.world_from_instance, expected.world_from_instance);
    EXPECT_EQ(pose.world_from_camera, expected.world_from_camera);
    EXPECT_EQ(pose.world_from_light, expected.world_from_light);
  }
}

TEST(FramePoser, CutWithinTheExposureStopsAllMotion) {
  for (const char* cut : {"1.5", "2", "0.3, 1.01, 9"}) {
    Scene scene = sceneWith(cut, "", "");
    for (double time_s : {0., 1., 1.5, 1.9, 2.}) {
      Places at = placesAt(scene, kTimes, time_s);
      for (const dvec3& place : {at.car, at.ball, at.lamp, at.eye}) EXPECT_EQ(place, dvec3(2, 0, 0)) << cut;
      EXPECT_EQ(at.wheel, dvec3(2, 2, 0)) << cut;
    }
  }
}

// The cut is at shutter open or after the exposure. A time on the other side of a cut has the raster time's pose.
TEST(FramePoser, CutOutsideTheExposureHasNoEffect) {
  for (const char* cut : {"1", "2.01"}) {
    Scene scene = sceneWith(cut, "", "");
    EXPECT_EQ(placesAt(scene, kTimes, 1).ball, dvec3(1, 0, 0)) << cut;
    EXPECT_EQ(placesAt(scene, kTimes, .5).ball, dvec3(cut == std::string("1") ? 2 : .5, 0, 0)) << cut;
  }
}

TEST(FramePoser, CutOfANodeAppliesToItsChildren) {
  Places at = placesAt(sceneWith("", "1.5", ""), kTimes, 1);
  EXPECT_EQ(at.car, dvec3(2, 0, 0));
  EXPECT_EQ(at.wheel, dvec3(2, 2, 0));
  EXPECT_EQ(at.ball, dvec3(1, 0, 0));
  EXPECT_EQ(at.eye, dvec3(1, 0, 0));
  at = placesAt(sceneWith("", "", "1.5"), kTimes, 1);
  EXPECT_EQ(at.eye, dvec3(2, 0, 0));
  EXPECT_EQ(at.car, dvec3(1, 0, 0));
}

TEST(FramePoser, SharesScaleTheTimeFromTheRasterTime) {
  Scene scene = sceneWith("", "", "");
  FrameView times = kTimes;
  times.camera_share = .25;
  times.object_share = .5;
  Places at = placesAt(scene, times, 1);
  EXPECT_EQ(at.eye, dvec3(1.75, 0, 0));
  EXPECT_EQ(at.ball, dvec3(1.5, 0, 0));
  EXPECT_EQ(at.lamp, dvec3(1.5, 0, 0));
  EXPECT_EQ(at.wheel, dvec3(1.5, 1.5, 0));
  times.followed = 0;
  at = placesAt(scene, times, 1);
  EXPECT_EQ(at.car, dvec3(1.75, 0, 0));
  EXPECT_EQ(at.wheel, dvec3(1.75, 1.75, 0));
  EXPECT_EQ(at.ball, dvec3(1.5, 0, 0));
  EXPECT_EQ(FramePoser(scene, cameraNode(scene, ""), "all", times).cameraTime(1), 1.75);
}

// Cuts of the frame apply in addition to cuts of the scene.
TEST(FramePoser, CutsOfAFrameApply) {
  Scene scene = sceneWith("9", "", "");
  FrameView times = kTimes;
  times.cuts = {.5, 1.5};
  Places at = placesAt(scene, times, 1);
  for (const dvec3& place : {at.car, at.ball, at.lamp, at.eye}) EXPECT_EQ(place, dvec3(2, 0, 0));
  EXPECT_EQ(FramePoser(scene, cameraNode(scene, ""), "all", times).cameraTime(1), 2);
}

// A clip of 2 s with a cut at 0.5 s, and a clip with a cut at its start or end.
TEST(FramePoser, ClipsReachTheirCutsInEachRound) {
  Animation clip;
  clip.duration = 2;
  auto comes = [&](double from_s, double to_s) { return comesToACut(clip, from_s, to_s); };
  EXPECT_FALSE(comes(0, 100));
  clip.cuts = {.5};
  EXPECT_TRUE(comes(.4, .5));
  EXPECT_FALSE(comes(.5, .6));
  EXPECT_FALSE(comes(.6, 2.4));
  EXPECT_TRUE(comes(2.4, 2.6));
  EXPECT_TRUE(comes(1.9, 2.6));
  EXPECT_TRUE(comes(.4, 2.1));
  EXPECT_TRUE(comes(.6, 2.7));  // a whole round of the clip
  for (double again : {0., 2.}) {
    clip.cuts = {again};
    EXPECT_FALSE(comes(-1, 1)) << again;
    EXPECT_FALSE(comes(1, 2)) << again;  // the clip's end belongs to the previous round
    EXPECT_TRUE(comes(1.9, 2.1)) << again;
    EXPECT_TRUE(comes(2, 2.1)) << again;
    EXPECT_FALSE(comes(2.1, 3.9)) << again;
    EXPECT_TRUE(comes(3.9, 4)) << again;
  }
}

std::string failure(const std::string& cuts) {
  return testing::refusalOf([&] {
    sceneFromJson(Json::parse(R"({"kind":"scene","nodes":[{"kind":"node","name":"a","cuts":)" + cuts + "}]}"),
                  "test.lua");
  });
}

TEST(FramePoser, CutTimesMustIncrease) {
  EXPECT_EQ(failure("[0.5, 1]"), "");
  EXPECT_NE(failure("[1, 0.5]").find("node 'a': 'cuts' do not increase"), std::string::npos) << failure("[1, 0.5]");
  EXPECT_NE(failure("[1, 1]").find("'cuts' do not increase"), std::string::npos);
  EXPECT_NE(failure("0.5").find("'cuts'"), std::string::npos);
  EXPECT_NE(failure("[\"half\"]").find("'cuts'"), std::string::npos);
}

}  // namespace frame_poser_test
}  // namespace strobe::scene
