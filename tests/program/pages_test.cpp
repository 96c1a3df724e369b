// SPDX-License-Identifier: MIT
// docs/how-a-pass-travels.md and docs/describing-a-scene.md, followed: writes their files, runs their commands, makes
// their mistakes.
#include "common/pages.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <regex>
#include <set>

#include "base/error.h"
#include "common/home.h"
#include "common/source.h"
#include "lab/shot_options.h"
#include "program/run.h"
#include "scene/json_scene.h"
#include "scene/motion.h"
#include "script/evaluate.h"

namespace strobe::testing {
namespace pages_test {

// --- Page "How a pass travels"

// A copy of the shipped files with the files of the page.
class Travels : public ::testing::Test {
 protected:
  void SetUp() override {
    for (const char* part : {"passes", "shaders", "scripts"})
      fs::copy(sourceFolder() / part, home_.path() / part, fs::copy_options::recursive);
    for (const auto& [file, text] : page_.files) writeFileAtomically(home_.path() / file, text);
  }
  Outcome runHere(const std::string& command) const { return run(command, "STROBE_HOME=" + home_.path().string()); }

  const Page page_ = readPage("how-a-pass-travels.md");
  TemporaryFolder home_;
};

TEST_F(Travels, CommandsAreAccepted) {
  ASSERT_EQ(page_.files.size(), 3u);
  ASSERT_EQ(page_.commands.size(), 3u);
  for (std::string command : page_.commands) {
    if (command.starts_with("render ")) command = "plan" + command.substr(6, command.find(" -o ") - 6);
    Outcome outcome = runHere(command);
    EXPECT_EQ(outcome.exit_code, 0) << command << "\n" << outcome.err;
  }
}

TEST_F(Travels, MistakesHaveTheErrorsOfThePage) {
  ASSERT_GE(page_.mistakes.size(), 10u);
  for (const Page::Mistake& mistake : page_.mistakes) {
    bool in_file = !mistake.file.empty();
    if (in_file)
      writeFileAtomically(home_.path() / mistake.file,
                          withLine(page_.files.at(mistake.file), mistake.number, mistake.line));
    Outcome outcome = runHere(in_file ? "check soft" : mistake.command);
    EXPECT_NE(outcome.exit_code, 0) << mistake.error;
    EXPECT_EQ(outcome.err, "strobe: " + mistake.error + "\n");
    if (in_file) writeFileAtomically(home_.path() / mistake.file, page_.files.at(mistake.file));
  }
}

// --- Commands

// First groups of `pattern` in a help text: commands or options.
std::vector<std::string> wordsOf(const std::string& help, const std::string& pattern) {
  std::vector<std::string> words;
  std::regex word(pattern);
  for (std::sregex_iterator at(help.begin(), help.end(), word), end; at != end; ++at) words.push_back((*at)[1]);
  return words;
}

TEST(Commands, PageHasEveryCommandAndEveryOptionOfAShot) {
  std::string page = contentOf(sourceFolder() / "docs/commands.md");
  std::vector<std::string> commands = wordsOf(run("--help").out, R"(\n  ([a-z]+)  )");
  EXPECT_GE(commands.size(), 8u);
  for (const std::string& command : commands)
    EXPECT_TRUE(std::regex_search(page, std::regex("\n\\| `" + command + "[ `]"))) << command;
  std::vector<std::string> options = wordsOf(run("plan --help").out, R"(\n  (?:-[a-z],)?(--[a-z-]+))");
  EXPECT_GE(options.size(), 15u);
  for (const std::string& option : options)
    if (option != "--help" && option != "--help-all" && option != "--json")
      EXPECT_NE(page.find(option), std::string::npos) << option;
}

// --- Names in commands

// Commands of all pages that draw a shipped pipeline, as `plan` commands with their options --set and --tap. Pages that
// add files are left out.
std::set<std::string> plansOfPages() {
  std::set<std::string> plans;
  const std::regex command(R"(strobe (?:render|plan|live) ([a-z0-9_]+)([^`\n]*))");
  const std::regex option(R"( --(?:set (?!scene\.)[a-z_.]+=[^ ]*|tap [a-z_]+\.[a-z_]+)(?= |$))");
  for (const fs::directory_entry& page : fs::directory_iterator(sourceFolder() / "docs")) {
    if (page.path().extension() != ".md" || page.path().filename() == "your-own-edge-detector.md") continue;
    const std::string text = contentOf(page.path());
    for (std::sregex_iterator at(text.begin(), text.end(), command), end; at != end; ++at) {
      std::string pipeline = (*at)[1], rest = (*at)[2];
      if (!fs::exists(sourceFolder() / "scripts/pipelines" / (pipeline + ".lua"))) continue;
      std::string plan = "plan " + pipeline;
      for (std::sregex_iterator next(rest.begin(), rest.end(), option); next != end; ++next)
        if (!next->str().ends_with(".lua")) plan += next->str();
      plans.insert(plan);
    }
  }
  return plans;
}

TEST(Commands, NodesImagesAndParametersOfPagesExist) {
  const std::set<std::string> plans = plansOfPages();
  EXPECT_GE(plans.size(), 15u);
  for (const std::string& plan : plans) {
    Outcome outcome = run(plan);
    EXPECT_EQ(outcome.exit_code, 0) << plan << "\n" << outcome.err;
  }
}

// --- Page "Describing a scene"

class Scenes : public ::testing::Test {
 protected:
  void SetUp() override {
    for (const auto& [file, text] : page_.files) writeFileAtomically(folder_ / file, text);
    fs::copy(sourceFolder() / "docs/pictures" / kPhoto, folder_ / "scenes/photo.png");
  }
  scene::Scene load(const std::string& file, const script::Settings& sets = {}) const {
    std::string path = folder_ / file;
    return scene::sceneFromJson(script::evaluateScene(home(), path, sets), path, lab::suggestions());
  }
  // Error of loading a file, with paths relative to the page's folder.
  std::string failure(const std::string& file) const {
    try {
      load(file);
    } catch (const Error& error) {
      return std::regex_replace(std::string(error.what()), std::regex(folder_.path().string() + "/"), "");
    }
    return "";
  }
  // Names in "...; it has a, b, c": the fields of a table, reported for an unknown key.
  std::vector<std::string> fieldsOf(const std::string& table) {
    writeFileAtomically(folder_ / "scenes/fields.lua",
                        "local scene = require \"strobe.scene\"\nreturn " + table + "\n");
    std::string text = failure("scenes/fields.lua");
    std::smatch found;
    std::vector<std::string> names;
    if (!std::regex_search(text, found, std::regex("unknown key 'qqqqqqqq'; it has ([a-z_, ]+)"))) return names;
    std::string list = found[1];
    const std::regex name("[a-z_]+");
    for (std::sregex_iterator at(list.begin(), list.end(), name), end; at != end; ++at) names.push_back(at->str());
    return names;
  }

