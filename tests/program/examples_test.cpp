// SPDX-License-Identifier: MIT
// The examples of a new project: each renders, and its picture has the stated properties. The pages for authors show
// these files.
#include <gtest/gtest.h>

#include "base/json.h"
#include "common/pages.h"
#include "common/source.h"
#include "program/run.h"

namespace strobe::testing {
namespace examples_test {

const char* const kPages[] = {"writing-a-pass.md", "writing-a-shader.md", "writing-a-pipeline.md", "omission.md"};

class Examples : public ::testing::Test {
 protected:
  void SetUp() override {
    Outcome made = run("new '" + (folder_ / "mine") + "' --examples");
    ASSERT_EQ(made.exit_code, 0) << made.err;
    writeText(path("scenes/card.lua"), kCardScene);
  }

  fs::path path(const std::string& file) const { return folder_.path() / "mine" / file; }
  Outcome inside(const std::string& command) const {
    return run(command, "-C '" + path("").string() + "' STROBE_VALIDATION=1");
  }

  // Hash of the colour of a picture with a card that moves by 3.6 px. Messages of the validation layer fail the
  // command.
  // command.
  std::string colorOf(const std::string& pipeline_and_options) const {
    Outcome drawn = inside("render " + pipeline_and_options +
                           " --scene card --size 64x36 --exposure 1 --move card=0.36,0,0 -o out/a.exr");
    EXPECT_EQ(drawn.exit_code, 0) << pipeline_and_options << "\n" << drawn.err;
    if (drawn.exit_code != 0) return "";
    return Json::parse(contentOf(path("out/a.record.json"))).at("outputs").at("color").dump();
  }

  TemporaryFolder folder_;
};

TEST_F(Examples, AreSound) {
  Outcome sound = inside("check");
  EXPECT_EQ(sound.exit_code, 0) << sound.err;
  EXPECT_NE(sound.out.find("5 pipelines and 1 scene are sound"), std::string::npos) << sound.out;
}

TEST_F(Examples, DifferFromTheSharpPicture) {
  const std::string sharp = colorOf("none");
  for (const char* blur : {"smear", "hybrid --set edge=depth_step", "second_surface", "time_mean", "motion_tint",
                           "motion_tint --set tint=direction", "partial_blur"})
    EXPECT_NE(colorOf(blur), sharp) << blur;
}

TEST_F(Examples, EqualTheSharpPictureWithoutMotion) {
  const std::string still = " --scene card --size 64x36 --exposure 0 -o out/a.exr";
  auto color_of = [&](const std::string& pipeline) {
    Outcome drawn = inside("render " + pipeline + still);
    EXPECT_EQ(drawn.exit_code, 0) << pipeline << "\n" << drawn.err;
    return Json::parse(contentOf(path("out/a.record.json"))).at("outputs").at("color").dump();
  };
  const std::string sharp = color_of("none");
  for (const char* blur : {"smear", "time_mean", "motion_tint", "motion_tint --set tint=direction", "partial_blur"})
    EXPECT_EQ(color_of(blur), sharp) << blur;
}

TEST_F(Examples, ChoosesAMemberOfAFamily) {
  EXPECT_NE(colorOf("motion_tint --set tint=speed"), colorOf("motion_tint --set tint=direction"));
}

// The detector marks the silhouette of the card, so that rays reveal the wall in the background.
TEST_F(Examples, DetectorDecidesWhereRaysAreTraced) {
  EXPECT_NE(colorOf("hybrid --set edge=depth_step"),
            colorOf("hybrid --set edge=depth_step --set edge.depth_threshold=16"));
}

TEST_F(Examples, SecondSurfaceIsBlendedByItsShare) {
  EXPECT_EQ(colorOf("second_surface --set share=0"), colorOf("none"));
  EXPECT_NE(colorOf("second_surface --set share=1"), colorOf("second_surface"));
}

TEST_F(Examples, PartialBlurLiesBetweenItsEnds) {
  const std::string sharp = colorOf("none"), blurred = colorOf("mcguire2012 --set weights=mcguire2012");
  EXPECT_EQ(colorOf("partial_blur --set strength=0"), sharp);
  EXPECT_EQ(colorOf("partial_blur --set strength=1"), blurred);
  EXPECT_EQ(colorOf("partial_blur --set strength=1 --set masked=true"), blurred);
  const std::string half = colorOf("partial_blur");
  EXPECT_NE(half, sharp);
  EXPECT_NE(half, blurred);
}

// Omitting passes does not change a picture.
TEST_F(Examples, AreTheSameWithoutOmission) {
  for (const char* pipeline : {"motion_tint", "motion_tint --set tint=direction", "partial_blur --set masked=true"})
    EXPECT_EQ(colorOf(pipeline), colorOf(std::string(pipeline) + " --model-everything")) << pipeline;
}

TEST_F(Examples, MatchTheFilesOnThePages) {
  for (const char* name : kPages) {
    const Page page = readPage(name);
    EXPECT_GE(page.files.size(), 1u) << name;
    for (const auto& [file, text] : page.files) EXPECT_EQ(text, contentOf(path(file))) << name << " " << file;
  }
}

TEST_F(Examples, CommandsOfThePagesAreAccepted) {
  for (const char* name : kPages)
    for (std::string command : readPage(name).commands) {
      if (command.starts_with("new ")) continue;
      if (command.starts_with("render ")) command = "plan" + command.substr(6, command.find(" -o ") - 6);
      Outcome outcome = inside(command);
      EXPECT_EQ(outcome.exit_code, 0) << name << ": " << command << "\n" << outcome.err;
    }
}

}  // namespace examples_test
}  // namespace strobe::testing
