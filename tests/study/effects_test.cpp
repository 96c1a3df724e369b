// SPDX-License-Identifier: MIT
// Front, effects and intervals of results match NumPy and SciPy on the same table.csv.
#include "study/effects.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "common/home.h"
#include "common/source.h"
#include "math/statistics.h"
#include "program/run.h"

namespace strobe::study {
namespace effects_test {

struct Made {
  Results results;
  std::mt19937 random{7};

  double noise() { return std::uniform_real_distribution<double>(0.9, 1.1)(random); }

  void axis(const std::string& name, const std::vector<double>& values) {
    AxisSummary axis;
    axis.name = axis.title = name;
    for (double value : values) axis.values.push_back(value), axis.labels.push_back(fmt::format("{:g}", value));
    results.axes.push_back(axis);
  }
  void group(const std::string& shot, std::vector<std::pair<std::string, Json>> at, double error) {
    PointGroup group{shot, "end", std::move(at), {}};
    for (const ArmSummary& arm : results.arms) {
      Point point;
      point.arm = arm.name, point.role = arm.role;
      bool is_a = arm.name == "a, first";  // the table quotes the comma
      point.values["rmse"] = {{"whole", error * (is_a ? 1 : 2) * noise()}, {"inner", error * noise()}};
      point.values["ms"] = {{"all", (is_a ? 3 : 2) / error * noise()}};
      if (arm.role == ArmRole::truth) group.points.insert(group.points.begin(), point);
      else group.points.push_back(point);
    }
    results.groups.push_back(group);
  }
};

Made empty() {
  Made made;
  made.results.title = "x", made.results.width = 64, made.results.height = 36;
  made.results.regions = {"whole", "inner"}, made.results.measures = {"rmse", "ms"};
  made.results.arms = {{{"a, first", "none"}}, {{"b", "none"}}, {{"truth", "ground_truth"}, ArmRole::truth}};
  return made;
}

// Results with the numbers as rounded in the file.
Results rounded(const Results& results) { return resultsFrom(toJson(results), "made"); }

// Two shots, two arms, four sample counts, three tile sizes; some points are missing.
Results crossed() {
  Made made = empty();
  made.results.shots = {{"near"}, {"far"}};
  made.axis("samples", {4, 8, 16, 32});
  made.axis("tile", {10, 20, 40});
  for (const char* shot : {"near", "far"})
    for (double samples : {4, 8, 16, 32})
      for (double tile : {10, 20, 40})
        made.group(shot, {{"samples", samples}, {"tile", tile}}, 1 / samples + tile / 500);
  made.results.groups[3].points[1].values.clear();
  made.results.groups[20].points.pop_back();
  return rounded(made.results);
}

// Points of a design without repeated values.
Results scattered() {
  Made made = empty();
  made.results.shots = {{"near"}};
  std::vector<double> radius, bias;
  for (int i = 0; i < 16; ++i) radius.push_back(0.5 + i * 0.7), bias.push_back(1 + 0.01 * ((i * 7) % 16));
  made.axis("radius", radius);
  made.axis("bias", bias);
  for (size_t i = 0; i < 16; ++i)
    made.group("near", {{"radius", radius[i]}, {"bias", bias[i]}}, 0.1 * radius[i] + bias[i]);
  return rounded(made.results);
}

std::optional<Json> reference(const Results& results, const std::string& measure, const std::string& region) {
  testing::TemporaryFolder folder;
  writeFileAtomically(folder / "table.csv", csvOf(results));
  Path script = sourceFolder() / "tests/study/effects_reference.py";
  for (const char* python : {"python3", "/usr/bin/python3"}) {
    testing::Outcome outcome = testing::runLine(
        fmt::format("{} '{}' '{}' {} ms {}", python, script.string(), folder / "table.csv", measure, region));
    if (outcome.exit_code == 0) return Json::parse(outcome.out);
    if (outcome.err.find("ModuleNotFoundError") == std::string::npos) ADD_FAILURE() << outcome.err;
  }
  return std::nullopt;
}

void expectSame(const Estimate& found, const Json& wanted, const std::string& where) {
  double values[] = {found.value, found.low, found.high};
  for (size_t i = 0; i < 3; ++i) {
    if (wanted[i].is_null()) EXPECT_TRUE(std::isnan(values[i])) << where;
    else EXPECT_NEAR(values[i], wanted[i].get<double>(), 1e-10) << where << " " << i;  // quantiles of SciPy 1.10
  }
}

void expectSame(const Effects& effects, const Json& wanted) {
  ASSERT_EQ(effects.main.size(), wanted["main"].size());
  for (const FactorEffect& one : effects.main) {
    const Factor& factor = effects.factors[one.factor];
    const Json& main = wanted["main"][factor.name];
    EXPECT_EQ(one.comparison == LevelComparison::paired, main["blocks"] > 0) << factor.name;
    if (one.comparison == LevelComparison::slope) {
      EXPECT_EQ(one.doubling, wanted["slopes"][factor.name]["doubling"]);
      expectSame(one.slope, wanted["slopes"][factor.name]["slope"], factor.name);
      continue;
    }
    EXPECT_EQ(one.effect.blocks, main["blocks"]) << factor.name;
    EXPECT_EQ(one.effect.incomplete, main["incomplete"]) << factor.name;
    for (size_t level = 0; level < factor.levels(); ++level)
      expectSame(one.effect.levels[level], main["levels"].at(factor.labels[level]), factor.name);
  }
  size_t complete = 0;
  for (const auto& [name, pair] : wanted["pairs"].items()) complete += pair["blocks"] > 0;
  EXPECT_EQ(effects.pairs.size(), complete);
  for (const PairEffect& one : effects.pairs) {
    const Factor &first = effects.factors[one.first], &second = effects.factors[one.second];
    const Json& pair = wanted["pairs"].at(first.name + "/" + second.name);
    EXPECT_EQ(one.interaction.blocks, pair["blocks"]);
    EXPECT_EQ(one.interaction.incomplete, pair["incomplete"]);
    for (size_t a = 0; a < first.levels(); ++a)
      for (size_t b = 0; b < second.levels(); ++b)
        expectSame(one.interaction.levels[a * second.levels() + b],
                   pair["cells"].at(first.labels[a] + "," + second.labels[b]), first.name);
  }
}

// Numbers of the front's points in table.csv.
std::vector<size_t> frontOf(const Results& results, const std::string& measure, const std::string& region) {
  std::vector<std::pair<double, double>> costs;
  for (const PointGroup& group : results.groups)
    for (const Point& point : group.points)
      if (point.role != ArmRole::truth) costs.emplace_back(point.value("ms"), point.value(measure, region));
  std::vector<size_t> front = paretoFront(costs);
  for (size_t& one : front) ++one;
  std::sort(front.begin(), front.end());
  return front;
}

void compare(const Results& results) {
  for (const char* region : {"whole", "inner"}) {
    std::optional<Json> wanted = reference(results, "rmse", region);
    if (!wanted) GTEST_SKIP() << "no Python with NumPy and SciPy (python3-scipy)";
    expectSame(effectsOf(results, "", "rmse", region), *wanted);
    EXPECT_EQ(Json(frontOf(results, "rmse", region)), (*wanted)["front"]);
  }
}

TEST(EffectsOfResults, CrossedMatchScipy) { compare(crossed()); }
TEST(EffectsOfResults, ScatteredMatchScipy) { compare(scattered()); }

TEST(EffectsOfResults, OfShippedResultsMatchScipy) {
  Path file = home().shipped() / "experiments/samples/result.json";
  Results results = resultsFrom(Json::parse(readText(file)), file.string());
  compare(results);
  Effects effects = effectsOf(results, "vase", "rmse", "inner");
  EXPECT_EQ(effects.points, 60u);
  EXPECT_EQ(effects.factors.size(), 3u);
  EXPECT_EQ(effects.pairs.size(), 3u);
}

TEST(EffectsOfResults, OneShotHasNoFactorShot) {
  Effects both = effectsOf(crossed(), "", "rmse", "inner"), far = effectsOf(crossed(), "far", "rmse", "inner");
  EXPECT_EQ(both.factors[1].name, "shot");
  EXPECT_EQ(far.factors[1].name, "samples") << "one shot does not vary";
  EXPECT_LT(far.points, both.points);
}

}  // namespace effects_test
}  // namespace strobe::study
