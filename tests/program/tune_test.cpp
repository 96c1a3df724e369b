// SPDX-License-Identifier: MIT
// The command `strobe tune`: the written preset, the results beside it, and refusals.
#include <gtest/gtest.h>

#include "base/json.h"
#include "program/run.h"

namespace strobe::testing {
namespace tune_test {

class Tune : public ::testing::Test {
 protected:
  Tune() {
    writeText(folder_ / "scene.lua", kCardScene);
    shot_ = "mcguire2012 --scene " + (folder_ / "scene.lua") + " --size 64x36 --move card=0.6,0,0 ";
  }

  Outcome tune(const std::string& options) { return run("tune " + shot_ + options + " -o " + (folder_ / "found.lua")); }
  void expectRefusal(const std::string& arguments, const std::string& wanted) {
    Outcome outcome = run("tune " + arguments, "STROBE_VALIDATION=0");
    EXPECT_EQ(outcome.exit_code, 2) << arguments;
    EXPECT_NE(outcome.err.find(wanted), std::string::npos) << outcome.err;
    EXPECT_FALSE(fs::exists(folder_ / "found"));
  }
  // The text about the timing of the chosen point.
  static std::string timesOf(const Json& groups, const Json& chosen) {
    for (const Json& group : groups)
      if (group["shot"] == "level 3" && group["points"][1]["command"] == chosen["command"])
        return group["points"][1]["times"];
    return "";
  }
  Json groups() const { return Json::parse(contentOf(folder_ / "found/result.json"))["groups"]; }

