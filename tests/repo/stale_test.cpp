// SPDX-License-Identifier: MIT
// Published numbers and pictures match the scripts, shaders and scenes of this repository; `--stale` of tools/reproduce
// names exactly the results that depend on a changed file.
#include <filesystem>
#include <map>
#include <set>
#include <sstream>

#include "base/inputs.h"
#include "base/json.h"
#include "common/temporary_folder.h"
#include "repo/reproduce.h"

namespace strobe::repo {
namespace stale_test {

namespace fs = std::filesystem;

using Stale = ReproduceTest;

// Results that still have to be measured again.
std::set<std::string> knownStale() {
  std::istringstream lines(readText(sourceFolder() / "tools/reproduce/known_stale.txt"));
  std::set<std::string> names;
  for (std::string line; std::getline(lines, line);)
    if (!line.empty() && !line.starts_with("#")) names.insert(line);
  return names;
}

TEST_F(Stale, HasNoPublishedNumberOrPicture) {
  Outcome outcome = reproduce({"--stale", "--json"});
  ASSERT_TRUE(outcome.code == 0 || outcome.code == 1) << outcome.text;
  std::set<std::string> known = knownStale(), stale;
  for (const Json& one : Json::parse(outcome.text)) {
    const std::string name = one.at("name");
    stale.insert(name);
    EXPECT_TRUE(known.count(name) || one.at("pages").empty())
        << name << " is stale: " << one.at("reason") << " " << one.at("changed") << "; published by "
        << one.at("pages");
  }
  for (const std::string& name : known)
    EXPECT_TRUE(stale.count(name)) << name << " is not stale: remove it from tools/reproduce/known_stale.txt";
}

// A repository of three shaders, two results, a picture and two pages.
class StaleTree : public ReproduceTest {
 protected:
  void SetUp() override {
    ReproduceTest::SetUp();
    if (IsSkipped()) return;
    write("README.md", "It takes <!--= frame_time -->1.4 to 1.8<!--/--> times as long.\n");
    write("docs/page.md", "![A picture](pictures/a.png)\n");
    write("shaders/common.glsl", "const float kHalf = 0.5;  // of a pixel\n");
    write("shaders/a.glsl", "#include \"common.glsl\"\nfloat a() { return 1.0 * kHalf; }\n");
    write("shaders/b.glsl", "#include \"common.glsl\"\nfloat b() { return 2.0 * kHalf; }\n");
    write("scripts/s.lua", "-- A script.\nreturn { doc = \"first\", name = \"--8\" }  -- its end\n");
    writeResult("real_scenes", {"shaders/a.glsl", "shaders/common.glsl"});
    writeResult("peers", {"shaders/b.glsl", "shaders/common.glsl", "scripts/s.lua"});
    write("docs/pictures/a.png", "pixels");
    write("docs/pictures/inputs.json", Json{{"docs/pictures/a.png", inputsOf({"shaders/a.glsl"})}}.dump());
  }

  void write(const std::string& name, const std::string& text) {
    fs::create_directories(file(name).parent_path());
    writeFileAtomically(file(name), text);
  }
  void writeResult(const std::string& experiment, const std::vector<std::string>& inputs) {
    write("experiments/" + experiment + "/result.json", Json{{"inputs", inputsOf(inputs)}, {"groups", {}}}.dump());
  }
  Path file(const std::string& name) const { return folder_.path() / name; }
  Json inputsOf(const std::vector<std::string>& names) const {
    Json inputs = Json::object();
    for (const std::string& name : names) inputs["strobe:" + name] = inputHash(file(name));
    return inputs;
  }
  Outcome stale() const {
    return reproduce({"--stale", "--root", folder_.path().string()}, {"STROBE_DATA=" + file("data").string()});
  }

