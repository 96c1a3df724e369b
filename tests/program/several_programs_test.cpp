// SPDX-License-Identifier: MIT
// Several programs in one folder of a sweep: complete programs, killed programs, shares, and the output of `status`.
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <regex>

#include "base/json.h"
#include "base/process_name.h"
#include "program/run.h"

namespace strobe::testing {
namespace several_programs_test {

// 24 points with four truths.
const char* const kMany = R"lua(
local experiment = require "strobe.experiment"
return experiment {
  title = "Many", size = { 64, 36 }, regions = { "whole", "inner" }, measures = { "rmse", "flip", "memory" }, rounds = 1,
  shots = { { name = "bar", scene = "oracles/bar" } },
  arms = { { name = "none", pipeline = "none", lacks = { "samples" } },
           { name = "mcguire", pipeline = "mcguire2012" } },
  truth = { pipeline = "ground_truth", set = { samples = SAMPLES } },
  vary = { experiment.grid { exposure = { 0.2, 0.4, 0.6, 0.8 }, samples = experiment.linear(1, 3, 3) } },
}
)lua";

class SeveralPrograms : public ::testing::Test {
 protected:
  void write(const std::string& samples = "16", const std::string& measure = "\"memory\"") const {
    std::string text = std::regex_replace(kMany, std::regex("SAMPLES"), samples);
    writeText(folder_ / "x.lua", std::regex_replace(text, std::regex("\"memory\""), measure));
  }
  std::string command(const std::string& out, const std::string& more = "") const {
    return "sweep " + (folder_ / "x.lua") + " -o " + (folder_ / out) + " " + more;
  }
  Outcome sweep(const std::string& out, const std::string& more = "", const std::string& environment = "") const {
    return run(command(out, more), "STROBE_VALIDATION=0 " + environment);
  }
  Outcome status(const std::string& out, const std::string& more = "") const {
    return run("status " + (folder_ / out) + " " + more, "STROBE_VALIDATION=0");
  }
  // Starts a sweep; its messages go to a file.
  pid_t start(const std::string& out, const std::string& more = "") {
    const std::string err = folder_ / ("err" + std::to_string(started_++));
    pid_t child = ::fork();
    if (child != 0) return child;
    std::string line =
        "exec env STROBE_VALIDATION=0 '" + programPath() + "' " + command(out, more) + " >/dev/null 2>" + err;
    ::execl("/bin/sh", "sh", "-c", line.c_str(), nullptr);
    ::_exit(127);
  }
  void startAll(const std::string& out, int count) {
    for (int i = 0; i < count; ++i) running_.push_back(start(out));
  }
  void expectAllSucceed() {
    for (pid_t child : running_) {
      int code = 0;
      ::waitpid(child, &code, 0);
      EXPECT_EQ(code, 0);
    }
    for (int i = 0; i < started_; ++i) EXPECT_EQ(file("", "err" + std::to_string(i)).find("failed"), std::string::npos);
    running_.clear();
  }
  std::string file(const std::string& out, const std::string& name) const {
    return contentOf(folder_ / (out + "/" + name));
  }
  std::vector<fs::path> filesIn(const std::string& folder, const std::string& ending) const {
    std::vector<fs::path> files;
    std::error_code missing;
    for (const auto& entry : fs::directory_iterator(folder_ / folder, missing))
      if (entry.path().extension() == ending) files.push_back(entry.path());
    return files;
  }
  void expectNothingIsLeft(const std::string& out) const {
    EXPECT_TRUE(copyIn(folder_ / out).empty());
    for (const char* ending : {".lock", ".json", ".part"})
      EXPECT_TRUE(filesIn(out + "/.workers", ending).empty()) << ending;
    EXPECT_FALSE(fs::exists(folder_ / (out + "/unfinished.json")));
  }

