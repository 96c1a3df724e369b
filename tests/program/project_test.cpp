// SPDX-License-Identifier: MIT
// A project outside the clone, created and used as by a researcher: new detector, pipeline, scene, reload.
#include <gtest/gtest.h>
#include <unistd.h>

#include <map>
#include <regex>

#include "base/json.h"
#include "common/source.h"
#include "program/run.h"

namespace strobe::testing {
namespace project_test {

class Project : public ::testing::Test {
 protected:
  // No command of a project changes shipped files.
  static void SetUpTestSuite() { shipped_ = timesOfShipped(); }
  static void TearDownTestSuite() { EXPECT_EQ(timesOfShipped(), shipped_); }
  static std::map<fs::path, fs::file_time_type> timesOfShipped() {
    std::map<fs::path, fs::file_time_type> times;
    for (const char* part : {"passes", "shaders", "scripts", "experiments", "project"})
      for (const auto& entry : fs::recursive_directory_iterator(sourceFolder() / part))
        times[entry.path()] = entry.last_write_time();
    return times;
  }
  static inline std::map<fs::path, fs::file_time_type> shipped_;

  void SetUp() override {
    Outcome made = run("new '" + (folder_ / "mine") + "'");
    ASSERT_EQ(made.exit_code, 0) << made.err;
  }

  fs::path path(const std::string& file) const { return folder_.path() / "mine" / file; }

  void write(const std::string& file, const std::string& text) const {
    fs::create_directories(path(file).parent_path());
    writeText(path(file), text);
  }

  // Runs a command in a folder of the project.
  Outcome inside(const std::string& arguments, const std::string& below = "") const {
    TemporaryFolder out;
    std::string command = "cd '" + path(below).string() + "' && env STROBE_VALIDATION=1 '" + programPath() + "' " +
                          arguments + " >" + (out / "out") + " 2>" + (out / "err") + " </dev/null";
    int status = std::system(command.c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status), contentOf(out / "out"),
            contentOf(out / "err")};
  }

  void expectRefused(const std::string& arguments, const std::string& says) const {
    Outcome outcome = inside(arguments);
    EXPECT_EQ(outcome.exit_code, 1) << outcome.out;
    EXPECT_NE(outcome.err.find(says), std::string::npos) << outcome.err;
  }

  // Copies a shipped pass to the project as `mine`; its file names it.
  void addMember(const std::string& family, const std::string& shipped) const {
    write("passes/" + family + "/mine.lua", contentOf(sourceFolder() / "passes" / family / (shipped + ".lua")));
    write("shaders/" + family + "/mine.glsl", contentOf(sourceFolder() / "shaders" / family / (shipped + ".glsl")));
  }

  void addScene() const { write("scenes/near.lua", contentOf(sourceFolder() / "scripts/scenes/oracles/bar.lua")); }