  testing::TemporaryFolder folder_;
};

TEST_F(StaleTree, UnchangedTreeIsNotStale) {
  EXPECT_EQ(stale().text, "no input of a result or a picture changed\n");
  EXPECT_EQ(stale().code, 0);
}

TEST_F(StaleTree, ChangedShaderNamesItsResults) {
  write("shaders/a.glsl", "#include \"common.glsl\"\nfloat a() { return 1.5 * kHalf; }\n");
  Outcome outcome = stale();
  EXPECT_EQ(outcome.code, 1);
  EXPECT_EQ(outcome.text,
            "docs/pictures/a.png [docs/page.md]: shaders/a.glsl\n"
            "experiments/real_scenes/result.json [README.md]: shaders/a.glsl\n");
  write("shaders/common.glsl", "const float kHalf = 0.25;\n");
  EXPECT_EQ(stale().text,
            "docs/pictures/a.png [docs/page.md]: shaders/a.glsl\n"
            "experiments/peers/result.json: shaders/common.glsl\n"
            "experiments/real_scenes/result.json [README.md]: shaders/a.glsl, shaders/common.glsl\n");
}

TEST_F(StaleTree, CommentsAndHelpTextsChangeNothing) {
  write("README.md", "<!-- A comment. -->\nIt takes <!--= frame_time -->1.4 to 1.8<!--/--> times as long.\n");
  write("docs/page.md", "<!-- Another comment. -->\n![A picture](pictures/a.png)\n");
  write("shaders/common.glsl", "/* Constants\n   of all. */\n\nconst float kHalf = 0.5;  // metres  \n");
  write("scripts/s.lua", "--[[ Two\nlines. ]]\nreturn { doc = \"edited\", name = \"--8\" }\n");
  EXPECT_EQ(stale().text, "no input of a result or a picture changed\n");
  write("scripts/s.lua", "return { doc = \"edited\", name = \"--9\" }\n");
  EXPECT_EQ(stale().text, "experiments/peers/result.json: scripts/s.lua\n") << "a string is not a comment";
}

TEST_F(StaleTree, RemovedFilesAndMissingRecordsAreNamed) {
  fs::remove(file("shaders/b.glsl"));
  write("docs/pictures/inputs.json", "{}");
  EXPECT_EQ(stale().text,
            "docs/pictures/a.png [docs/page.md]: inputs are not recorded\n"
            "experiments/peers/result.json: shaders/b.glsl\n");
}

TEST_F(StaleTree, PrefixesNameTheFolderOfAnInput) {
  write("experiments/peers/passes/p.lua", "return 1\n");
  Json inputs = {{"project:passes/p.lua", inputHash(file("experiments/peers/passes/p.lua"))},
                 {"shared:scenes/s.glb", "the hash of another scene"}};
  write("experiments/peers/result.json", Json{{"inputs", inputs}}.dump());
  EXPECT_EQ(stale().code, 0) << "without shared data, files of shared data are not compared";
  write("data/scenes/s.glb", "scene");
  write("experiments/peers/passes/p.lua", "return 2\n");
  EXPECT_EQ(stale().text, "experiments/peers/result.json: project:passes/p.lua, shared:scenes/s.glb\n");
}

// The program and the tool compute the same hash for every shipped file.
TEST_F(StaleTree, HashesMatchTheProgram) {
  Json inputs = Json::object();
  for (const char* part : {"passes", "shaders", "scripts", "experiments"})
    for (const auto& entry : fs::recursive_directory_iterator(sourceFolder() / part)) {
      const Path name = entry.path().lexically_relative(sourceFolder());
      if (!entry.is_regular_file() || name.string().ends_with("result.json")) continue;
      fs::create_directories((folder_.path() / "shipped" / name).parent_path());
      fs::copy_file(entry.path(), folder_.path() / "shipped" / name);
      inputs["strobe:shipped/" + name.string()] = inputHash(entry.path());
    }
  ASSERT_GT(inputs.size(), 300u);
  write("experiments/peers/result.json", Json{{"inputs", inputs}}.dump());
  EXPECT_EQ(stale().text, "no input of a result or a picture changed\n");
}

}  // namespace stale_test
}  // namespace strobe::repo
