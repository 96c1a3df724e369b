// SPDX-License-Identifier: MIT
// The options `render --pixel` and `--tev`, and commands that inspect a plan.
#include <gtest/gtest.h>

#include "base/json.h"
#include "program/run.h"

namespace strobe::testing {
namespace inspect_test {

const std::string kShot = " --scene oracles/bar --size 64x32";

TEST(Inspect, PixelPrintsATable) {
  Outcome outcome = run("render mcguire2012" + kShot + " --pixel 30,12");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  for (const char* wanted : {"pixel 30,12 of 64x32", "gbuffer", "velocity", "tile", "depth [m]", "metres"})
    EXPECT_NE(outcome.out.find(wanted), std::string::npos) << wanted << "\n" << outcome.out;
}

TEST(Inspect, UnnamedPictureIsWrittenToOut) {
  TemporaryFolder folder;
  Outcome outcome = run("render none" + kShot, "-C " + folder.path().string() + " STROBE_VALIDATION=0");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(outcome.out, "out/none.png\nout/none.record.json\nout/none.timings.json\n");
  EXPECT_TRUE(fs::exists(folder.path() / "out/none.png"));
  EXPECT_NE(run("render nonee" + kShot).err.find("did you mean 'none'?"), std::string::npos);
  run("render none" + kShot + " --tap gbuffer.depth", "-C " + folder.path().string());
  EXPECT_TRUE(fs::exists(folder.path() / "out/none.exr"));
}

// An option takes one value: the next word is the pipeline.
TEST(Inspect, PipelineMayFollowAnOption) {
  for (const char* options : {"--size 32x18", "--frame 2", "--anchor start"}) {
    Outcome outcome = run(std::string("plan ") + options + " none");
    EXPECT_EQ(outcome.exit_code, 0) << options << ": " << outcome.err;
  }
}

TEST(Inspect, PlanStatesTheSizeOfItsScene) {
  std::string text = run("plan none --scene oracles/bar").out;
  EXPECT_NE(text.find("scene oracles/bar: 4 triangles in 2 instances\n"), std::string::npos) << text;
  EXPECT_EQ(run("plan none --scene oracles/barr").exit_code, 2);
}

// A missing library, a missing manifest and damaged manifests; the other driver still provides devices.
TEST(Inspect, DoctorNamesDriversThatDoNotLoad) {
  std::string device = Json::parse(run("doctor --json").out)["devices"][0]["name"];
  std::string manifests = runLine("ls /usr/share/vulkan/icd.d/lvp_icd*.json /etc/vulkan/icd.d/*.json 2>/dev/null").out;
  if (manifests.empty()) GTEST_SKIP() << "no manifest of a driver in the usual places";
  std::string good = manifests.substr(0, manifests.find('\n'));
  TemporaryFolder folder;
  writeText(
      folder / "missing.json",
      R"({"file_format_version": "1.0.0", "ICD": {"library_path": "/nowhere/libmissing.so", "api_version": "1.3.0"}})");
  writeText(folder / "broken.json", R"({"ICD": {"library_path")");
  writeText(folder / "list.json", "[1]");
  writeText(folder / "bare.json", R"({"file_format_version": "1.0.0", "ICD": {"library_path": 3}})");
  for (const auto& [manifest, named] : {std::pair(folder / "missing.json", std::string("libmissing.so")),
                                        {folder / "gone.json", folder / "gone.json: no such file"},
                                        {folder / "broken.json", folder / "broken.json: is not valid JSON"},
                                        {folder / "list.json", folder / "list.json: has no ICD.library_path"},
                                        {folder / "bare.json", folder / "bare.json: has no ICD.library_path"}}) {
    const std::string environment = "VK_DRIVER_FILES=" + manifest + ":" + good;
    Outcome outcome = run("doctor", environment);
    EXPECT_EQ(outcome.exit_code, 1) << manifest;
    EXPECT_NE(outcome.out.find("driver not loaded: "), std::string::npos) << outcome.out;
    EXPECT_NE(outcome.err.find(named), std::string::npos) << outcome.err;
    Json report = Json::parse(run("doctor --json", environment).out);
    EXPECT_FALSE(report["driver_problems"].empty());
    const bool is_damaged = named.find("JSON") + 1 || named.find("library_path") + 1;
    EXPECT_EQ(report["devices"].empty(), is_damaged)
        << "with a damaged manifest the loader finds no other driver, or crashes";
  }
}

// Experiments and captures, with and without pipelines.
TEST(Inspect, CheckReadsFilesByTheirKind) {
  TemporaryFolder folder;
  auto experiment = [](const std::string& camera, const std::string& arm) {
    return "return require 'strobe.experiment' { title = 'Bar', size = { 64, 16 },\n"
           "  truth = { pipeline = 'ground_truth' },\n"
           "  shots = { { name = 'bar', scene = 'oracles/bar', camera = '" +
           camera + "' } },\n  arms = { { name = 'hybrid', pipeline = 'hybrid'" + arm + " } } }\n";
  };
  const std::string capture =
      "return require 'strobe.capture' { title = 'Bar', size = { 64, 16 },\n"
      "  shots = { { name = 'bar', scene = 'oracles/bar' } },\n  arms = { { name = 'none', pipeline = 'none' } } }\n";
  writeText(folder / "good.lua", experiment("main", ""));
  writeText(folder / "wrong.lua", experiment("mian", ", set = { edg = 4 }"));
  writeText(folder / "capture.lua", capture);
  writeText(folder / "half.lua", capture.substr(0, capture.find("shots")) + "}\n");
  Outcome good = run("check none " + (folder / "good.lua") + " " + (folder / "capture.lua"));
  EXPECT_EQ(good.out, "1 pipeline and 1 experiment and 1 capture are sound\n") << good.err;
  EXPECT_EQ(run("check " + (folder / "good.lua")).out, "1 experiment is sound\n");
  Outcome wrong = run("check " + (folder / "wrong.lua") + " " + (folder / "half.lua"));
  EXPECT_EQ(wrong.exit_code, 1);
  for (const char* mistake :
       {"wrong.lua:3: shot 'bar': --camera mian: bar has no camera 'mian'; did you mean 'main'?",
        "wrong.lua:4: arm 'hybrid': --set edg=4: the pipeline has no parameter 'edg'; did you mean 'edge'?\n",
        "half.lua:1: "})
    EXPECT_NE(wrong.err.find(mistake), std::string::npos) << wrong.err;
  Outcome set = run("check " + (folder / "good.lua") + " --set samples=4");
  EXPECT_EQ(set.exit_code, 2);
  EXPECT_NE(set.err.find("--set needs a pipeline"), std::string::npos) << set.err;
}

TEST(Inspect, CountersAreShownOnRequest) {
  TemporaryFolder folder;
  std::string render = "render hybrid" + kShot + " -o " + (folder / "a.png");
  Outcome quiet = run(render), verbose = run(render + " --verbose");
  EXPECT_EQ(quiet.err.find('.'), std::string::npos) << quiet.err;
  Json counters = Json::parse(contentOf(folder / "a.record.json"))["counters"];
  for (const auto& [name, count] : counters.items())
    EXPECT_EQ(verbose.err.find(name + " " + count.dump()) != std::string::npos, count != 0) << name;
}

// --pixel changes neither the picture nor its record.
TEST(Inspect, PixelChangesNoFile) {
  TemporaryFolder folder;
  EXPECT_EQ(run("render hybrid" + kShot + " -o " + (folder / "a.exr")).exit_code, 0);
  Outcome looked = run("render hybrid" + kShot + " --pixel 30,12 --json -o " + (folder / "b.exr"));
  EXPECT_EQ(looked.exit_code, 0) << looked.err;
  EXPECT_EQ(contentOf(folder / "a.exr"), contentOf(folder / "b.exr"));
  EXPECT_EQ(contentOf(folder / "a.record.json"), contentOf(folder / "b.record.json"));
  Json trail = Json::parse(looked.out);
  EXPECT_EQ(trail["pixel"], Json::parse("[30, 12]"));
  EXPECT_GT(trail["passes"].size(), 5u);
  EXPECT_FALSE(trail["hits"].empty());
}

// A picture per output and tap, each as large as the frame and reproducible.
TEST(Inspect, ViewsShowEveryImage) {
  TemporaryFolder folder;
  std::string command = "render mcguire2012" + kShot + " --tap neighbour_max.dominant --views ";
  Outcome outcome = run(command + (folder / "views"));
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  for (const char* name : {"color", "depth", "id", "normal", "velocity", "neighbour_max.dominant"}) {
    std::string bytes = contentOf(folder / (std::string("views/") + name + ".png"));
    ASSERT_GT(bytes.size(), 24u) << name;
    EXPECT_EQ(bytes.substr(16, 8), std::string("\0\0\0\x40\0\0\0\x20", 8)) << name << " is not 64x32";
    EXPECT_NE(outcome.out.find(std::string(name) + ".png"), std::string::npos) << outcome.out;
  }
  EXPECT_EQ(run(command + (folder / "again")).exit_code, 0);
  EXPECT_EQ(contentOf(folder / "views/velocity.png"), contentOf(folder / "again/velocity.png"));
}

TEST(Inspect, MistakesAreUsageErrors) {
  for (const auto& [options, wanted] :
       {std::pair<std::string, std::string>{"--pixel 64,0", "outside of the picture of 64x32"},
        {"--pixel 3", "is not X,Y"},
        {"--tev nowhere", "is not HOST:PORT"}}) {
    Outcome outcome = run("render none" + kShot + " " + options, "STROBE_VALIDATION=0");
    EXPECT_EQ(outcome.exit_code, 2) << options;
    EXPECT_NE(outcome.err.find(wanted), std::string::npos) << outcome.err;
    EXPECT_EQ(outcome.out, "");
  }
}

// No program listens on port 9 of this machine (the obsolete discard service).
TEST(Inspect, MissingViewerIsNotAnError) {
  TemporaryFolder folder;
  Outcome outcome = run("render none" + kShot + " --tev localhost:9 -o " + (folder / "a.png"), "STROBE_VALIDATION=0");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "");
}

}  // namespace inspect_test
}  // namespace strobe::testing
