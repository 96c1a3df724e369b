// SPDX-License-Identifier: MIT
// What of the motion does not blur: cuts, and shares of the camera's motion and of objects'. Each picture is that of a
// scene in which the rest moves as much less, by every method and by truth. And exposures in seconds.
#include <fmt/format.h>

#include "oracle/render.h"

namespace strobe::oracle {
namespace {

struct Method {
  std::string pipeline;
  std::vector<std::string> settings;
};
const std::vector<Method>& methods() {
  static const std::vector<Method> methods = {
      {"mcguire2012", {}},
      {"guertin2014", {}},
      {"jimenez2014", {}},
      {"mcguire2012", {"weights=uniform"}},
      {"hybrid", {"preset=seed"}},
      {"hybrid", {"preset=best"}},
      {"hybrid", {"composite=in_gather"}},
      {"hybrid", {"composite=layered", "range=split"}},
      {"hybrid", {"displacement=extrapolated"}},
      {"ground_truth", {"samples=16"}},
      {"ground_truth", {"samples=16", "times=stratified", "shading=full"}},
      {"ground_truth", {"samples=16", "mode=raster"}},
  };
  return methods;
}

lab::Shot jumps(const Numbers& numbers) { return shotOf("jumps", 96, 64, numbers); }

class RenderJumps : public RenderTest {
 protected:
  static image::Image drawn(const lab::Shot& shot, const Method& method, const std::string& anchor) {
    return colorOf(render(with(shot, method.pipeline, method.settings, anchor)));
  }
  // The same picture, bit for bit, by every method.
  static void expectAlike(const lab::Shot& a, const lab::Shot& b, const std::string& anchor, const std::string& what) {
    for (const Method& method : methods())
      EXPECT_TRUE(identical(drawn(a, method, anchor), drawn(b, method, anchor)))
          << what << ", " << method.pipeline << " " << fmt::format("{}", fmt::join(method.settings, " ")) << ", "
          << anchor;
  }
};

// --- Cuts

TEST_F(RenderJumps, ACutOfTheSceneIsThePictureWithoutBlur) {
  const std::pair<std::string, double> cuts[] = {{"close", -.3},         {"close", 0}, {"centre", .2},
                                                 {"centre", -.5 + 1e-6}, {"open", .5}, {"open", 1}};
  image::Image sharp = drawn(jumps({}), {"none", {}}, "close");
  for (const auto& [anchor, cut] : cuts)
    for (const Method& method : methods())
      EXPECT_TRUE(identical(drawn(jumps({{"scene_cut", cut}}), method, anchor), sharp))
          << method.pipeline << " " << anchor << " " << cut;
}

// The capture is on the other side of it, or the exposure does not reach it.
TEST_F(RenderJumps, ACutOutsideOfTheExposureChangesNothing) {
  const std::pair<std::string, double> cuts[] = {{"close", -1.01}, {"close", .1}, {"open", 0}, {"open", 1.01}};
  for (const auto& [anchor, cut] : cuts)
    for (const Method& method : methods()) {
      if (method.settings == std::vector<std::string>{"displacement=extrapolated"}) continue;  // the frame before is
      EXPECT_TRUE(identical(drawn(jumps({{"scene_cut", cut}}), method, anchor), drawn(jumps({}), method, anchor)))
          << method.pipeline << " " << anchor << " " << cut;
    }
}

// The path of the frame before is no path over a cut.
TEST_F(RenderJumps, ACutBeforeTheExposureIsNoPathToExtrapolate) {
  Method extrapolated{"hybrid", {"preset=seed", "displacement=extrapolated"}};  // without rays at their own time
  EXPECT_TRUE(
      identical(drawn(jumps({{"scene_cut", -1.5}}), extrapolated, "close"), drawn(jumps({}), {"none", {}}, "close")));
}

TEST_F(RenderJumps, ACutOfOneThingStandsItStill) {
  for (const char* anchor : {"close", "centre", "open"}) {
    double cut = anchor == std::string("open") ? .4 : -.4;
    expectAlike(jumps({{"a_cut", cut}}), jumps({{"a_x", 0}}), anchor, "object");
    expectAlike(jumps({{"camera_cut", cut}}), jumps({{"camera_x", 0}}), anchor, "camera");
  }
}

// --- Shares

TEST_F(RenderJumps, SharesOfTheMotionAreLessMotion) {
  lab::Shot half_camera = jumps({}), no_objects = jumps({}), both = jumps({});
  half_camera.camera_blur = .5;
  no_objects.object_blur = 0;
  both.camera_blur = .25;
  both.object_blur = .5;
  for (const char* anchor : {"close", "centre"}) {
    expectAlike(half_camera, jumps({{"camera_x", 4}}), anchor, "half of the camera's");
    expectAlike(no_objects, jumps({{"a_x", 0}, {"b_y", 0}}), anchor, "none of the objects'");
    expectAlike(both, jumps({{"camera_x", 2}, {"a_x", 8}, {"b_y", 4}}), anchor, "both");
  }
}

// The camera goes along with `a`. Without its motion `a` is as sharp as with it, and what is at rest is too.
TEST_F(RenderJumps, WhatTheCameraFollowsStaysSharp) {
  const Numbers together = {{"a_x", 16}, {"camera_x", 16}};
  lab::Shot followed = jumps(together);
  followed.camera_blur = 0;
  followed.follow = "a";
  expectAlike(followed, jumps({{"a_x", 0}, {"camera_x", 0}}), "close", "followed");
  lab::Shot left = jumps(together);
  left.camera_blur = 0;
  EXPECT_GT(largestDifference(drawn(left, methods()[0], "close"), drawn(followed, methods()[0], "close")), .1);
  followed.follow = "nobody";
  EXPECT_THROW(render(with(followed, "none")), Error);
}

// Of `a` (at a depth of 100 m), `b` (105 m) and what is behind (120 m), at rest but for a camera that moves.
TEST_F(RenderJumps, BetweenDepthsOtherThingsStandStill) {
  const Numbers rests = {{"camera_x", 0}};
  lab::Shot all = jumps({}), near = jumps(rests), far = jumps(rests), soft = jumps(rests);
  all.motion_depths = "0,inf";
  near.motion_depths = "90,102";
  far.motion_depths = "105,105";
  soft.motion_depths = "100,104,2";
  expectAlike(all, jumps({}), "close", "all");
  for (const char* anchor : {"close", "centre"}) {
    expectAlike(near, jumps({{"camera_x", 0}, {"b_y", 0}}), anchor, "near");
    expectAlike(far, jumps({{"camera_x", 0}, {"a_x", 0}}), anchor, "far");
    expectAlike(soft, jumps({{"camera_x", 0}, {"b_y", 4}}), anchor, "a metre of two beyond the end");
  }
  lab::Shot none = jumps({});
  none.motion_depths = "1,2";
  for (const Method& method : methods())
    EXPECT_LE(largestDifference(drawn(none, method, "close"), drawn(jumps({}), {"none", {}}, "close")), 1e-5)
        << method.pipeline;
}

// --- Seconds

// Half a second in, a 48th of a second long: 20 px of the bar, at any number of frames per second, bit for bit.
TEST_F(RenderJumps, AnExposureInSecondsIsTheSameAtAnyRate) {
  for (const Method& method : methods()) {
    if (method.settings == std::vector<std::string>{"displacement=extrapolated"}) continue;  // by the frame before
    bool drawn_by_frame = method.settings.size() > 1 && method.settings[1] == "times=stratified";
    if (drawn_by_frame) continue;
    image::Image first;
    for (double fps : {12., 24., 60., 144.}) {
      lab::Shot shot = shotOf("bar", 128, 4, {{"left", 40 - 480}, {"right", 80 - 480}, {"d_f", 20}});
      shot.fps = fps;
      shot.frame = int(fps / 2);
      shot.exposure_time = 1. / 48;
      image::Image color = drawn(shot, method, "close");
      if (first.values.empty()) first = color;
      EXPECT_TRUE(identical(color, first)) << method.pipeline << " " << fps;
    }
    EXPECT_GT(first.at(70, 1, 0), .1) << method.pipeline;
    EXPECT_LT(first.at(70, 1, 0), .99) << method.pipeline;
  }
}

}  // namespace
}  // namespace strobe::oracle
