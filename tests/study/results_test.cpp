// SPDX-License-Identifier: MIT
// Results: written and read, as a table, as curves with the range in which an arm is trusted, and as a page.
#include "study/results.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <random>
#include <set>

#include "common/home.h"
#include "image/exr.h"
#include "program/run.h"
#include "study/curves.h"
#include "study/report.h"
#include "study/store.h"

namespace strobe::study {
namespace results_test {

constexpr double kNothing = std::numeric_limits<double>::quiet_NaN();

Point of(const std::string& arm, ArmRole role, double rmse, std::vector<std::string> limits = {}) {
  Point point;
  point.arm = arm;
  point.role = role;
  point.values["rmse"] = {{"whole", rmse}, {"inner", rmse / 2}, {"outer", rmse}};
  point.limits = std::move(limits);
  point.command = "strobe render x";
  return point;
}

// Contrast 0.5, floor 0.01: one method that is always good, one that is always bad, and one that is good in a range.
Results made() {
  Results results;
  results.strobe = "0", results.title = "A <report>", results.note = "A note.", results.command = "strobe sweep x.lua";
  results.device = "device", results.driver = "driver", results.software = true;
  results.width = 64, results.height = 36;
  results.regions = regionNames(), results.measures = {"rmse"};
  for (const char* name : {"good", "bad", "mixed"}) results.arms.push_back({{name, "none"}});
  results.arms.push_back({{"floor", "ground_truth"}, ArmRole::floor});
  results.arms.push_back({{"truth", "ground_truth"}, ArmRole::truth});
  results.shots.push_back({"shot", "A shot", "", "", "", 24, 0.5, {{1, 2, 3, 4}}, {}});
  AxisSummary axis{"speed", "Speed", "px", "log", "whole", "All else stays.", "", "", true, 2, {}, {}};
  for (double value : {1.0, 3.0, 10.0, 30.0, 100.0}) {
    axis.values.push_back(value);
    axis.labels.push_back(fmt::format("{:g}", value));
    PointGroup group{"shot", "end", {{"speed", value}}, {of("truth", ArmRole::truth, 0)}};
    group.points[0].key = "truth", group.points[0].command += " --set speed=" + axis.labels.back();
    group.points[0].values["contrast"]["all"] = 0.5;
    group.points[0].values["change"]["all"] = group.points[0].values["changed"]["all"] = 1e-6 * value;
    group.points.push_back(of("good", ArmRole::method, 0.015));
    group.points.push_back(of("bad", ArmRole::method, value == 100 ? 0.3 : 0.1));
    bool limited = value >= 30;
    group.points.push_back(of("mixed", ArmRole::method, value == 1 ? 0.05 : 0.01,
                              limited ? std::vector<std::string>{"blur: 7 pixels"} : std::vector<std::string>()));
    group.points.push_back(of("floor", ArmRole::floor, 0.01));
    results.groups.push_back(group);
  }
  results.axes = {axis};
  results.layout = layoutFrom({{"curves", {{"factor", 2}}}});
  return results;
}

Curve curveOf(const Results& results) { return Curve(results, results.axes[0], 2); }

TEST(Curves, TrustEndsAtErrorsAndLimits) {
  Results results = made();
  Curve curve = curveOf(results);
  EXPECT_EQ(curve.trusted("good", Against::floor).count, 5u);
  EXPECT_EQ(curve.trusted("bad", Against::floor).count, 0u) << "ten times the floor";
  Trusted usual = curve.trusted("bad", Against::own);
  EXPECT_EQ(usual.first, 0u);
  EXPECT_EQ(usual.count, 4u);
  EXPECT_EQ(usual.above, Doubt::error);
  Trusted mixed = curve.trusted("mixed", Against::floor);
  EXPECT_EQ(mixed.first, 1u);
  EXPECT_EQ(mixed.count, 2u);
  EXPECT_EQ(mixed.below, Doubt::error);
  EXPECT_EQ(mixed.above, Doubt::limit);
  EXPECT_EQ(curve.range("mixed", Against::floor), "3 (error below) to 10 (limit above)");
  EXPECT_EQ(curve.range("good", Against::floor), "everywhere");
  EXPECT_EQ(curve.range("bad", Against::floor), "nowhere");
}

TEST(Curves, NonFinitePicturesAreNeverTrusted) {
  Results results = made();
  results.groups[3].points[1].values = {{"broken", {{"all", 12}}}};
  EXPECT_EQ(curveOf(results).trusted("good", Against::own).above, Doubt::broken);
  EXPECT_NE(Report(results, "").page().find("not finite"), std::string::npos);
}

// An error within the uncertainty of truth does not count.
TEST(Curves, ErrorsWithinTruthsUncertaintyAreAllowed) {
  Results results = made();
  for (PointGroup& group : results.groups) group.points[0].values["rmse"] = {{"whole", 0.03}};
  EXPECT_EQ(curveOf(results).trusted("bad", Against::floor).count, 4u) << "0.1 < 2 * 0.01 + 3 * 0.03";
}

TEST(Curves, ReadingsAreFilledIn) {
  Results results = made();
  Curve curve = curveOf(results);
  EXPECT_EQ(curve.filled("{good @ 30} of {floor @ 1}; {from mixed} to {to mixed}"), "3.00 % of 2.00 %; 3 to 10");
  for (const char* wrong : {"{god @ 30}", "{good @ 31}", "{good}"}) EXPECT_THROW(curve.filled(wrong), Error) << wrong;
}

// Times of two devices are never in the same table, figure or page section.
TEST(Results, TimesOfTwoDevicesAreGroupedByDevice) {
  Results results = made();
  results.measures = {"rmse", "ms"};
  results.layout = layoutFrom(
      {{"curves", {{"factor", 2}}}, {"front", {{"x", "ms"}, {"y", "rmse"}}}, {"table", {{"cells", {"rmse", "ms"}}}}});
  for (PointGroup& group : results.groups)
    for (Point& point : group.points) {
      if (point.role == ArmRole::truth) continue;
      point.times = "5 to 25 rounds", point.values["ms"]["all"] = 2;
    }
  EXPECT_EQ(results.timedDevices(), std::vector<std::string>{"device, driver"});
  EXPECT_EQ(Report(results, "").text().find("Times come from"), std::string::npos);
  EXPECT_EQ(csvOf(results).find("device"), std::string::npos);
  for (size_t g = 3; g < 5; ++g)
    for (Point& point : results.groups[g].points) point.device = "other", point.driver = "driver 2";
  const std::string text = Report(results, "").text();
  EXPECT_NE(text.find("Times come from 2 devices or drivers: device, driver; other, driver 2."), std::string::npos)
      << text;
  EXPECT_LT(text.find("On device, driver"), text.find("On other, driver 2"));
  const Results first = results.onDevice("device, driver"), second = results.onDevice("other, driver 2");
  EXPECT_EQ(first.groups.size() + second.groups.size(), results.groups.size());
  EXPECT_EQ(second.points(), 8u);
  EXPECT_EQ(second.timedDevices(), std::vector<std::string>{"other, driver 2"});
  EXPECT_NE(Report(results, "").page().find("On other, driver 2"), std::string::npos);
  std::set<std::string> names;
  for (const auto& [name, svg] : Report(results, "").figures()) EXPECT_TRUE(names.insert(name).second) << name;
  EXPECT_NE(csvOf(results).find(",device\n"), std::string::npos);
  EXPECT_NE(csvOf(results).find(",\"other, driver 2\"\n"), std::string::npos);
  EXPECT_EQ(toJson(resultsFrom(toJson(results), "x")).dump(), toJson(results).dump());
}

// An expectation that reads times of two devices does not apply. Other expectations are evaluated as usual.
TEST(Results, ExpectationsDoNotCompareTimesOfTwoDevices) {
  testing::TemporaryFolder folder;
  testing::writeText(folder / "x.lua", R"lua(
return require "strobe.experiment" {
  title = "Times", measures = { "rmse", "ms" }, truth = { pipeline = "ground_truth" },
  arms = { { name = "good", pipeline = "none" } }, shots = { { name = "bar", scene = "oracles/bar" } },
  expect = { { "fast", function(r) return r.at { arm = "good" }.ms < 3 end },
             { "good", function(r) return r.at { arm = "good" }.rmse < 1 end } },
})lua");
  Results results = made();
  for (PointGroup& group : results.groups)
    for (Point& point : group.points) point.times = "5 to 25 rounds", point.values["ms"]["all"] = 2;
  judgeResults(home(), results, folder / "x.lua");
  EXPECT_EQ(results.expectations[0].outcome, "holds") << results.expectations[0].detail;
  results.groups[1].points[1].device = "other";
  judgeResults(home(), results, folder / "x.lua");
  EXPECT_EQ(results.expectations[0].outcome, "does not apply");
  EXPECT_EQ(results.expectations[0].detail, "values of 'ms' come from several devices");
  EXPECT_EQ(results.expectations[1].outcome, "holds");
}

// A report fills gaps with points of other devices; a sweep draws these points again.
TEST(Results, PointsOfAnotherDeviceFillGapsOfAReport) {
  testing::TemporaryFolder folder;
  Store store(folder.path());
  Results results = made();
  results.groups.resize(1);
  PointGroup& group = results.groups[0];
  for (size_t i = 1; i < group.points.size(); ++i) {
    Point& point = group.points[i];
    point.key = fmt::format("{}_11111111", i), point.device = "device", point.driver = "driver";
    if (i == 1) store.keep(point.key, point);
    point.device = "other";
    if (i < 3) store.keep(fmt::format("{}_22222222", i), point);
    point.values.clear(), point.device.clear(), point.driver.clear();
  }
  Results strict = results;
  takePoints(strict, folder.path());
  EXPECT_EQ(strict.missing(), 3u);
  takePoints(results, folder.path(), true);
  EXPECT_EQ(results.missing(), 2u);
  EXPECT_EQ(group.points[1].device, "") << "the run's own device has priority";
  EXPECT_EQ(group.points[1].key, "1_11111111");
  EXPECT_EQ(results.deviceOf(group.points[2]), "other, driver");
  EXPECT_EQ(group.points[2].key, "2_22222222");
}

TEST(Results, RoundTripThroughDisk) {
  Results results = made();
  results.expectations = {{"it is good", "shot", "", "holds", "0.5", ""}};
  results.inputs = {{"strobe:shaders/x.glsl", "12"}};
  Json json = toJson(results);
  Results read = resultsFrom(Json::parse(json.dump()), "result.json");
  EXPECT_EQ(toJson(read).dump(), json.dump());
  EXPECT_EQ(Report(read, "").page(), Report(results, "").page());
  EXPECT_EQ(Report(read, "").markdown("x.html"), Report(results, "").markdown("x.html"));
  EXPECT_EQ(csvOf(read), csvOf(results));
  json.erase("groups");
  EXPECT_THROW(resultsFrom(json, "result.json"), Error);
}

TEST(Results, AreWrittenAsATable) {
  Results results = made();
  results.groups[0].points[0].values["rmse"] = {{"whole", 0.002}, {"inner", 0.001}};
  results.groups[0].points[1].preset = "best";
  results.groups[4].points[4].values.clear();
  std::istringstream csv(csvOf(results));
  std::string line;
  std::getline(csv, line);
  EXPECT_EQ(line, "point,arm,shot,region,speed,rmse,truth_error,pipeline,preset,note");
  std::getline(csv, line);
  EXPECT_EQ(line, "1,good,shot,whole,1,0.015,0.002,none,best,");
  std::getline(csv, line);
  EXPECT_EQ(line, "1,good,shot,inner,1,0.0075,0.001,none,best,");
  std::getline(csv, line);
  EXPECT_EQ(line, "1,good,shot,hidden,1,,,none,best,") << "a region without pixels";
  size_t lines = 3;
  for (std::string next; std::getline(csv, next); line = next) ++lines;
  EXPECT_TRUE(line.ends_with(",100,,,,,not drawn")) << line;
  EXPECT_EQ(lines, 5u * 4 * 7) << "5 values, 4 arms, 7 regions";
}

// An expectation that fails, or that holds although it is declared to fail, is named.
TEST(Results, ContradictionsAreNamed) {
  Results results = made();
  results.expectations = {{"first", "", "", "holds", "", ""},
                          {"second", "", "", "fails", "3 > 2", ""},
                          {"third", "", "", "fails", "", "the floor is too high"},
                          {"fourth", "", "", "holds", "", "the floor is too high"},
                          {"fifth", "", "", "does not apply", "", ""}};
  EXPECT_EQ(results.contradicted(),
            (std::vector<std::string>{"expectation fails: second (3 > 2)",
                                      "expectation holds; known to fail: the floor is too high: fourth"}));
}

// Damaged names and numbers used by the layout, and a file with any change.
TEST(Results, DamageIsRefused) {
  auto refusal = [](auto damage) -> std::string {
    Json json = toJson(made());
    damage(json);
    try {
      resultsFrom(json, "result.json");
    } catch (const Error& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_EQ(refusal([](Json&) {}), "");
  EXPECT_EQ(refusal([](Json& json) { json["measures"][0] = "rmsf"; }),
            "result.json: is not a result of an experiment, or is damaged: unknown measure 'rmsf'; the same sweep "
            "writes it again");
  for (const auto& [path, value] :
       std::vector<std::pair<std::string, Json>>{{"/size/0", 0},
                                                 {"/size/0", 1 << 20},
                                                 {"/groups/0/shot", "shit"},
                                                 {"/groups/1/points/1/arm", "god"},
                                                 {"/groups/0/at/speed", 2},
                                                 {"/axes/0/labels", {"1"}},
                                                 {"/axes/0/benign", 5},
                                                 {"/axes/0/values/0", "x"},
                                                 {"/shots/0/crops/0/0", 63},
                                                 {"/shots/0/crops/0/2", -1},
                                                 {"/layout", {{"front", {{"x", "rsme"}}}}},
                                                 {"/layout", {{"front", {{"x", 3}}}}},
                                                 {"/layout", {{"pictures", {{"crop_size", 3}}}}},
                                                 {"/arms", Json::array()},
                                                 {"/groups/0/points/0/role", "method"},
                                                 {"/groups/0/points", 3},
                                                 {"/device", "x"}}) {
    auto damage = [&path = path, &value = value](Json& json) { json[Json::json_pointer(path)] = value; };
    EXPECT_NE(refusal(damage).find("is damaged"), std::string::npos) << path << " = " << value;
    EXPECT_EQ(refusal(damage).find("json.exception"), std::string::npos) << path;
  }

  testing::TemporaryFolder folder;
  std::string text = textOf(made());
  testing::writeText(folder / "result.json", text);
  EXPECT_EQ(toJson(resultsIn(folder / "result.json")).dump(), toJson(made()).dump());
  text[text.find("0.015") + 4] = '6';
  testing::writeText(folder / "result.json", text);
  EXPECT_THROW(resultsIn(folder / "result.json"), Error) << "a changed number";
}

// A sweep may end at any time, and a point may be incomplete in many ways.
TEST(Report, ShowsAnyIncompletePoints) {
  std::mt19937 random(1);
  for (const char* layout :
       {R"({"curves": {"factor": 2}})", R"({"pictures": {}})", R"({"front": {"x": "rmse", "y": "rmse"}})",
        R"({"table": {"axes": ["speed"], "cells": ["rmse"], "once": ["rmse"], "share": true}})", "{}"})
    for (int i = 0; i < 8; ++i) {
      Results results = made();
      results.layout = layoutFrom(Json::parse(layout));
      for (PointGroup& group : results.groups)
        for (Point& point : group.points) {
          int fate = i < 2 ? 0 : int(random() % 4);
          if (i == 1 && &point == &results.groups[0].points[0]) continue;  // keep truth's point only
          if (fate < 3) point.values.clear();
          if (fate == 1) point.failed = "a reason";
          if (fate == 2) point.values["broken"]["all"] = 2;
        }
      results = resultsFrom(toJson(results), "made");
      Report report(results, "");
      const std::string text = report.text(), page = report.page(), csv = csvOf(results);
      EXPECT_EQ((text + report.markdown("x.html")).find("nan"), std::string::npos) << layout;
      EXPECT_EQ(text.find("Not drawn yet: ") != std::string::npos, !results.missingText().empty()) << layout;
      EXPECT_NE(page.find("</html>"), std::string::npos) << layout;
      EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 1 + 5 * 4 * 7) << layout;
      EXPECT_TRUE(csv.find(",note\n") != std::string::npos) << layout;
    }
}

// Truth is drawn first.
TEST(Report, ShowsTruthAlone) {
  testing::TemporaryFolder folder;
  image::ExrFile file;
  file.add("", {"R", "G", "B"}, image::Image(64, 36, 3, 0.5f));
  image::writeExr(folder / "truth.exr", file);
  Results results = made();
  results.layout = layoutFrom({{"pictures", Json::object()}});
  for (PointGroup& group : results.groups)
    for (Point& point : group.points) point.values.clear();
  Point& truth = results.groups[0].points[0];
  truth.values = of("truth", ArmRole::truth, 0).values;
  truth.measured = truth.shown = "truth.exr";
  Report report(results, folder.path());
  ASSERT_TRUE(report.hasSheet());
  EXPECT_GT(report.sheet().width, 64);
  EXPECT_NE(report.page().find("Not drawn yet: 20 of 20 points, 4 of 5 truths"), std::string::npos);

  truth.files["truth.exr"] = "of another picture";
  EXPECT_FALSE(Report(results, folder.path()).hasSheet());
}

TEST(Report, PageNeedsNoNetwork) {
  std::string page = Report(made(), "").page();
  for (const char* foreign : {"http:", "https:", "@import", "url(", " src="})
    EXPECT_EQ(page.find(foreign), std::string::npos) << foreign;
  for (const char* wanted :
       {"nowhere", "3 (error below) to 10 (limit above)", "everywhere", "strobe render x", "<svg", "A &lt;report&gt;"})
    EXPECT_NE(page.find(wanted), std::string::npos) << wanted;
}

TEST(Measures, HaveNamesUnitsAndWords) {
  for (const Measure& measure : measures()) {
    EXPECT_FALSE(measure.title.empty() || measure.doc.empty()) << measure.name;
    EXPECT_NE(measure.of_picture == nullptr, measure.of_times == nullptr) << measure.name << " has a wrong kind";
    EXPECT_EQ(&measureNamed(measure.name), &measure) << "name is not unique";
  }
}

// Values for pictures with non-finite pixels would be NaN, or would leave pixels out.
TEST(Measures, OfNonFiniteColoursHaveNoValue) {
  TruthPicture truth;
  truth.color = image::Image(4, 4, 3, 0.5f);
  truth.masks["whole"] = {};
  truth.sigma["whole"] = 0;
  lab::Picture picture;
  picture.record = Json::object();
  MeasureInput input;
  input.truth = &truth, input.picture = &picture, input.bytes = 64;
  input.color = image::Image(4, 4, 3, 0.25f);
  const std::vector<std::string> colours = {"rmse",           "mse",   "flip", "flip_max", "p999", "relmse",
                                            "relmse_trimmed", "smape", "psnr", "contrast"};
  std::vector<std::string> names = colours;
  names.insert(names.end(), {"broken", "pixels", "bytes"});
  Values sound = measured(input, names, {"whole"});
  for (const std::string& name : names)
    for (const auto& [region, value] : sound.at(name)) EXPECT_TRUE(std::isfinite(value)) << name;
  for (float bad : {std::numeric_limits<float>::quiet_NaN(), -std::numeric_limits<float>::infinity()}) {
    input.color.at(1, 2, 0) = input.color.at(1, 2, 1) = input.color.at(3, 3, 2) = bad;
    Values values = measured(input, names, {"whole"});
    EXPECT_EQ(values["broken"]["all"], 2) << "counts pixels, not values";
    EXPECT_EQ(values["pixels"]["whole"], 16);
    EXPECT_EQ(values["bytes"]["all"], 4);
    for (const std::string& name : colours)
      for (const auto& [region, value] : values[name]) EXPECT_TRUE(std::isnan(value)) << name;
  }
}

// The output `error` is compared with the error of each pixel of the region.
TEST(Measures, EstimatedErrorIsComparedWithTheError) {
  TruthPicture truth;
  truth.color = image::Image(3, 1, 3, 0.5f);
  truth.masks["whole"] = {};
  truth.masks["moving"] = image::Image(3, 1, 1, 1.0f);
  truth.masks["moving"].at(2, 0, 0) = 0;
  lab::Picture picture;
  MeasureInput input;
  input.truth = &truth, input.picture = &picture;
  input.color = truth.color;
  for (int c = 0; c < 3; ++c) input.color.at(0, 0, c) = 0.75f, input.color.at(1, 0, c) = 0.375f;
  const std::vector<std::string> names = {"error_mean", "error_estimate", "estimate_rank"};
  Values without = measured(input, names, {"whole"});
  EXPECT_NEAR(without["error_mean"]["whole"], 0.125, 1e-7);
  EXPECT_EQ(without.count("error_estimate") + without.count("estimate_rank"), 0u) << "no output `error`";

  image::Image estimate(3, 1, 1);
  estimate.at(0, 0, 0) = 0.25f, estimate.at(1, 0, 0) = 0.5f, estimate.at(2, 0, 0) = 3.0f;
  picture.frame.outputs["error"].floats = estimate;
  Values values = measured(input, names, {"whole", "moving"});
  EXPECT_NEAR(values["error_mean"]["moving"], 0.1875, 1e-7);
  EXPECT_NEAR(values["error_estimate"]["moving"], 0.375, 1e-7);
  EXPECT_NEAR(values["error_estimate"]["whole"], 1.25, 1e-6);
  EXPECT_NEAR(values["estimate_rank"]["moving"], -1, 1e-12);
}

// ---- Shipped results

Results committed(const std::string& question) {
  Path file = home().shipped() / "experiments" / question / "result.json";
  return resultsFrom(Json::parse(readText(file)), file.string());
}

// Every experiment in experiments/ with a result.
std::vector<std::string> answered() {
  std::vector<std::string> questions;
  for (const auto& entry : std::filesystem::directory_iterator(home().shipped() / "experiments"))
    if (exists(entry.path() / "result.md")) questions.push_back(entry.path().filename().string());
  std::sort(questions.begin(), questions.end());
  return questions;
}

class Committed : public ::testing::TestWithParam<std::string> {};

TEST_P(Committed, PagesMatchTheirNumbers) {
  Path folder = home().shipped() / "experiments" / GetParam();
  Results results = committed(GetParam());
  Report report(results, folder);
  EXPECT_EQ(readText(folder / "result.md"), report.markdown("report.html"));
  EXPECT_EQ(readText(folder / "report.html"), report.page());
  for (const auto& [name, svg] : report.figures()) EXPECT_EQ(readText(folder / name), svg) << name;
  EXPECT_LT(readText(folder / "report.html").size(), 1'500'000u);
  EXPECT_EQ(readText(folder / "table.csv"), csvOf(results));
}

// Kitchen, mug, whole picture: 0.01838 and 0.01816 are closer than two standard errors of truth. Living room, outer:
// 0.02106 and 0.01099, with a standard error of truth of 0.00280.
TEST(Ranking, MethodsWithinTruthsUncertaintyAreNotRanked) {
  std::string text = Report(committed("real_scenes"), home().shipped() / "experiments/real_scenes").markdown("");
  EXPECT_NE(text.find("| 0.01838? |"), std::string::npos);
  EXPECT_NE(text.find("| 0.01816? |"), std::string::npos);
  EXPECT_EQ(text.find("**0.01816**"), std::string::npos);
  EXPECT_NE(text.find("| **0.01098** |"), std::string::npos);
}

// Texts, expectations and outcomes match the current experiment file.
TEST_P(Committed, NumbersMatchTheCurrentExperiment) {
  Results results = committed(GetParam());
  std::string file = (home().shipped() / "experiments" / GetParam() / (GetParam() + ".lua")).string();
  Experiment experiment = readExperiment(home(), file, false);
  Results again = results;
  relabel(home(), again, experiment);
  EXPECT_EQ(toJson(again).dump(), toJson(results).dump());
  EXPECT_EQ(results.contradicted(), std::vector<std::string>());
  EXPECT_EQ(results.width, experiment.width);
  ASSERT_EQ(results.groups.size(), experiment.groups.size());
  for (size_t g = 0; g < results.groups.size(); ++g) {
    const PointGroup& group = results.groups[g];
    EXPECT_EQ(group.shot, experiment.shots[experiment.groups[g].shot].name);
    ASSERT_EQ(group.points.size(), experiment.groups[g].arms.size() + 1);
    for (size_t i = 1; i < group.points.size(); ++i) {
      const StudiedArm& arm = experiment.arms[experiment.groups[g].arms[i - 1]];
      EXPECT_EQ(group.points[i].arm, arm.name);
      if (group.points[i].command.empty()) continue;
      lab::Shot shot = shotOf(experiment, experiment.groups[g], arm);
      // Scenes beside the experiment are named relative to the root of the clone.
      std::string root = home().shipped().string() + "/";
      if (shot.scene.starts_with(root)) shot.scene = shot.scene.substr(root.size());
      EXPECT_EQ(group.points[i].command, commandOf(experiment.shots[experiment.groups[g].shot], shot));
    }
  }
}

// The page states each expectation, its outcome and its numbers, and the list of experiments has a line for it.
TEST_P(Committed, PagesStateEveryExpectation) {
  std::string text = readText(home().shipped() / "experiments" / GetParam() / "result.md");
  for (const Expectation& expectation : committed(GetParam()).expectations) {
    if (expectation.outcome == "does not apply") continue;
    std::string stated = "Expected: " + expectation.text + ". This " + expectation.outcome;
    EXPECT_NE(text.find(stated), std::string::npos) << stated;
    EXPECT_NE(text.find(expectation.detail), std::string::npos) << expectation.detail;
  }
  EXPECT_NE(readText(home().shipped() / "experiments/README.md").find("(" + GetParam() + "/result.md)"),
            std::string::npos);
}

INSTANTIATE_TEST_SUITE_P(Questions, Committed, ::testing::ValuesIn(answered()));

}  // namespace results_test
}  // namespace strobe::study
