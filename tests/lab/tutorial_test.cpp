// SPDX-License-Identifier: MIT
// docs/your-own-edge-detector.md, followed in a project: writes its files beside a running shot, runs its commands,
// makes its mistakes.
#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <set>

#include "base/hash.h"
#include "common/pages.h"
#include "common/source.h"
#include "lab/session.h"
#include "program/run.h"

namespace strobe::lab {
namespace tutorial_test {

namespace fs = std::filesystem;
using strobe::testing::Outcome;
using strobe::testing::Page;
using strobe::testing::TemporaryFolder;
using strobe::testing::withLine;

// A project made by the page's first command, beside the shipped files.
class Following : public ::testing::Test {
 protected:
  void SetUp() override {
    ASSERT_EQ(page_.commands.at(0), "new detectors");
    Outcome made = strobe::testing::run(page_.commands.at(0), "-C " + folder_.path().string());
    ASSERT_EQ(made.exit_code, 0) << made.err;
  }

  fs::path project() const { return folder_.path() / "detectors"; }
  void write(const std::string& file, const std::string& text) const { writeFileAtomically(project() / file, text); }
  void writeAll() const {
    for (const auto& [file, text] : page_.files) write(file, text);
  }
  Outcome inside(const std::string& command) const {
    return strobe::testing::run(command, "-C " + project().string() + " STROBE_VALIDATION=1");
  }

  Home home() const {
    const Home own = Home::fromEnvironment();
    return Home({project(), own.shipped()}, own.data(), own.program());
  }

