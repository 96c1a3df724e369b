// SPDX-License-Identifier: MIT
// docs/your-own-edge-detector.md, followed: its files written beside a running shot, its commands given, its errors
// made.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <map>
#include <optional>
#include <set>
#include <sstream>

#include "base/hash.h"
#include "common/source.h"
#include "lab/session.h"
#include "program/run.h"

namespace strobe::lab {
namespace {

namespace fs = std::filesystem;
using strobe::testing::Outcome;
using strobe::testing::TemporaryFolder;

// --- The page

// A fenced block: "```lua passes/edge/x.lua" holds a file, "```lua passes/edge/x.lua:3" a line of it.
struct Block {
  std::string language, target, text;
};

std::vector<Block> blocksOf(const std::string& page) {
  std::vector<Block> blocks;
  std::istringstream lines(page);
  bool inside = false;
  for (std::string line; std::getline(lines, line);) {
    bool fence = line.starts_with("```");
    if (fence && !inside) {
      size_t space = std::min(line.find(' '), line.size());
      blocks.push_back({line.substr(3, space - 3), line.substr(std::min(space + 1, line.size())), ""});
    } else if (!fence && inside) {
      blocks.back().text += line + "\n";
    }
    inside = inside != fence;
  }
  return blocks;
}

struct Tutorial {
  std::map<std::string, std::string> files;
  struct Mistake {
    std::string file, line, error;
    int number = 0;
  };
  std::vector<Mistake> mistakes;
  std::vector<std::string> commands;  // without "./strobe "
};

Tutorial readTutorial() {
  Tutorial tutorial;
  for (const Block& block : blocksOf(readText(sourceFolder() / "docs/your-own-edge-detector.md"))) {
    size_t colon = block.target.find(':');
    bool of_file = block.language == "lua" || block.language == "glsl";
    if (of_file && colon == std::string::npos) tutorial.files[block.target] = block.text;
    if (of_file && colon != std::string::npos) {
      int number = std::stoi(block.target.substr(colon + 1));
      tutorial.mistakes.push_back({block.target.substr(0, colon), block.text, "", number});
    }
    if (block.target == "error" && !tutorial.mistakes.empty())
      tutorial.mistakes.back().error = block.text.substr(0, block.text.size() - 1);
    std::istringstream lines(block.language == "sh" ? block.text : "");
    for (std::string line; std::getline(lines, line);) tutorial.commands.push_back(line.substr(line.find(' ') + 1));
  }
  return tutorial;
}

std::string withLine(const std::string& text, int number, const std::string& line) {
  size_t start = 0;
  for (int i = 1; i < number; ++i) start = text.find('\n', start) + 1;
  return text.substr(0, start) + line + text.substr(text.find('\n', start) + 1);
}

// --- Following it

// A copy of what ships.
class Following : public ::testing::Test {
 protected:
  void SetUp() override {
    for (const char* part : {"passes", "shaders", "scripts"})
      fs::copy(sourceFolder() / part, folder_.path() / part, fs::copy_options::recursive);
  }

  void write(const std::string& file, const std::string& text) const {
    fs::create_directories((folder_.path() / file).parent_path());
    strobe::testing::writeText(folder_.path() / file, text);
  }

  Home home() const { return Home({folder_.path()}, {}, Home::fromEnvironment().program()); }

