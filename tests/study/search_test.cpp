// SPDX-License-Identifier: MIT
// The search on functions with a known optimum; no pictures are drawn.
#include "study/search.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "base/home.h"
#include "script/evaluate.h"

namespace strobe::study {
namespace search_test {

using Type = plan::ParamDesc::Type;

plan::ParamDesc number(const std::string& name, Type type, double min, double max) {
  plan::ParamDesc param;
  param.name = name, param.type = type, param.min = min, param.max = max;
  return param;
}

plan::ParamDesc choice(const std::string& name, const std::vector<std::string>& choices) {
  plan::ParamDesc param;
  param.name = name, param.type = Type::Choice, param.choices = choices;
  return param;
}

plan::ParamDesc flag(const std::string& name) {
  plan::ParamDesc param;
  param.name = name, param.type = Type::Bool;
  return param;
}

double of(const plan::Value& value) {
  const auto* whole = std::get_if<int64_t>(&value);
  return whole ? double(*whole) : std::get<double>(value);
}

// A method with samples that have a cost, a width with optimum 0.3, a kind that matters, a flag that doubles the cost
// without a benefit, and a number without an effect.
const Space kSpace = {{number("samples", Type::Int, 1, 1024), int64_t(16)},
                      {number("width", Type::Float, 1e-3, 10), 0.1},
                      {choice("kind", {"plain", "good", "better"}), "plain"},
                      {flag("slow"), true},
                      {number("idle", Type::Int, 0, 9), int64_t(0)}};

Score scoreOf(const Spot& spot) {
  double samples = of(spot[0]), aside = std::log2(of(spot[1]) / 0.3);
  std::string kind = std::get<std::string>(spot[2]);
  double error = (1 / samples + 0.02 * aside * aside) * (kind == "plain" ? 3 : kind == "good" ? 2 : 1);
  double cost = (2 + samples) * (std::get<bool>(spot[3]) ? 2 : 1) * (kind == "better" ? 1.5 : 1);
  return {true, error, cost};
}

std::vector<Spot> starts(const Space& space, int count) {
  Home home = Home::fromEnvironment();
  Json points = script::evaluateData(home, home.at("scripts/tune/starts.lua").string(),
                                     {{"count", count}, {"width", space.size()}});
  std::vector<Spot> result = {startOf(space)};
  for (const Json& point : points) result.push_back(spotAt(space, result[0], point.get<std::vector<double>>()));
  return result;
}

struct Counted {
  std::vector<int> by_level = std::vector<int>(3);
  std::set<std::string> measured;
};

// Identity of a setting: all values except the number without an effect. The flag is refused together with "good".
std::string identityOf(const Spot& spot) {
  if (std::get<bool>(spot[3]) && spot[2] == plan::Value("good")) return "";
  std::string text;
  for (size_t d = 0; d < 4; ++d) text += plan::textOf(spot[d]) + " ";
  return text;
}

Search searched(const Goal& goal, int evaluations, Counted& counted) {
  auto measure = [&](const std::vector<Spot>& spots, int level) {
    std::vector<Score> scores;
    for (const Spot& spot : spots) {
      ++counted.by_level[size_t(level)];
      EXPECT_TRUE(counted.measured.insert(fmt::format("{} {}", level, identityOf(spot))).second) << "measured twice";
      scores.push_back(scoreOf(spot));
      if (level == 0) scores.back().error *= 1 + 0.2 * std::sin(scores.back().cost);  // cheap measurements are inexact
    }
    return scores;
  };
  Search search(kSpace, goal, {evaluations, 3, 3}, identityOf, measure);
  search.run(starts(kSpace, 200));
  return search;
}

TEST(Searching, FindsTheSmallestErrorWithinACost) {
  Counted counted;
  Goal goal{Goal::Kind::least_error, 99};
  Search search = searched(goal, 150, counted);
  const Search::Found& best = search.best().value();
  EXPECT_EQ(std::get<std::string>(best.spot[2]), "better");
  EXPECT_FALSE(std::get<bool>(best.spot[3]));
  EXPECT_LE(best.score.cost, 99);
  EXPECT_GE(of(best.spot[0]), 45) << "at most 64 samples fit the budget";
  EXPECT_NEAR(std::log2(of(best.spot[1]) / 0.3), 0, 0.3);
  EXPECT_EQ(best.spot[4], kSpace[4].start) << "a parameter without an effect is unchanged";
  EXPECT_TRUE(search.finished());
}

TEST(Searching, FindsTheSmallestCostWithinAnError) {
  Counted counted;
  Search search = searched({Goal::Kind::least_cost, 0.1}, 150, counted);
  const Search::Found& best = search.best().value();
  EXPECT_LE(best.score.error, 0.1);
  EXPECT_LE(best.score.cost, 1.15 * 1.5 * 13) << "11 samples of the better kind at the right width need a cost of 19.5";
}

TEST(Searching, StaysWithinItsEvaluations) {
  Counted counted;
  Search search = searched({Goal::Kind::least_error, 99}, 60, counted);
  EXPECT_LE(search.evaluations(), 60);
  EXPECT_EQ(counted.by_level[0] + counted.by_level[1] + counted.by_level[2], search.evaluations());
  EXPECT_EQ(counted.by_level[0], 13) << "1 + 1/3 + 1/9 evaluations per candidate, within a third of the budget";
  EXPECT_GE(counted.by_level[1], 5);
  EXPECT_LE(counted.by_level[1], 6) << "a third, and the base of comparisons";
  Counted again;
  Search same = searched({Goal::Kind::least_error, 99}, 60, again);
  EXPECT_EQ(same.best()->spot, search.best()->spot);
  EXPECT_EQ(again.measured, counted.measured);
}

TEST(Searching, FindsNothingWithoutMeasurements) {
  auto none = [](const std::vector<Spot>& spots, int) { return std::vector<Score>(spots.size()); };
  Search search(kSpace, {}, {20, 3, 3}, identityOf, none);
  search.run({startOf(kSpace)});
  EXPECT_FALSE(search.best());
  Search refused(
      kSpace, {}, {20, 3, 3}, [](const Spot&) { return ""; }, none);
  refused.run({startOf(kSpace)});
  EXPECT_EQ(refused.evaluations(), 0);
}

TEST(Searching, UsesValuesOfTheRange) {
  std::vector<plan::Value> next = neighboursOf(kSpace[0].param, int64_t(1), 1);
  EXPECT_EQ(next, (std::vector<plan::Value>{int64_t(2)}));
  EXPECT_EQ(neighboursOf(kSpace[0].param, int64_t(2), 0.5), (std::vector<plan::Value>{int64_t(1), int64_t(3)}));
  EXPECT_EQ(neighboursOf(kSpace[4].param, int64_t(0), 1), (std::vector<plan::Value>{int64_t(1)}));
  EXPECT_EQ(neighboursOf(kSpace[1].param, 0.3, 0.5), (std::vector<plan::Value>{0.212, 0.424}));
  EXPECT_EQ(neighboursOf(kSpace[1].param, 10.0, 1), (std::vector<plan::Value>{5.0}));
  EXPECT_EQ(neighboursOf(kSpace[2].param, "good", 1), (std::vector<plan::Value>{"plain", "better"}));
  EXPECT_EQ(neighboursOf(kSpace[3].param, true, 1), (std::vector<plan::Value>{false}));
  std::set<std::string> kinds;
  int changed = 0;
  std::vector<Spot> all = starts(kSpace, 64);
  for (const Spot& spot : all) {
    for (size_t d = 0; d < kSpace.size(); ++d) EXPECT_NO_THROW(plan::checkValue(kSpace[d].param, spot[d], {}));
    kinds.insert(std::get<std::string>(spot[2]));
    changed += spot[2] != kSpace[2].start;
    EXPECT_GE(of(spot[0]), 2) << "three octaves below 16";
    EXPECT_LE(of(spot[0]), 128);
  }
  EXPECT_EQ(kinds.size(), 3u);
  EXPECT_NEAR(changed, 32, 2) << "half of the starts";
}

}  // namespace search_test
}  // namespace strobe::study