  TemporaryFolder folder_;
};

const std::string kSmall = " --scene oracles/bar --size 32x18 -o out/a.exr";

TEST_F(Project, Runs) {
  Outcome drawn = inside("render smear" + kSmall, "pipelines");  // run in a folder of the project
  EXPECT_EQ(drawn.exit_code, 0) << drawn.err;
  EXPECT_EQ(inside("check smear").exit_code, 0);
  EXPECT_NE(inside("help").out.find("smear"), std::string::npos);
  EXPECT_NE(inside("help smear.taps").out.find("averaged colours"), std::string::npos);
  std::string record = contentOf(path("pipelines/out/a.record.json"));
  for (const char* file : {"project:pipelines/smear.lua", "project:passes/smear.lua", "project:shaders/smear.glsl",
                           "strobe:passes/gbuffer/gbuffer.lua", "strobe:shaders/lib/hit.glsl"})
    EXPECT_NE(record.find("\"" + std::string(file) + "\""), std::string::npos) << file;
  EXPECT_EQ(inside("render none" + kSmall).exit_code, 0);
  EXPECT_NE(run("plan smear").err.find("unknown pipeline 'smear'"), std::string::npos);  // run outside the project
}

// A project's gather is a choice in shipped pipelines and in the project's pipelines.
TEST_F(Project, HasItsOwnPipelines) {
  addMember("gather", "uniform");
  std::string pipeline = contentOf(sourceFolder() / "scripts/pipelines/mcguire2012.lua");
  write("pipelines/mine.lua", std::regex_replace(pipeline, std::regex("\"uniform\" \\}"), "\"mine\" }"));
  for (const char* pipeline : {"mine", "hybrid", "pipelines/mine.lua"})
    EXPECT_EQ(inside(std::string("check ") + pipeline + " --set weights=mine").exit_code, 0) << pipeline;
  Outcome drawn = inside("render mine --set weights=mine" + kSmall);
  EXPECT_EQ(drawn.exit_code, 0) << drawn.err;
}

TEST_F(Project, HasItsOwnExperiments) {
  addScene();
  write("experiments/taps.lua", R"lua(
local experiment = require "strobe.experiment"
return experiment {
  title = "Taps", size = { 32, 18 }, measures = { "rmse" },
  arms = { { name = "smear", pipeline = "smear" } },
  truth = { pipeline = "ground_truth", set = { samples = 4 } },
  shots = { { name = "near", scene = "near" } },
  vary = { experiment.grid { taps = { 2, 8 } } },
}
)lua");
  Outcome swept = inside("sweep experiments/taps.lua -o out/taps");
  ASSERT_EQ(swept.exit_code, 0) << swept.err;
  std::string result = contentOf(path("out/taps/result.json"));
  for (const char* file : {"\"project:experiments/taps.lua\"", "\"strobe:scripts/strobe/experiment.lua\""})
    EXPECT_NE(result.find(file), std::string::npos) << file;
  Outcome told = inside("report out/taps --experiment experiments/taps.lua");
  EXPECT_EQ(told.exit_code, 0) << told.err;
}

// The smallest suite: one case of one invariant.
TEST_F(Project, IsTestedByTheStabilitySuite) {
  Outcome tried = inside("stability smear --cases 1 --invariant still --variant defaults --json");
  EXPECT_NE(tried.out.find("\"smear\""), std::string::npos) << tried.err;
  EXPECT_EQ(tried.exit_code, 0) << tried.out;
  EXPECT_EQ(inside("stability smer").exit_code, 2);
  // The sharp picture has more digits than 16-bit floats hold.
  std::string pass = contentOf(path("passes/smear.lua"));
  write("passes/smear.lua", std::regex_replace(pass, std::regex("rgba32f"), "rgba16f"));
  tried = inside("stability smear --cases 1 --invariant still --variant defaults");
  EXPECT_EQ(tried.exit_code, 1) << tried.out;
  EXPECT_NE(tried.out.find("\n  failed by invariant: still 1 of 1\n  16-bit floats round by up to 1/2048"),
            std::string::npos)
      << tried.out;
  EXPECT_NE(tried.out.find(": smear.color, rgba16f; "), std::string::npos) << tried.out;
}

TEST_F(Project, ShippedNameIsRefusedUnlessItReplaces) {
  std::string text = contentOf(sourceFolder() / "scripts/pipelines/none.lua");
  write("pipelines/none.lua", text);
  expectRefused("plan none", "pipelines/none.lua: has the name of a shipped file, strobe:scripts/pipelines/none.lua");
  expectRefused("check", "pipelines/none.lua: has the name of a shipped file");
  write("pipelines/none.lua", "-- replaces = true\n" + text);
  Outcome planned = inside("plan none");
  EXPECT_EQ(planned.exit_code, 0) << planned.err;
  write("passes/unused.lua", "\n-- replaces = true\nreturn {}\n");
  for (const char* command : {"check", "plan none"})
    expectRefused(command,
                  "passes/unused.lua:2: 'replaces = true', but strobe:passes/unused.lua is not a shipped file");
}

// The file is refused even if the command does not read it.
TEST_F(Project, ShippedNameIsRefusedForEveryCommand) {
  for (const std::string& command :
       {std::string("plan smear"), "render smear" + kSmall, std::string("stability smear --invariant still")}) {
    write("passes/edge/sobel.lua", "return {}\n");
    expectRefused(command, "passes/edge/sobel.lua: has the name of a shipped file, strobe:passes/edge/sobel.lua");
    fs::remove(path("passes/edge/sobel.lua"));
    write("shaders/edge/sobel.glsl", "\n");
    expectRefused(command, "shaders/edge/sobel.glsl: has the name of a shipped file, strobe:shaders/edge/sobel.glsl");
    EXPECT_EQ(inside("help smear").exit_code, 0);
    fs::remove(path("shaders/edge/sobel.glsl"));
  }
  EXPECT_EQ(inside("plan smear").exit_code, 0);
}

// A missing file is searched in both roots, and the message names both.
TEST_F(Project, NamesTheSearchedFolders) {
  const std::string own = fs::canonical(path("")).string(), shipped = sourceFolder().string();
  fs::rename(path("shaders/smear.glsl"), path("shaders/smaer.glsl"));
  expectRefused("check smear",
                fmt::format("passes/smear.lua:5: pass 'smear': shader smear.glsl is missing in {}/shaders or "
                            "{}/shaders; did you mean 'smaer'?",
                            own, shipped));
  fs::rename(path("shaders/smaer.glsl"), path("shaders/smear.glsl"));
  const std::string shader = contentOf(path("shaders/smear.glsl"));
  write("shaders/smear.glsl", std::regex_replace(shader, std::regex("lib/times"), "lib/tims"));
  expectRefused(
      "check smear",
      fmt::format("shaders/smear.glsl:7: '#include': 'lib/tims.glsl' not found beside the file or in {}/shaders or "
                  "{}/shaders; did you mean 'lib/times.glsl'?",
                  own, shipped));
  write("shaders/smear.glsl", std::regex_replace(shader, std::regex("void run\\(ivec2 pixel\\)"), "void main()"));
  expectRefused("check smear",
                "strobe: shaders/smear.glsl:9: 'main': the shader of a pass defines 'void run(ivec2 pixel)' instead");
  EXPECT_NE(inside("plan chroma")
                .err.find(fmt::format("unknown pipeline 'chroma'; not found in {}/pipelines or {}/scripts/pipelines\n",
                                      own, shipped)),
            std::string::npos);
  Outcome outside = run("plan chroma");
  EXPECT_EQ(outside.exit_code, 2);
  EXPECT_NE(outside.err.find(fmt::format(
                "unknown pipeline 'chroma'; not found in {}/scripts/pipelines; the current folder is not in a "
                "project (strobe.project.lua)",
                shipped)),
            std::string::npos)
      << outside.err;
  write("a.obj", "v 0 0 0\n");
  EXPECT_NE(inside("plan smear --scene a.obj")
                .err.find("'a.obj' is not a scene: a scene is a name, or a file that ends in .lua, .glb or .gltf"),
            std::string::npos);
}

// A glTF triangle beside the capture, with its buffer in another file; a project shader edited for one arm.
TEST_F(Project, HasItsOwnCaptures) {
  write("captures/models/one.gltf", R"json({ "asset": { "version": "2.0" },
    "scenes": [{ "nodes": [0] }], "nodes": [{ "name": "one", "mesh": 0 }],
    "meshes": [{ "primitives": [{ "attributes": { "POSITION": 0 } }] }],
    "accessors": [{ "bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3", "min": [0, 0, 0], "max": [1, 1, 0] }],
    "bufferViews": [{ "buffer": 0, "byteLength": 36 }], "buffers": [{ "uri": "one.bin", "byteLength": 36 }] })json");
  const float corners[9] = {0, 0, 0, 1, 0, 0, 0, 1, 0};
  writeText(path("captures/models/one.bin"), std::string(reinterpret_cast<const char*>(corners), sizeof corners));
  write("captures/look.lua", R"lua(
local capture = require "strobe.capture"
return capture {
  title = "Look", size = { 32, 18 },
  shots = { { name = "one", scene = "models/one.gltf", view = { 0, 0, 3, 0, 0, 0 }, move = { one = { 0.2, 0, 0 } } } },
  arms = { { name = "now", pipeline = "smear" }, { name = "before", pipeline = "smear", files = "before" } },
}
)lua");
  const std::string shader = contentOf(path("shaders/smear.glsl"));
  expectRefused("capture captures/look.lua -o out/look", "'before' is not a folder beside the script");
  fs::create_directories(path("captures/before/project/shaders"));
  size_t at = shader.find("imageStore("), end = shader.find(");\n", at);
  ASSERT_NE(end, std::string::npos);
  write("captures/before/project/shaders/smear.glsl", shader.substr(0, end) + " * 0.5" + shader.substr(end));
  Outcome taken = inside("capture captures/look.lua -o out/look");
  ASSERT_EQ(taken.exit_code, 0) << taken.err;
  std::string manifest = contentOf(path("out/look/manifest.json"));
  for (const char* input : {"\"project:captures/look.lua\"", "\"project:captures/models/one.bin\"",
                            "\"project:captures/before/project/shaders/smear.glsl\"", "\"project:shaders/smear.glsl\""})
    EXPECT_NE(manifest.find(input), std::string::npos) << input;
  Json pictures = Json::parse(manifest)["pictures"];
  ASSERT_EQ(pictures.size(), 2u);
  EXPECT_NE(pictures[0]["record"]["outputs"]["color"], pictures[1]["record"]["outputs"]["color"]);
  Outcome verified = inside("verify out/look");
  EXPECT_EQ(verified.exit_code, 0) << verified.out << verified.err;
  EXPECT_NE(inside("check").out.find(": 0 experiments, 1 capture, "), std::string::npos);
  ASSERT_EQ(inside("capture captures/look.lua --bundle -o out/bundle").exit_code, 0);
  fs::remove_all(path("captures"));
  verified = inside("verify out/bundle");
  EXPECT_EQ(verified.exit_code, 0) << verified.out << verified.err;
}

