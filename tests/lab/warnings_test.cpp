// SPDX-License-Identifier: MIT
// Warnings about clips appear exactly in the frames with the described problem.
#include "lab/warnings.h"

#include <gtest/gtest.h>

#include <cmath>

#include "math/constants.h"
#include "scene/clips.h"

namespace strobe::lab {
namespace warnings_test {

using scene::Track;
using Target = Track::Target;
using How = Track::Interpolation;

// A node "box" with a weight, a camera and a light.
scene::Scene sceneOf(std::vector<scene::Animation> clips) {
  scene::Scene scene;
  scene.nodes.resize(2);
  scene.nodes[0].name = "box";
  scene.nodes[0].weights = {0};
  scene.nodes[1].name = "eye";
  scene.nodes[1].camera = 0;
  scene.cameras.resize(1);
  scene.cameras[0].name = "main";
  scene.animations = std::move(clips);
  scene::yieldClips(scene);
  return scene;
}

Track track(Target target, std::vector<double> times, std::vector<dvec4> values, How how = How::Linear, int node = 0) {
  return {node, target, how, std::move(times), std::move(values)};
}

scene::Animation clipOf(const std::string& name, double duration, std::vector<Track> tracks) {
  scene::Animation clip;
  clip.name = name;
  clip.duration = duration;
  clip.tracks = std::move(tracks);
  return clip;
}

// A clip that moves x from 0 to 1.
scene::Animation slide(const std::string& name, double from_s, double to_s, How how = How::Linear, int node = 0) {
  return clipOf(name, to_s, {track(Target::Translation, {from_s, to_s}, {dvec4(0), {1, 0, 0, 0}}, how, node)});
}

// The kinds of a frame's warnings, found by words unique to each kind.
std::string kindsOf(const scene::Scene& scene, int frame, double exposure = 1, const std::string& anchor = "centre",
                    double fps = 24, const std::string& animation = "all") {
  Shot shot;
  shot.fps = fps;
  shot.frame = frame;
  shot.exposure = exposure;
  shot.anchor = anchor;
  shot.animation = animation;
  std::string kinds;
  for (const LimitMet& met : limitsMet(shot, scene)) {
    const std::string warning = met.text();
    kinds += warning.find("begins before") != std::string::npos       ? "before "
             : warning.find("spans the end") != std::string::npos     ? "seam "
             : warning.find("drive translation") != std::string::npos ? "shared "
                                                                      : warning;
  }
  return kinds;
}

// Keys on frames, as floats: an exposure that ends on the last key or begins on the first key stays in the clip.
TEST(ClipWarnings, ExposuresThatEndOnKeysStayInTheClip) {
  for (int fps : {24, 25, 30, 60})
    for (int frame = 1; frame <= 200; ++frame)
      for (bool by_product : {false, true}) {
        auto at = [&](int key) {
          return double(by_product ? float(key) * (1.f / float(fps)) : float(double(key) / fps));
        };
        const scene::Scene ends = sceneOf({slide("a", 0, at(frame))});
        const scene::Scene begins = sceneOf({slide("a", at(frame), at(frame + 20))});
        EXPECT_EQ(kindsOf(ends, frame, 1, "end", fps), "") << frame << " " << fps;
        EXPECT_EQ(kindsOf(ends, frame, 0.5, "centre", fps), "seam ") << frame << " " << fps;
        EXPECT_EQ(kindsOf(begins, frame + 1, 1, "end", fps), "") << frame << " " << fps;
        EXPECT_EQ(kindsOf(begins, frame, 0.5, "centre", fps), "before ") << frame << " " << fps;
        EXPECT_EQ(kindsOf(begins, frame, 1, "end", fps), "") << frame << " " << fps;
      }
}

TEST(ClipWarnings, EveryKindOfTrackIsChecked) {
  for (Target target : {Target::Translation, Target::Weight, Target::FieldOfView}) {
    const scene::Animation clip = clipOf("a", 1, {track(target, {0.5, 1}, {dvec4(0.1), dvec4(1)})});
    EXPECT_EQ(kindsOf(sceneOf({clip}), 24), "seam ") << int(target);
    EXPECT_EQ(kindsOf(sceneOf({clip}), 12), "before ") << int(target);
    EXPECT_EQ(kindsOf(sceneOf({clip}), 18), "") << int(target);
  }
}

TEST(ClipWarnings, StepsAndCutsDoNotBlur) {
  EXPECT_EQ(kindsOf(sceneOf({slide("a", 0.5, 1, How::Step)}), 24), "");
  EXPECT_EQ(kindsOf(sceneOf({slide("a", 0.5, 1, How::Step)}), 12), "");
  scene::Animation cut = slide("a", 0, 1);
  cut.cuts = {0};
  EXPECT_EQ(kindsOf(sceneOf({cut}), 24), "");
  scene::Scene all = sceneOf({slide("a", 0, 1)});
  all.cuts = {1};
  EXPECT_EQ(kindsOf(all, 24), "");
  all.cuts = {0.5};
  EXPECT_EQ(kindsOf(all, 24), "seam ");
}

// A frame interval at 24 fps is 41.7 ms.
TEST(ClipWarnings, ExposureLongerThanTheLoopSpansItsEnd) {
  for (const char* anchor : {"start", "centre", "end"}) {
    EXPECT_EQ(kindsOf(sceneOf({slide("a", 0, 0.03)}), 48, 1, anchor), "seam ") << anchor;
    EXPECT_EQ(kindsOf(sceneOf({slide("a", 0, 0.041666)}), 24, 1, anchor), "seam ") << anchor;
    EXPECT_EQ(kindsOf(sceneOf({slide("a", 0, 20)}), 24, 1, anchor), "") << anchor;
  }
}

// Rotation about y by quarters; the quaternion of a full turn is the negated identity.
TEST(ClipWarnings, FullTurnDoesNotJump) {
  auto turnTo = [](double degrees, double sign_of_last) {
    std::vector<double> times;
    std::vector<dvec4> values;
    for (int k = 0; k <= 4; ++k) {
      const double half = degrees / 8 * k * kPi / 180;
      times.push_back(k / 4.);
      values.push_back({0, float(std::sin(half)), 0, float(std::cos(half))});
    }
    values.back() *= sign_of_last;
    return sceneOf({clipOf("turn", 1, {track(Target::Rotation, times, values)})});
  };
  for (double sign : {1., -1.}) {
    EXPECT_EQ(kindsOf(turnTo(360, sign), 24), "") << sign;
    EXPECT_EQ(kindsOf(turnTo(720, sign), 24), "") << sign;
    EXPECT_EQ(kindsOf(turnTo(90, sign), 24), "seam ") << sign;
    EXPECT_EQ(kindsOf(turnTo(359, sign), 24), "seam ") << sign;
  }
}

TEST(ClipWarnings, LoopClosedWithinRoundingDoesNotJump) {
  auto closing = [](double end) {
    return sceneOf(
        {clipOf("a", 1, {track(Target::Translation, {0, 0.5, 1}, {dvec4(0), {0, 3, 0, 0}, {0, end, 0, 0}})})});
  };
  EXPECT_EQ(kindsOf(closing(3e-7), 24), "");
  EXPECT_EQ(kindsOf(closing(3e-4), 24), "seam ");
}

TEST(ClipWarnings, ClipsOfOneTargetAreNamedUnlessOneIsChosen) {
  const scene::Scene scene = sceneOf({slide("walk", 0, 1), slide("nod", 0, 1, How::Linear, 1), slide("run", 0, 2)});
  Shot shot;
  shot.fps = 24;
  shot.frame = 12;
  shot.exposure = 0;
  const std::vector<LimitMet> all = limitsMet(shot, scene);
  ASSERT_EQ(all.size(), 1u);
  EXPECT_EQ(all[0].text(),
            "clips 'walk', 'run' drive translation of node 'box'; the first clip in the file plays; --animation NAME "
            "chooses another");
  for (const char* name : {"walk", "run", "nod", "none"}) {
    shot.animation = name;
    EXPECT_TRUE(limitsMet(shot, scene).empty()) << name;
  }
}

// A clip that does not play has no warning about its seam.
TEST(ClipWarnings, ClipsThatDoNotPlayHaveNoSeam) {
  const scene::Scene scene = sceneOf({slide("walk", 0, 20), slide("run", 0, 1)});
  EXPECT_EQ(kindsOf(scene, 24), "shared ");
  EXPECT_EQ(kindsOf(scene, 24, 1, "centre", 24, "run"), "seam ");
}

}  // namespace warnings_test
}  // namespace strobe::lab
