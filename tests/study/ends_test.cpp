// SPDX-License-Identifier: MIT
// Incomplete runs: lost devices, processes of other modules, counts of kept points.
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cmath>

#include "common/home.h"
#include "program/run.h"
#include "study/report.h"
#include "study/run.h"
#include "study/watch.h"

namespace strobe::study {
namespace ends_test {

// A child process of another module has ended and waits to be reaped by that module.
TEST(Processes, LeaveChildrenOfOtherModules) {
  pid_t other = ::fork();
  if (other == 0) ::_exit(7);
  siginfo_t info{};
  ASSERT_EQ(::waitid(P_PID, id_t(other), &info, WEXITED | WNOWAIT), 0);
  testing::TemporaryFolder folder;
  Store store(folder.path());
  auto none = []() -> std::unique_ptr<lab::Workbench> { throw Error("there is no device"); };
  Experiment experiment;
  EXPECT_FALSE(Helpers(experiment, none, store, 2).wait());
  int status = 0;
  ASSERT_EQ(::waitpid(other, &status, 0), other) << "the other module's child was reaped";
  EXPECT_EQ(WEXITSTATUS(status), 7);
}

const char* const kSmall = R"lua(
local experiment = require "strobe.experiment"
return experiment {
  title = "Small", size = { 48, 24 }, regions = { "whole" }, measures = { "rmse" },
  truth = { pipeline = "ground_truth", set = { samples = 4 } },
  arms = { { name = "none", pipeline = "none", lacks = { "samples" } }, { name = "mcguire", pipeline = "mcguire2012" } },
  shots = { { name = "bar", scene = "oracles/bar", frame = 0, ["scene.d_f"] = 6 } },
  vary = { experiment.each { experiment.list { name = "threshold", values = { 1, 2, 3 },
                                               at = function(v) return { samples = v } end } } },
}
)lua";

// Reports the device as lost after the first point is stored. The device still finishes its work, so that it can be
// destroyed.
Path points;
gpu::Dispatch calls_before;

VkResult waitOrLose(VkDevice device, uint32_t count, const VkFence* fences, VkBool32 all, uint64_t limit_ns) {
  VkResult result = calls_before.WaitForFences(device, count, fences, all, limit_ns);
  if (namesIn(points, ".json").empty()) return result;
  calls_before.ResetFences(device, count, fences);
  return VK_ERROR_DEVICE_LOST;
}

TEST(LostDevice, EndsARunWithoutFailedPoints) {
  testing::TemporaryFolder folder;
  testing::writeText(folder / "x.lua", kSmall);
  Experiment experiment = readExperiment(home(), folder / "x.lua");
  Store store(folder.path());
  points = folder.path() / "points";
  {
    lab::Workbench bench(home(), gpu::DeviceOptions{});
    auto& calls = const_cast<gpu::Dispatch&>(bench.device().vk());
    calls_before = calls;
    calls.WaitForFences = waitOrLose;
    try {
      lab::Batch batch(bench);
      run(experiment, batch, store);
      ADD_FAILURE() << "the loss was reported as a failure of a point";
    } catch (const gpu::DeviceLost& lost) {
      EXPECT_NE(std::string(lost.what()).find("bar, threshold 1, "), std::string::npos) << lost.what();
    }
    calls = calls_before;
  }
  EXPECT_EQ(namesIn(points, ".json").size(), 1u) << "no later point is stored as failed";
  lab::Workbench bench(home(), gpu::DeviceOptions{});
  lab::Batch batch(bench);
  Results results = run(experiment, batch, store);
  EXPECT_EQ(results.failed(), std::vector<std::string>());
  EXPECT_EQ(results.missing(), 0u);
}

// Truth never reaches the required standard error.
TEST(FailedPoints, AreSetAsideAfterThreeTries) {
  testing::TemporaryFolder folder;
  std::string text = kSmall;
  text.replace(text.find("samples = 4"), 11, "samples = 65536, tolerance = 1, times = \"stratified\"");
  testing::writeText(folder / "x.lua", text.replace(text.find("{ 1, 2, 3 }"), 11, "{ 1 }"));
  Experiment experiment = readExperiment(home(), folder / "x.lua");
  experiment.truth_error = 1e-12;
  lab::Workbench bench(home(), gpu::DeviceOptions{});
  auto runOnce = [&](bool retries) {
    Store store(folder.path());
    store.retries = retries;
    lab::Batch batch(bench);
    Results results = run(experiment, batch, store);
    EXPECT_EQ(results.failed().size(), 3u);
    EXPECT_EQ(results.missing(), 0u);
    for (const Point& point : results.groups[0].points)
      EXPECT_EQ(point.tries, std::vector<std::string>(point.tries.size(), point.failed));
    return std::pair(results.groups[0].points[1].tries.size(), batch.drawn());
  };
  for (size_t tries : {1, 2, 3}) {
    auto [tried, drawn] = runOnce(false);
    EXPECT_EQ(tried, tries);
    EXPECT_GT(drawn, 0);
  }
  EXPECT_EQ(runOnce(false), std::pair(size_t{3}, 0)) << "the failed point was drawn again";
  EXPECT_EQ(runOnce(true).first, 4u);
}

// After all five points are drawn, submissions for timing fail.
VkResult submitOrFail(VkQueue queue, uint32_t count, const VkSubmitInfo2* submits, VkFence fence) {
  if (namesIn(points, ".json").size() == 5) return VK_ERROR_OUT_OF_DEVICE_MEMORY;
  return calls_before.QueueSubmit2(queue, count, submits, fence);
}

TEST(FailedTimes, KeepThePicturesAndAreMeasuredAgain) {
  testing::TemporaryFolder folder;
  std::string timed = kSmall;
  testing::writeText(folder / "x.lua", timed.replace(timed.find("\"rmse\""), 6, "\"rmse\", \"ms\""));
  Experiment experiment = readExperiment(home(), folder / "x.lua");
  points = folder.path() / "points";
  auto runOnce = [&](int& drawn, bool fails) {
    lab::Workbench bench(home(), gpu::DeviceOptions{});
    auto& calls = const_cast<gpu::Dispatch&>(bench.device().vk());
    calls_before = calls;
    if (fails) calls.QueueSubmit2 = submitOrFail;
    lab::Batch batch(bench);
    Results results = run(experiment, batch, Store(folder.path()));
    drawn = batch.drawn();
    calls = calls_before;
    return results;
  };
  int drawn = 0;
  Results failed = runOnce(drawn, true);
  EXPECT_GT(drawn, 0);
  ASSERT_EQ(failed.failed().size(), 6u) << "every point except truth";
  EXPECT_NE(failed.failed()[0].find("none: times: "), std::string::npos) << failed.failed()[0];
  const Point& point = failed.groups[0].points[1];
  EXPECT_GT(point.value("rmse"), 0);
  EXPECT_TRUE(std::isnan(point.value("ms")));
  EXPECT_NE(csvOf(failed).find("failed: times: "), std::string::npos);
  EXPECT_EQ(keptText(failed), "6 of 6 points are kept; the same command continues");

  Results timed_again = runOnce(drawn, false);
  EXPECT_EQ(drawn, 0) << "pictures were drawn again";
  EXPECT_EQ(timed_again.failed(), std::vector<std::string>());
  EXPECT_GT(timed_again.groups[0].points[1].value("ms"), 0);
  EXPECT_EQ(timed_again.groups[0].points[1].value("rmse"), point.value("rmse"));
}

// Groups whose values do not change truth share one truth; the list of points counts it before drawing.
TEST(Counts, OfTruthsAreDistinct) {
  testing::TemporaryFolder folder;
  testing::writeText(folder / "x.lua", kSmall);
  Experiment experiment = readExperiment(home(), folder / "x.lua");
  EXPECT_EQ(experiment.groups.size(), 3u);
  EXPECT_EQ(experiment.truths(), 1u);
  EXPECT_EQ(experiment.points(), 6u);
}

Results partial() {
  Results results;
  for (int g = 0; g < 3; ++g) {
    PointGroup group{"bar", "end", {}, {}};
    for (const char* arm : {"truth", "none", "hybrid"}) {
      Point point;
      point.arm = arm, point.key = arm + std::to_string(arm == std::string("truth") ? g / 2 : g);
      point.role = arm == std::string("truth") ? ArmRole::truth : ArmRole::method;
      point.command = "strobe render " + point.key;
      group.points.push_back(point);
    }
    results.groups.push_back(group);
  }
  return results;
}

// Groups whose values do not change truth share its picture, although other measures may change the keys of its points.
TEST(Counts, OfMissingTruthsAreDistinct) {
  Results results = partial();
  results.groups[0].points[0].key = "with another measure";
  EXPECT_EQ(results.missingText(), "6 of 6 points, 2 of 2 truths");
  results.groups[2].points[0].values["rmse"]["whole"] = 0;
  EXPECT_EQ(results.missingText(), "6 of 6 points, 1 of 2 truths");
  for (size_t g : {0, 1}) results.groups[g].points[0].key = "", results.groups[g].points[0].failed = "a reason";
  EXPECT_EQ(results.missingText(), "6 of 6 points");
  EXPECT_EQ(results.truths(), 1u) << "only truths that can be drawn";
}

// The message of an interrupted sweep, with any content of its folder.
TEST(Counts, OfADamagedFolderAreOmitted) {
  testing::TemporaryFolder folder;
  Results results = partial();
  results.title = "Partial", results.width = 64, results.height = 36, results.shots = {{"bar"}};
  results.regions = {"whole"}, results.measures = {"rmse"};
  results.arms = {{{"truth", "ground_truth"}, ArmRole::truth},
                  {{"none", "none"}, ArmRole::method},
                  {{"hybrid", "hybrid"}, ArmRole::method}};
  const std::string whole = textOf(results);
  std::filesystem::create_directories(folder / "points");
  testing::writeText(pointFile(folder.path(), "none0", ".json"), "{");
  EXPECT_EQ(keptIn(folder / "outline.json"), "the same command continues") << "without an outline";
  testing::writeText(folder / "outline.json", whole);
  EXPECT_EQ(keptIn(folder / "outline.json"), "0 of 6 points are kept; the same command continues");
  for (const std::string& damaged :
       {std::string(), whole.substr(0, whole.size() / 2), std::string("{\"groups\": 3}")}) {
    testing::writeText(folder / "outline.json", damaged);
    EXPECT_EQ(keptIn(folder / "outline.json"), "the same command continues") << damaged;
  }
}

}  // namespace ends_test
}  // namespace strobe::study