// `check` tests both roots with their experiments, and names the file of each mistake.
TEST_F(Project, IsCheckedWithShippedFiles) {
  Outcome sound = inside("check");
  EXPECT_EQ(sound.exit_code, 0) << sound.err;
  EXPECT_NE(sound.out.find(path("").parent_path().string() + ": 0 experiments, 0 captures, 1 pipeline is sound\n"),
            std::string::npos)
      << sound.out;
  EXPECT_NE(sound.out.find("\n" + sourceFolder().string() + ": "), std::string::npos) << sound.out;
  addMember("edge", "roberts");
  std::string pass = contentOf(path("passes/edge/mine.lua"));
  write("passes/edge/mine.lua",
        std::regex_replace(pass, std::regex("compute \\{"), "compute { name = \"edge/sobel\","));
  write("experiments/half.lua", "return require 'strobe.experiment' { title = 'Half' }");
  Outcome wrong = inside("check");
  EXPECT_EQ(wrong.exit_code, 1);
  for (const char* mistake :
       {"passes/edge/mine.lua:6: another pass is called 'edge/sobel': strobe:passes/edge/sobel.lua:",
        "experiments/half.lua:1: "})
    EXPECT_NE(wrong.err.find(mistake), std::string::npos) << wrong.err;
  EXPECT_EQ(inside("check smeer").exit_code, 2);
}