  const Page page_ = strobe::testing::readPage("your-own-edge-detector.md");
  TemporaryFolder folder_;
};

const char* const kTable = "passes/edge/dilation.lua";
const char* const kShader = "shaders/edge/dilation.glsl";

std::optional<Control> controlOf(const Session& session, const std::string& name) {
  for (const Control& control : session.controls())
    if (control.declaration.name == name) return control;
  return std::nullopt;
}

bool isListed(const Session& session, const std::string& choice) {
  std::vector<std::string> choices = controlOf(session, "edge").value().declaration.choices;
  return std::count(choices.begin(), choices.end(), choice) == 1;
}

std::string hashOf(Session& session, const std::string& image) {
  graph::FrameResult frame = session.draw();
  const auto& images = frame.taps.count(image) ? frame.taps : frame.outputs;
  const std::vector<float>& values = images.at(image).floats.values;
  return hashBytes(values.data(), values.size() * sizeof(float));
}

// A moving box and ball in front of a wall, above a floor.
Shot movingThings() {
  Shot shot;
  shot.pipeline = "hybrid";
  shot.scene = sourceFolder() / "tests/oracle/scenes/solids.lua";
  shot.width = 64, shot.height = 40, shot.frame = 0;
  shot.moves = {"box=0.6,0,0", "ball=-0.6,0.2,0"};
  shot.sets = {{"scene.width", "64"}, {"scene.height", "40"}};
  return shot;
}

// A bar at [96, 160) that moves by 20 px.
Shot movingBar() {
  Shot shot;
  shot.pipeline = "hybrid";
  shot.scene = "oracles/bar";
  shot.width = 256, shot.height = 16, shot.frame = 0;
  shot.sets = {{"edge", "dilation"},   {"tile", "8"},          {"limit", "0.25"},
               {"scene.width", "256"}, {"scene.height", "16"}, {"scene.d_f", "20"}};
  return shot;
}

// Marked columns of the middle row.
std::vector<int> markedIn(const Picture& picture) {
  const image::Image& mask = picture.frame.outputs.at("mask").floats;
  std::vector<int> columns;
  for (int x = 0; x < mask.width; ++x)
    if (mask.at(x, mask.height / 2, 0) > .5f) columns.push_back(x);
  return columns;
}

TEST_F(Following, DetectorAppearsRunsAndIsTuned) {
  Workbench bench(home(), "", true);
  Session session(bench, movingThings());
  session.tap({"edge.edge"});
  std::string before = hashOf(session, "edge.edge"), colour = hashOf(session, "color");
  EXPECT_FALSE(isListed(session, "dilation"));

  write(kTable, page_.files.at(kTable));
  EXPECT_TRUE(session.reload(true));
  EXPECT_EQ(session.problems(), std::vector<std::string>());
  EXPECT_TRUE(isListed(session, "dilation"));
  EXPECT_THROW(session.set("edge", "dilation", "test"), Error) << "its shader is missing";
  EXPECT_EQ(hashOf(session, "color"), colour);

  write(kShader, page_.files.at(kShader));
  session.reload(true);
  session.set("edge", "dilation", "test");
  EXPECT_EQ(session.problems(), std::vector<std::string>());
  EXPECT_NE(hashOf(session, "edge.edge"), before);
  EXPECT_NE(hashOf(session, "color"), colour);

  std::optional<Control> threshold = controlOf(session, "edge.threshold");
  ASSERT_TRUE(threshold);
  EXPECT_EQ(threshold->declaration.doc, "depth step of an edge, as a share of the depth");
  std::string narrow = hashOf(session, "edge.edge");
  session.set("edge.radius", "2", "test");
  EXPECT_NE(hashOf(session, "edge.edge"), narrow);
  session.set("edge.threshold", "16", "test");
  EXPECT_NE(hashOf(session, "color"), colour);
  EXPECT_EQ(bench.device().takeMessages(), std::vector<std::string>());
}

TEST_F(Following, MistakesHaveTheErrorsOfThePage) {
  writeAll();
  Workbench bench(home(), "", true);
  Shot shot = movingThings();
  shot.sets.push_back({"edge", "dilation"});
  Session session(bench, shot);
  std::string colour = hashOf(session, "color");
  ASSERT_EQ(page_.mistakes.size(), 2u);
  for (const Page::Mistake& mistake : page_.mistakes) {
    const std::string& sound = page_.files.at(mistake.file);
    write(mistake.file, withLine(sound, mistake.number, mistake.line));
    ASSERT_TRUE(session.reload(true));
    EXPECT_EQ(session.problems(), std::vector<std::string>{mistake.error});
    EXPECT_EQ(hashOf(session, "color"), colour);
    write(mistake.file, sound);
    ASSERT_TRUE(session.reload(true));
    EXPECT_EQ(session.problems(), std::vector<std::string>());
    EXPECT_EQ(hashOf(session, "color"), colour);
  }
  EXPECT_EQ(bench.device().takeMessages(), std::vector<std::string>());
}

// [R - d, R) and the pixel that the silhouette reaches at the end of the exposure, as for every detector that marks the
// nearer side (tests/oracle/render_masks_test.cpp).
TEST_F(Following, MaskIsTheBand) {
  writeAll();
  Workbench bench(home(), "", true);
  std::vector<int> expected;
  for (int x = 139; x < 160; ++x) expected.push_back(x);
  EXPECT_EQ(markedIn(bench.render(movingBar())), expected);
  EXPECT_EQ(bench.device().takeMessages(), std::vector<std::string>());
}

// Commands of `render` and `live` are planned; all other commands run, except `compare`, which needs pictures, and
// `new` and `sweep`.
TEST_F(Following, CommandsAreAccepted) {
  writeAll();
  std::set<std::string> seen;
  for (const std::string& command : page_.commands) {
    std::string name = command.substr(0, command.find(' ')), rest = command.substr(name.size());
    seen.insert(name);
    bool planned = name == "render" || name == "live", run = name == "check" || name == "help";
    if (!planned && !run) continue;
    Outcome outcome = inside(planned ? "plan" + rest.substr(0, rest.find(" -o ")) : command);
    EXPECT_EQ(outcome.exit_code, 0) << command << "\n" << outcome.err;
  }
  EXPECT_EQ(seen, (std::set<std::string>{"check", "compare", "help", "live", "new", "render", "sweep"}));
  Outcome points = inside("sweep experiments/detectors.lua --dry-run --json");
  ASSERT_EQ(points.exit_code, 0) << points.err;
  Json listed = Json::parse(points.out);
  auto is_ours = [](const Json& point) { return point.at("arm") == "dilation"; };
  EXPECT_EQ(std::count_if(listed.begin(), listed.end(), is_ours), 1);
}

}  // namespace tutorial_test
}  // namespace strobe::lab