  TemporaryFolder folder_;
  std::vector<pid_t> running_;
  int started_ = 0;
};

TEST_F(SeveralPrograms, GiveTheTableOfOneProgram) {
  write();
  ASSERT_EQ(sweep("one").exit_code, 0);
  startAll("eight", 8);
  expectAllSucceed();
  EXPECT_EQ(file("eight", "table.csv"), file("one", "table.csv"));
  ASSERT_EQ(filesIn("one/points", ".json").size(), 20u) << "four truths, four points of `none`, 12 of the other arm";
  for (const fs::path& point : filesIn("one/points", ".json"))
    EXPECT_EQ(file("eight", "points/" + point.filename().string()), contentOf(point));
  EXPECT_EQ(filesIn("eight/truth", ".exr").size(), 4u);
  expectNothingIsLeft("eight");
  const Outcome done = status("eight");
  EXPECT_EQ(done.exit_code, 0);
  EXPECT_EQ(done.out, "Many: 24 of 24 points drawn, 0 missing, 0 failed\n");
}

TEST_F(SeveralPrograms, MeasureTimesInTurn) {
  write("4", "\"ms\", \"ms_ratio\"");
  startAll("out", 3);
  expectAllSucceed();
  const Json results = Json::parse(file("out", "result.json"));
  for (const Json& group : results["groups"])
    for (const Json& point : group["points"])
      if (point["role"] != "truth") EXPECT_GT(point["values"]["ms"]["all"].get<double>(), 0);
  expectNothingIsLeft("out");
  // A share measures the times of its points, with the base of the whole.
  for (const char* share : {"2/2", "1/2"}) {
    Outcome outcome = sweep("shares", "--share " + std::string(share));
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_NE(outcome.err.find("times: 100 %"), std::string::npos) << outcome.err;
  }
  Outcome whole = sweep("shares");
  EXPECT_EQ(whole.exit_code, 0) << whole.err;
  EXPECT_EQ(whole.err.find("times: "), std::string::npos) << whole.err;
}

// A program is killed while it draws a truth. Other programs draw the points that it had claimed.
TEST_F(SeveralPrograms, TakeOverClaimsOfAKilledProgram) {
  write("256");
  const pid_t killed = start("killed");
  for (int waited = 0; filesIn("killed/.workers", ".lock").size() < 2 && waited < 3000; ++waited) ::usleep(10000);
  EXPECT_EQ(filesIn("killed/.workers", ".lock").size(), 2u) << "claims of a point and its truth";
  ::kill(killed, SIGSTOP);
  const Json now = Json::parse(status("killed", "--json").out);
  EXPECT_EQ(now["missing"], 24);
  ASSERT_EQ(now["programs"].size(), 1u);
  EXPECT_EQ(now["programs"][0]["running"], true);
  EXPECT_EQ(now["programs"][0]["now"], "bar, exposure 0.2, samples 1, ground truth");
  ::kill(killed, SIGKILL);
  ::waitpid(killed, nullptr, 0);
  EXPECT_TRUE(std::regex_search(status("killed").out, std::regex("\nlost     \\S+, no sign for \\d+ s\n")))
      << status("killed").out;
  // A claim of another machine that was not renewed for a minute.
  const fs::path claim = filesIn("killed/.workers", ".lock").front();
  writeText(claim, "elsewhere-0000.1");
  fs::last_write_time(claim, fs::file_time_type::clock::now() - std::chrono::seconds(61));
  startAll("killed", 2);
  expectAllSucceed();
  ASSERT_EQ(sweep("one").exit_code, 0);
  EXPECT_EQ(file("killed", "table.csv"), file("one", "table.csv"));
  expectNothingIsLeft("killed");
}

TEST_F(SeveralPrograms, DrawShares) {
  write();
  ASSERT_EQ(sweep("one").exit_code, 0);
  // Tasks 10, 13 and 16 of an array, two at a time.
  size_t points = 0;
  for (int task : {16, 10, 13}) {
    Outcome share = sweep("shares", "",
                          "SLURM_ARRAY_TASK_MIN=10 SLURM_ARRAY_TASK_MAX=16 SLURM_ARRAY_TASK_STEP=3 "
                          "SLURM_ARRAY_TASK_COUNT=3 SLURM_ARRAY_TASK_ID=" +
                              std::to_string(task));
    EXPECT_EQ(share.exit_code, 0) << share.err;
    const std::string name = std::to_string((task - 10) / 3 + 1) + "/3";
    std::smatch counted;
    ASSERT_TRUE(std::regex_search(share.out, counted, std::regex("share " + name + ": (\\d+) points; ")))
        << share.out << share.err;
    points += std::stoul(counted[1]);
    EXPECT_FALSE(fs::exists(folder_ / "shares/result.json"));
    EXPECT_EQ(filesIn("shares/truth", ".exr").size(), task == 16   ? 1u
                                                      : task == 10 ? 3u
                                                                   : 4u)
        << "each truth is drawn by one share";
  }
  EXPECT_EQ(points, 24u);
  EXPECT_EQ(run("report " + (folder_ / "shares"), "STROBE_VALIDATION=0").exit_code, 0);
  EXPECT_EQ(file("shares", "table.csv"), file("one", "table.csv"));
  Outcome whole = sweep("shares");
  EXPECT_EQ(whole.exit_code, 0) << whole.err;
  EXPECT_EQ(whole.err.find("left to draw"), std::string::npos) << whole.err;
  EXPECT_EQ(file("shares", "table.csv"), file("one", "table.csv"));
  expectNothingIsLeft("shares");

  Outcome listed = sweep("shares", "--share 1/3 --dry-run");
  EXPECT_TRUE(std::regex_search(listed.out, std::regex("\nshare 1/3: 12 points, 2 truths, about \\d+ s\n"
                                                       "share 2/3: 6 points, 1 truth, about \\d+ s\n"
                                                       "share 3/3: 6 points, 1 truth, about \\d+ s\n$")))
      << listed.out;
  EXPECT_EQ(Json::parse(sweep("shares", "--share 3/3 --dry-run --json").out).size(), 6u);
}

// Each share moves its points into a pack. All commands read packs, and a damaged pack is made again.
TEST_F(SeveralPrograms, PackTheirPoints) {
  write("4", "\"ms\"");
  EXPECT_EQ(sweep("packed", "--share 1/2").exit_code, 0) << "its single files are packed by the next run";
  for (const char* share : {"--share 1/2", "--share 2/2"})
    EXPECT_EQ(sweep("packed", std::string(share) + " --pack").exit_code, 0);
  const std::vector<fs::path> packs = filesIn("packed/packs", ".zip");
  ASSERT_EQ(packs.size(), 2u);
  // A truth has no times, but is a complete point.
  EXPECT_TRUE(filesIn("packed/points", ".json").empty());
  EXPECT_TRUE(filesIn("packed/points", ".png").empty());
  const Outcome report = run("report " + (folder_ / "packed"), "STROBE_VALIDATION=0");
  EXPECT_EQ(report.exit_code, 0) << report.err;
  EXPECT_EQ(report.err, "");
  EXPECT_EQ(file("packed", "report.html").find("no picture"), std::string::npos);
  Outcome again = sweep("packed");
  EXPECT_EQ(again.exit_code, 0) << again.err;
  EXPECT_EQ(again.err.find("left to draw"), std::string::npos) << again.err;
  EXPECT_EQ(again.err.find("times: "), std::string::npos) << again.err;

  fs::resize_file(packs[0], 100);
  const Outcome damaged = run("report " + (folder_ / "packed"), "STROBE_VALIDATION=0");
  EXPECT_EQ(damaged.exit_code, 1);
  EXPECT_NE(damaged.err.find(packs[0].string() + ": is damaged and left out"), std::string::npos) << damaged.err;
  again = sweep("packed", "--pack");
  EXPECT_EQ(again.exit_code, 0) << again.err;
  EXPECT_NE(again.err.find(packs[0].filename().string() + ".damaged"), std::string::npos) << again.err;
  EXPECT_EQ(filesIn("packed/packs", ".zip").size(), 2u);
  EXPECT_EQ(status("packed").out, "Many: 24 of 24 points drawn, 0 missing, 0 failed\n");
}

// To the faked program, the clock of the file system is two hours ahead of the machine, far beyond the lease.
TEST_F(SeveralPrograms, NameUnequalClocksAndGiveTheSameTable) {
  if (runLine("command -v faketime").exit_code != 0) GTEST_SKIP() << "no faketime";
  write();
  ASSERT_EQ(sweep("one").exit_code, 0);
  startAll("two", 1);
  const Outcome skewed = runLine("STROBE_VALIDATION=0 exec faketime -f +2h '" + programPath() + "' " + command("two"));
  EXPECT_EQ(skewed.exit_code, 0) << skewed.err;
  EXPECT_NE(skewed.err.find("s ahead of the clock of this machine; results do not depend on clocks\n"),
            std::string::npos)
      << skewed.err;
  expectAllSucceed();
  EXPECT_EQ(file("two", "table.csv"), file("one", "table.csv"));
  expectNothingIsLeft("two");
}

TEST_F(SeveralPrograms, RefuseMistakes) {
  write();
  auto refused = [](const Outcome& outcome, const std::string& wanted) {
    EXPECT_EQ(outcome.exit_code, 2) << wanted;
    EXPECT_NE(outcome.err.find(wanted), std::string::npos) << outcome.err;
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
  };
  for (const char* share : {"0/3", "4/3", "1", "a/b", "1/3/5", "1.5/2", "-1/2"})
    refused(sweep("out", "--share=" + std::string(share)), "--share '" + std::string(share) + "' is not I/N");
  refused(
      sweep("out", "", "SLURM_ARRAY_TASK_MIN=1 SLURM_ARRAY_TASK_STEP=1 SLURM_ARRAY_TASK_COUNT=3 SLURM_ARRAY_TASK_ID=7"),
      "task 7 of this Slurm array has no share");
  refused(status("nowhere"), "no results in");
  EXPECT_FALSE(fs::exists(folder_ / "out"));
}

// Files that changed since the last run are named. They are an error while a program draws with the earlier files.
TEST_F(SeveralPrograms, AgreeOnTheirInputs) {
  write();
  ASSERT_EQ(sweep("out", "--only exposure=0.2").exit_code, 0);
  write("8");
  const fs::path sign = folder_ / ("out/.workers/" + processName() + ".json");
  Json state = {{"share", ""}, {"device", "a device"}, {"version", "another"}, {"since", 0.0},
                {"now", ""},   {"drawn", 0},           {"drawing_s", 0.0}};
  writeText(sign, state.dump());
  Outcome refused = sweep("out");
  EXPECT_EQ(refused.exit_code, 2);
  EXPECT_NE(refused.err.find("process " + processName() + " works in this folder with another version of " +
                             (folder_ / "x.lua")),
            std::string::npos)
      << refused.err;
  EXPECT_EQ(filesIn("out/truth", ".exr").size(), 1u) << "the truth is kept";
  fs::remove(sign);
  Outcome warned = sweep("out", "--only exposure=0.2");
  EXPECT_EQ(warned.exit_code, 0) << warned.err;
  EXPECT_NE(warned.err.find("changed since the last run: " + (folder_ / "x.lua") + "; points"), std::string::npos)
      << warned.err;
  Outcome again = sweep("out", "--only exposure=0.2");
  EXPECT_EQ(again.err.find("changed since"), std::string::npos) << again.err;
}

}  // namespace several_programs_test
}  // namespace strobe::testing