TEST_F(Project, IsMarkedInHelp) {
  Outcome topics = inside("help", "shaders");
  EXPECT_NE(topics.out.find("[project] marks the files in " + path("").parent_path().string()), std::string::npos);
  std::istringstream lines(topics.out);
  for (std::string line; std::getline(lines, line);)
    if (line.starts_with("  "))
      EXPECT_EQ(line.find("[project]") != std::string::npos, line.starts_with("  smear ")) << line;
  EXPECT_NE(inside("help edge/sobel").out.find("`strobe:passes/edge/sobel.lua`, `strobe:shaders/edge/"),
            std::string::npos);
}

TEST_F(Project, ReadsOnlyItsRoots) {
  writeText(folder_.path() / "secret.lua", "return {}");
  writeText(folder_.path() / "secret.glsl", "#define SECRET 1\n");
  fs::create_symlink(folder_.path() / "secret.lua", path("passes/secret.lua"));
  write("pipelines/a.lua", "return require 'passes.secret'");
  expectRefused("plan a", "leads out of");
  fs::remove(path("passes/secret.lua"));
  write("pipelines/a.lua", "return require 'passes...secret'");
  expectRefused("plan a", "is not the name of a module");

  std::string shader = contentOf(path("shaders/smear.glsl"));
  write("shaders/smear.glsl", "#include \"lib/random.glsl\"\n" + shader);
  EXPECT_EQ(inside("check smear").exit_code, 0);
  for (const std::string& name : {std::string("../../secret.glsl"), (folder_.path() / "secret.glsl").string(),
                                  std::string("../../../../../../../../etc/passwd"), std::string("/etc/passwd")}) {
    write("shaders/smear.glsl", "#include \"" + name + "\"\n" + shader);
    expectRefused("check smear", "shaders/smear.glsl:1: '#include'");
    expectRefused("check smear", name);
  }
  fs::create_symlink(folder_.path() / "secret.glsl", path("shaders/inner.glsl"));
  write("shaders/smear.glsl", "#include \"inner.glsl\"\n" + shader);
  expectRefused("check smear", "shaders/inner.glsl: is a link that leads out of");
}

TEST(NewProject, RefusesUnusableFolders) {
  TemporaryFolder folder;
  writeText(folder / "file", "x");
  for (const std::string& name : {folder.path().string(), folder / "file", folder / "a name", folder / "-x"})
    EXPECT_EQ(run("new -- '" + name + "'").exit_code, 2) << name;
  EXPECT_EQ(run("new").exit_code, 2);
  Outcome refused = run("new /proc/mine");
  EXPECT_NE(refused.exit_code, 0) << refused.out;
  fs::create_directory(folder / "empty");
  EXPECT_EQ(run("new '" + (folder / "empty") + "'").exit_code, 0);
}

}  // namespace project_test
}  // namespace strobe::testing