  TemporaryFolder folder_;
  std::string shot_;
};

TEST_F(Tune, WritesAPresetAndAllResults) {
  std::string options = "--set jitter=hash --vary samples,weights --budget-ratio 1000 --evaluations 18";
  Outcome outcome = tune(options + " --json");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  Json tuned = Json::parse(outcome.out);
  EXPECT_TRUE(tuned["met"].get<bool>());
  EXPECT_LT(tuned["chosen"]["error"].get<double>(), tuned["start"]["error"].get<double>());
  EXPECT_LE(tuned["evaluations"].get<int>(), 18);
  EXPECT_NE(outcome.err.find("best so far"), std::string::npos) << outcome.err;
  for (const char* file : {"report.html", "result.md", "table.csv", "passes.csv"})
    EXPECT_TRUE(fs::exists(folder_.path() / "found" / file)) << file;

  // Smallest error measured at the last level.
  double least = 1;
  const Json seen = groups();
  for (const Json& group : seen) {
    EXPECT_EQ(group["points"][0]["role"], "truth");
    if (group["shot"] == "level 3")
      least = std::min(least, group["points"][1]["values"]["rmse"]["inner"].get<double>());
  }
  EXPECT_NEAR(tuned["chosen"]["error"].get<double>(), least, 1e-8);
  EXPECT_EQ(timesOf(seen, tuned["chosen"]).rfind("15 to 45 rounds", 0), 0u) << timesOf(seen, tuned["chosen"]);

  // The preset has the found and the given settings, and draws the same picture.
  std::string preset = folder_ / "found.lua", out = folder_ / "out.png";
  EXPECT_NE(contentOf(preset).find("jitter = \"hash\""), std::string::npos) << contentOf(preset);
  Outcome drawn = run("render " + shot_ + "--set preset=" + preset + " -o " + out);
  ASSERT_EQ(drawn.exit_code, 0) << drawn.err;
  Json record = Json::parse(contentOf(folder_ / "out.record.json"));
  EXPECT_EQ(record["scripts"].count(preset), 1u) << "recorded by its content";
  bool same = false;
  for (const Json& group : seen)
    same = same || Json(group["points"][1].value("image", "")) == record["outputs"]["color"];
  EXPECT_TRUE(same);

  // A second run draws nothing and chooses the same point; `report` writes the page.
  auto drawn_at = [&] {
    std::map<std::string, fs::file_time_type> times;
    for (const auto& entry : fs::directory_iterator(folder_.path() / "found/truth"))
      times[entry.path().string()] = entry.last_write_time();
    return times;
  };
  std::string first = contentOf(preset);
  auto before = drawn_at();
  Outcome again = tune(options);
  ASSERT_EQ(again.exit_code, 0) << again.err;
  EXPECT_EQ(contentOf(preset), first);
  EXPECT_EQ(drawn_at(), before);
  EXPECT_NE(again.out.find("chosen"), std::string::npos) << again.out;
  EXPECT_NE(again.out.find("--set preset=" + preset), std::string::npos) << again.out;
  EXPECT_EQ(run("report " + (folder_ / "found")).exit_code, 0);
}

TEST_F(Tune, ReportsThatNoSettingMeetsTheLimit) {
  Outcome outcome = tune("--vary samples --max-error 0.01x --cost own --evaluations 10");
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_NE(outcome.err.find("no tried setting meets the limit"), std::string::npos) << outcome.err;
  EXPECT_NE(outcome.out.find("nearest"), std::string::npos) << outcome.out;
  EXPECT_FALSE(fs::exists(folder_ / "found.lua"));
  const Json seen = groups();
  EXPECT_GT(seen.size(), 3u) << "the front is written anyway";
  const Json& start = seen[0]["points"][1]["values"];
  EXPECT_GT(start["ms_own"]["all"].get<double>(), 0);
  EXPECT_LT(start["ms_own"]["all"].get<double>(), start["ms"]["all"].get<double>()) << "without shared passes";
  EXPECT_EQ(start["own_ratio"]["all"].get<double>(), 1) << "the base is itself";
}

// Edits of a project's pipeline and scene during a search have no effect.
TEST_F(Tune, ReadsItsFilesOnce) {
  ASSERT_EQ(run("new '" + (folder_ / "p") + "'").exit_code, 0);
  const fs::path project = folder_ / "p";
  const std::vector<std::string> files = {"pipelines/smear.lua", "scenes/card.lua"};
  fs::create_directories(project / "scenes");
  writeText(project / files[1], kCardScene);
  std::thread editor = spoilOnceCopied(project, folder_ / "found", files);
  Outcome outcome =
      runLine("cd '" + project.string() + "' && exec env STROBE_VALIDATION=0 '" + programPath() + "' tune " + files[0] +
              " --scene " + files[1] + " --size 64x36 --move card=0.6,0,0 --budget-ratio 1000 --evaluations 10 -o " +
              (folder_ / "found.lua"));
  editor.join();
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_NE(contentOf(project / files[0]).find("edited"), std::string::npos);
  EXPECT_NE(groups().at(0)["points"][1]["command"].get<std::string>().find(files[1]), std::string::npos);
}

TEST_F(Tune, RefusesMisuse) {
  const std::string found = " -o " + (folder_ / "found.lua") + " ", goal = found + "--budget-ratio 1 ";
  expectRefusal(shot_ + found, "none of --budget-ms, --budget-ratio and --max-error is given");
  expectRefusal(shot_ + goal + "--max-error 1", "two of --budget-ms, --budget-ratio and --max-error are given");
  expectRefusal(shot_ + found + "--max-error little", "neither a number above 0");
  expectRefusal(shot_ + goal + "--measure rmes", "unknown value 'rmes'; did you mean 'rmse'?");
  expectRefusal(shot_ + goal + "--measure psnr", "unknown value 'psnr'");
  expectRefusal(shot_ + goal + "--region iner", "did you mean 'inner'?");
  expectRefusal(shot_ + goal + "--vary smaples", "'mcguire2012' has no parameter 'smaples'; did you mean 'samples'?");
  expectRefusal(shot_ + goal + "--set samples=4 --vary samples", "'samples' is also set");
  expectRefusal(shot_ + goal + "--base mcguire2013", "did you mean 'mcguire2012'?");
  expectRefusal("none" + goal, "'none' has no parameter to vary");
  expectRefusal("ground_truth" + goal, "'ground_truth' is truth");
  expectRefusal(shot_ + "--budget-ratio 1 -o " + (folder_ / "found.txt"), "a preset is a .lua file");
}

}  // namespace tune_test
}  // namespace strobe::testing