  static constexpr const char* kPhoto = "live-problem.png";  // any PNG
  const Page page_ = readPage("describing-a-scene.md");
  const std::string text_ = contentOf(sourceFolder() / "docs/describing-a-scene.md");
  TemporaryFolder folder_;
};

TEST_F(Scenes, ExamplesLoad) {
  ASSERT_EQ(page_.files.size(), 5u);
  for (const auto& [file, text] : page_.files) {
    if (!file.ends_with(".lua")) continue;
    scene::Scene scene = load(file);
    EXPECT_FALSE(scene::instancesOf(scene).empty()) << file;
    EXPECT_FALSE(scene.motions.empty()) << file;
    EXPECT_TRUE(scene.warnings.empty()) << file;
    EXPECT_EQ(scene.cameras.size(), 1u) << file;
  }
  size_t before = scene::instancesOf(load("scenes/carousel.lua")).size();
  EXPECT_EQ(scene::instancesOf(load("scenes/carousel.lua", {{"scene.count", int64_t(8)}})).size(), before + 3);
}

TEST_F(Scenes, CommandsDraw) {
  for (const char* name : {"ball", "parade"}) {
    auto found = std::find_if(page_.commands.begin(), page_.commands.end(), [&](const std::string& command) {
      return command.find(fmt::format("out/{}.png", name)) != std::string::npos;
    });
    ASSERT_NE(found, page_.commands.end()) << name;
    std::string command = std::regex_replace(*found, std::regex("scenes/|out/"), folder_ / "scenes/");
    Outcome outcome = run(command + " --size 64x36");
    EXPECT_EQ(outcome.exit_code, 0) << command << "\n" << outcome.err;
    EXPECT_TRUE(fs::exists(folder_.path() / fmt::format("scenes/{}.png", name)));
  }
}

// The page's flag rises by half a metre in a second, at half its size; nodes below a node are named after it.
TEST_F(Scenes, GltfFileIsAtEachNode) {
  scene::Scene scene = load("scenes/parade.lua");
  scene::Poser poser(scene, -1);
  auto place = [&](const char* name) {
    return dvec3(poser.nodesAt(1, 1).at(size_t(scene::nodeByName(scene, name)))[3]);
  };
  EXPECT_EQ(place("flag/cloth"), dvec3(2, 0.75, 0));
  EXPECT_EQ(place("last/cloth"), dvec3(1, 0.75, 0));
  EXPECT_EQ(scene.animations.at(1).name, "last/wave");
}

TEST_F(Scenes, MistakesHaveTheErrorsOfThePage) {
  ASSERT_EQ(page_.mistakes.size(), 3u);
  for (const Page::Mistake& mistake : page_.mistakes) {
    writeFileAtomically(folder_ / mistake.file, withLine(page_.files.at(mistake.file), mistake.number, mistake.line));
    EXPECT_EQ(failure(mistake.file), mistake.error);
    writeFileAtomically(folder_ / mistake.file, page_.files.at(mistake.file));
  }
}

// The row of the page's tables that begins with "| `name` |".
std::string rowOf(const std::string& page, const std::string& name) {
  size_t at = page.find("\n| `" + name + "` |");
  return at == std::string::npos ? "" : page.substr(at, page.find('\n', at + 1) - at);
}

// Every field accepted by the reader is on the page.
TEST_F(Scenes, PageHasEveryField) {
  const std::string q = "qqqqqqqq = 1";
  auto node = [](const std::string& inside) { return "scene { nodes = { scene.node { " + inside + " } } }"; };
  auto material = [&](const std::string& inside) {
    return node("shape = scene.box {}, material = scene.material { " + inside + " }");
  };
  auto animation = [](const std::string& inside) { return "scene { nodes = {}, animations = { " + inside + " } }"; };
  std::map<std::string, std::string> tables = {
      {"scene", "scene { nodes = {}, " + q + " }"},
      {"shot", "scene { nodes = {}, shot = { " + q + " } }"},
      {"environment", "scene { nodes = {}, environment = { " + q + " } }"},
      {"node", node(q)},
      {"part", node("parts = { { " + q + " } }")},
      {"motion", node("motion = { " + q + " }")},
      {"camera", node("camera = scene.camera { " + q + " }")},
      {"orthographic", node("camera = scene.orthographic_camera { " + q + " }")},
      {"spot", node("light = scene.spot_light { " + q + " }")},
      {"material", material(q)},
      {"use", material("color_texture = scene.use { " + q + " }")},
      {"pattern", material("color_texture = scene.texture.noise { " + q + " }")},
      {"image", material("color_texture = scene.texture.image { " + q + " }")},
      {"gltf", node("gltf = scene.gltf { " + q + " }")},
      {"texels", material("color_texture = scene.texture.texels { " + q + " }")},
      {"animation", animation("scene.animation { " + q + " }")},
      {"track", animation("scene.animation { tracks = { scene.track { " + q + " } } }")}};
  for (const auto& [what, table] : tables) {
    std::vector<std::string> names = fieldsOf(table);
    EXPECT_GE(names.size(), 2u) << what;
    for (const std::string& name : names)
      EXPECT_NE(text_.find("`" + name + "`"), std::string::npos) << what << " " << name;
  }
  for (const char* shape : {"quad", "box", "sphere", "torus", "superellipsoid", "cylinder", "lathe", "tube", "cushion",
                            "cloth", "triangles"}) {
    std::vector<std::string> names = fieldsOf(node(std::string("shape = scene.") + shape + " { " + q + " }"));
    EXPECT_GE(names.size(), 2u) << shape;
    std::string row = rowOf(text_, shape);
    for (const std::string& name : names)
      EXPECT_NE(row.find("`" + name + "`"), std::string::npos) << shape << " " << name;
  }
}

}  // namespace pages_test
}  // namespace strobe::testing
