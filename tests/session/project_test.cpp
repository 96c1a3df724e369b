// SPDX-License-Identifier: MIT
// A project's pass runs while its files and the shipped files are edited.
#include "base/frozen_home.h"
#include "common/source.h"
#include "lab/capture.h"
#include "lab/reload_bench.h"
#include "session/home.h"

namespace strobe::session {
namespace project_test {

namespace fs = std::filesystem;
using lab::Session;

const char *const kShader = "shaders/smear.glsl", *const kPass = "passes/smear.lua";

// The files of `strobe new`, beside a copy of the shipped files.
class ProjectSession : public SessionTest {
 protected:
  ProjectSession() {
    for (const char* file : {kShader, kPass, "pipelines/smear.lua"})
      writeFileAtomically(project_ / file, readText(sourceFolder() / "project" / file));
  }
  ~ProjectSession() override {
    std::error_code ignored;
    fs::remove_all(project_, ignored);
  }

  static Home home() {
    const Home shipped = EditableHome::home();
    return Home({shipped.shipped().string() + "_project", shipped.shipped()}, shipped.data(), shipped.program());
  }

  // Edits a file of the project.
  void edit(const char* file, const std::string& from, const std::string& to) const {
    std::string text = readText(project_ / file);
    size_t at = text.find(from);
    ASSERT_NE(at, std::string::npos) << file << " does not contain: " << from;
    writeFileAtomically(project_ / file, text.replace(at, from.size(), to));
  }

  const Path project_ = home().project();
};

using Names = std::vector<std::string>;

TEST_F(ProjectSession, EditsOfBothRootsAreReloaded) {
  lab::Workbench own(home(), bench());
  Session session(own, smallShot("smear"));
  session.reload(true);
  std::string first = colorHash(session);

  edit(kShader, "vec4(mean, 1)", "vec4(0, 1, 0, 1)");
  auto told = session.reload(true);
  ASSERT_TRUE(told);
  EXPECT_EQ(told->changed, Names{kShader});
  EXPECT_TRUE(told->problems.empty()) << joined(told->problems);
  std::string green = colorHash(session);
  EXPECT_NE(green, first);
  edit(kShader, "vec4(0, 1, 0, 1)", "vec4(mean, 1)");
  session.reload(true);
  EXPECT_EQ(colorHash(session), first);

  edit(kPass, "{ 8, min", "{ 2, min");
  told = session.reload(true);
  ASSERT_TRUE(told);
  EXPECT_EQ(told->changed, Names{kPass});
  std::string two_taps = colorHash(session);
  EXPECT_NE(two_taps, first);

  home_.edit("shaders/gbuffer/shade.glsl", "quantisedColor(vec4(color, 1))", "quantisedColor(vec4(0.5 * color, 1))");
  told = session.reload(true);
  ASSERT_TRUE(told);
  EXPECT_EQ(told->changed, Names{"strobe:shaders/gbuffer/shade.glsl"});
  EXPECT_TRUE(told->problems.empty()) << joined(told->problems);
  EXPECT_NE(colorHash(session), two_taps);
}

TEST_F(ProjectSession, MistakesNameTheirRootAndKeepThePicture) {
  lab::Workbench own(home(), bench());
  Session session(own, smallShot("smear"));
  session.reload(true);
  std::string picture = colorHash(session);
  auto expect_problem = [&](const std::string& place) {
    ASSERT_TRUE(session.reload(true));
    ASSERT_EQ(session.problems().size(), 1u) << joined(session.problems());
    EXPECT_EQ(session.problems()[0].rfind(place, 0), 0u) << session.problems()[0];
    EXPECT_EQ(colorHash(session), picture);
  };
  edit(kShader, "vec3 mean = vec3(0);", "vec3 meal = vec3(0);");
  expect_problem("shaders/smear.glsl:16: ");
  edit(kShader, "vec3 meal = vec3(0);", "vec3 mean = vec3(0);");
  edit(kPass, "of = \"color\"", "of = \"colour\"");
  expect_problem("passes/smear.lua:8: ");
  edit(kPass, "of = \"colour\"", "of = \"color\"");
  home_.edit("shaders/gbuffer/shade.glsl", "vec3 color;", "vec3 colour;");
  expect_problem("strobe:shaders/gbuffer/shade.glsl:");
  home_.edit("shaders/gbuffer/shade.glsl", "vec3 colour;", "vec3 color;");
  home_.edit("passes/gbuffer/gbuffer.lua", "doc ", "doc_ ");
  expect_problem("strobe:passes/gbuffer/gbuffer.lua:");
  home_.edit("passes/gbuffer/gbuffer.lua", "doc_ ", "doc ");
  session.reload(true);
  EXPECT_TRUE(session.problems().empty()) << joined(session.problems());
  EXPECT_EQ(colorHash(session), picture);
}

// Pixels of a bar that moves by d show the share of the exposure while the bar covers them, for each anchor. A tap
// stands for 1/64 of the exposure, and is rounded by up to half a pixel.
TEST_F(ProjectSession, FollowsTheExposure) {
  constexpr double kLeft = 32, kRight = 96, kDisplacement = 20;
  constexpr int kTaps = 64;
  lab::Workbench own(home(), bench());
  for (const auto& [anchor, from] : {std::pair<std::string, double>{"end", -1}, {"centre", -0.5}, {"start", 0}}) {
    lab::Shot shot = smallShot("smear", 128, 8);
    shot.scene = "oracles/bar";
    shot.anchor = anchor;
    shot.sets = {{"taps", int64_t(kTaps)}};
    for (const auto& [name, value] : std::initializer_list<std::pair<const char*, double>>{
             {"width", 128}, {"height", 8}, {"left", kLeft}, {"right", kRight}, {"d_f", kDisplacement}})
      shot.sets.push_back({std::string("scene.") + name, fmt::format("{}", value)});
    image::Image color = lab::colorOf(own.render(shot));
    for (int x = int(kLeft); x < int(kRight); ++x) {
      // At time t the pixel at x shows the point x - d t of the raster time: the bar from t_right to t_left.
      double t_left = (x + .5 - kLeft) / kDisplacement, t_right = (x + .5 - kRight) / kDisplacement;
      double share = std::max(0., std::min(from + 1, t_left) - std::max(from, t_right));
      EXPECT_NEAR(color.at(x, 4, 0), share, 1. / kTaps + .5 / kDisplacement) << anchor << " " << x;
    }
  }
}

// Both roots are copied, and the copy is edited. A pipeline is also found in the copy by its file.
TEST_F(ProjectSession, ReloadsAreMeasuredOnACopy) {
  const std::string before = readText(project_ / kShader);
  FrozenHome copy(home(), project_ / "copy");
  lab::Workbench own(copy.home(), bench());
  lab::Shot shot = smallShot(copy.at(project_ / "pipelines/smear.lua"));
  std::vector<lab::ReloadTiming> timings = lab::benchReload(own, shot, 1);
  ASSERT_EQ(timings.size(), 4u);
  EXPECT_EQ(timings.front().edit, "shader of one pass");
  for (const lab::ReloadTiming& timing : timings) EXPECT_GT(timing.later_frame, 0) << timing.edit;
  EXPECT_EQ(readText(project_ / kShader), before);
}

}  // namespace project_test
}  // namespace strobe::session