  const Tutorial tutorial_ = readTutorial();
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

// A box and a ball that move before a wall, over a floor.
Shot movingThings() {
  Shot shot;
  shot.pipeline = "hybrid";
  shot.scene = sourceFolder() / "tests/oracle/scenes/solids.lua";
  shot.width = 64, shot.height = 40, shot.frame = 0;
  shot.moves = {"box=0.6,0,0", "ball=-0.6,0.2,0"};
  shot.sets = {{"mask", "seed"}, {"scene.width", "64"}, {"scene.height", "40"}};
  return shot;
}

// [96, 160), moving by 20 px.
Shot movingBar() {
  Shot shot;
  shot.pipeline = "hybrid";
  shot.scene = "oracles/bar";
  shot.width = 256, shot.height = 16, shot.frame = 0;
  shot.sets = {{"mask", "seed"},       {"edge", "dilation"},   {"tile", "8"},      {"limit", "0.25"},
               {"scene.width", "256"}, {"scene.height", "16"}, {"scene.d_f", "20"}};
  return shot;
}

// Columns of the middle row that are marked.
std::vector<int> markedIn(const Picture& picture) {
  const image::Image& mask = picture.frame.outputs.at("mask").floats;
  std::vector<int> columns;
  for (int x = 0; x < mask.width; ++x)
    if (mask.at(x, mask.height / 2, 0) > .5f) columns.push_back(x);
  return columns;
}

TEST_F(Following, TheDetectorAppearsRunsAndIsTuned) {
  Workbench bench(home(), "", true);
  Session session(bench, movingThings());
  session.tap({"edge.edge"});
  std::string before = hashOf(session, "edge.edge"), colour = hashOf(session, "color");
  EXPECT_FALSE(isListed(session, "dilation"));

  write(kTable, tutorial_.files.at(kTable));
  EXPECT_TRUE(session.reload(true));
  EXPECT_EQ(session.problems(), std::vector<std::string>());
  EXPECT_TRUE(isListed(session, "dilation"));
  EXPECT_THROW(session.set("edge", "dilation", "test"), Error) << "its shader is missing";
  EXPECT_EQ(hashOf(session, "color"), colour);

  write(kShader, tutorial_.files.at(kShader));
  session.reload(true);
  session.set("edge", "dilation", "test");
  EXPECT_EQ(session.problems(), std::vector<std::string>());
  EXPECT_NE(hashOf(session, "edge.edge"), before);
  EXPECT_NE(hashOf(session, "color"), colour);

  std::optional<Control> threshold = controlOf(session, "edge.threshold");
  ASSERT_TRUE(threshold);
  EXPECT_EQ(threshold->declaration.doc, "how much farther, as a share of the depth");
  std::string narrow = hashOf(session, "edge.edge");
  session.set("edge.radius", "2", "test");
  EXPECT_NE(hashOf(session, "edge.edge"), narrow);
  session.set("edge.threshold", "16", "test");
  EXPECT_NE(hashOf(session, "color"), colour);
  EXPECT_EQ(bench.device().takeMessages(), std::vector<std::string>());
}

TEST_F(Following, MistakesSayWhatThePageSays) {
  for (const auto& [file, text] : tutorial_.files) write(file, text);
  Workbench bench(home(), "", true);
  Shot shot = movingThings();
  shot.sets.push_back({"edge", "dilation"});
  Session session(bench, shot);
  std::string colour = hashOf(session, "color");
  ASSERT_EQ(tutorial_.mistakes.size(), 2u);
  for (const Tutorial::Mistake& mistake : tutorial_.mistakes) {
    const std::string& sound = tutorial_.files.at(mistake.file);
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

// [R - d, R) and the pixel that the silhouette reaches at the very end of the exposure, as every detector's that marks
// the nearer side (tests/oracle/render_masks_test.cpp).
TEST_F(Following, ItsMaskIsTheBand) {
  for (const auto& [file, text] : tutorial_.files) write(file, text);
  Workbench bench(home(), "", true);
  std::vector<int> expected;
  for (int x = 139; x < 160; ++x) expected.push_back(x);
  EXPECT_EQ(markedIn(bench.render(movingBar())), expected);
  EXPECT_EQ(bench.device().takeMessages(), std::vector<std::string>());
}

// What `render` and `live` would draw can be planned; everything else but `compare`, which needs pictures, is run.
TEST_F(Following, ItsCommandsAreAccepted) {
  for (const auto& [file, text] : tutorial_.files) write(file, text);
  std::string home = "STROBE_HOME=" + folder_.path().string();
  std::set<std::string> seen;
  for (const std::string& command : tutorial_.commands) {
    std::string name = command.substr(0, command.find(' ')), rest = command.substr(name.size());
    seen.insert(name);
    if (name == "render" || name == "live") {
      Outcome outcome = strobe::testing::run("plan" + rest.substr(0, rest.find(" -o ")), home);
      EXPECT_EQ(outcome.exit_code, 0) << command << "\n" << outcome.err;
    } else if (name == "check" || name == "help") {
      Outcome outcome = strobe::testing::run(command, home);
      EXPECT_EQ(outcome.exit_code, 0) << command << "\n" << outcome.err;
    }
  }
  EXPECT_EQ(seen, (std::set<std::string>{"check", "compare", "help", "live", "render", "sweep"}));
  Outcome points = strobe::testing::run("sweep experiments/detectors.lua --dry-run --json", home);
  ASSERT_EQ(points.exit_code, 0) << points.err;
  Json listed = Json::parse(points.out);
  auto is_ours = [](const Json& point) { return point.at("arm") == "dilation"; };
  EXPECT_EQ(std::count_if(listed.begin(), listed.end(), is_ours), 1);
}

// A shader that is broken is found without a device.
TEST_F(Following, CheckFindsTheMistake) {
  for (const auto& [file, text] : tutorial_.files) write(file, text);
  const Tutorial::Mistake& mistake = tutorial_.mistakes.front();
  write(mistake.file, withLine(tutorial_.files.at(mistake.file), mistake.number, mistake.line));
  Outcome outcome = strobe::testing::run("check hybrid --set mask=seed --set edge=dilation",
                                         "STROBE_HOME=" + folder_.path().string());
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_EQ(outcome.err, "strobe: " + mistake.error + "\n");
}

}  // namespace
}  // namespace strobe::lab
