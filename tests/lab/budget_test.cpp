// SPDX-License-Identifier: MIT
// The search for the highest value within a time budget, with given cost functions.
#include "lab/budget.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>
#include <utility>

#include "base/error.h"

namespace strobe::lab {
namespace budget_test {

using Cost = std::function<double(double value)>;  // milliseconds of a frame

// Cost from 10 to 320 ms; doubles with each fifth of the range.
double doubling(double value) { return 10 * std::exp2(5 * value); }

// Highest value with a cost of at most `budget_ms`, for increasing costs; the lowest value if all cost more.
double highestWithin(double budget_ms, const Cost& cost) {
  for (int step = Budget::kSteps; step > 0; --step)
    if (cost(step / 20.0) <= budget_ms) return step / 20.0;
  return 0;
}

class Frames {
 public:
  explicit Frames(double noise = 0) : noise_(noise) {}

  // Draws frames; returns the number of changes of the value. The first frame of each value costs `spoilt` times as
  // much.
  int draw(Budget& budget, int count, const Cost& cost, double spoilt = 3) {
    int changes = 0;
    for (int i = 0; i < count; ++i) {
      double factor = std::exp(noise_ * normal_(random_));
      if (std::exchange(is_new_, false)) factor *= spoilt;
      const double before = budget.value();
      const bool changed = budget.add(factor * cost(budget.value()));
      EXPECT_EQ(changed, before != budget.value());
      EXPECT_LE(std::abs(budget.value() - before), 0.25 + 1e-9) << "the change per frame is bounded";
      EXPECT_GE(budget.value(), 0);
      EXPECT_LE(budget.value(), 1);
      changes += changed, is_new_ = changed;
    }
    return changes;
  }

 private:
  double noise_;
  bool is_new_ = true;
  std::mt19937 random_{7};
  std::normal_distribution<double> normal_;
};

constexpr int kSearch = 45;  // upper bound on the frames of a search
constexpr int kLong = 2000;  // frames after the search, without a change

// With exact costs, the value is the highest within the budget, or its cost is close enough to the budget to stay.
void expectBest(const Budget& budget, const Cost& cost) {
  const double best = highestWithin(budget.ms(), cost);
  const bool is_near = cost(budget.value()) >= Budget::kSpare * budget.ms() && cost(budget.value()) <= budget.ms();
  EXPECT_TRUE(budget.value() == best || is_near) << budget.ms() << " ms: " << budget.value() << ", best " << best;
}

TEST(Budget, FindsTheHighestValueWithinIt) {
  for (double ms : {9.0, 10.0, 15.0, 33.0, 100.0, 200.0, 319.0, 330.0})
    for (double start : {0.0, 0.4, 1.0}) {
      Budget budget(ms, 0, 1, start);
      Frames frames;
      EXPECT_LE(frames.draw(budget, kSearch, doubling), 9);
      EXPECT_TRUE(budget.isSettled());
      expectBest(budget, doubling);
      EXPECT_EQ(budget.isMet(), ms >= 10);
      EXPECT_EQ(frames.draw(budget, kLong, doubling), 0);
    }
}

// With noise the value may end a step too low, because a median above the budget counts; it does not oscillate.
TEST(Budget, DoesNotOscillateUnderNoise) {
  for (double noise : {0.03, 0.1, 0.2})
    for (double ms : {15.0, 33.0, 60.0, 100.0, 200.0}) {
      Budget budget(ms, 0, 1, 0.4);
      Frames frames(noise);
      frames.draw(budget, kSearch, doubling);
      EXPECT_LE(doubling(budget.value()), (1 + noise) * ms);
      EXPECT_GE(doubling(budget.value() + 0.15), Budget::kSpare * ms);
      EXPECT_LE(frames.draw(budget, kLong, doubling), noise < 0.2 ? 4 : 12) << noise << ", " << ms;
      EXPECT_LE(doubling(budget.value()), (1 + noise) * ms);
      EXPECT_GE(doubling(budget.value() + 0.2), Budget::kSpare * ms);
    }
}

TEST(Budget, StopsBelowAJumpInCost) {
  auto steps = [](double value) { return value < 0.05 ? 1.0 : value < 0.5 ? 20.0 : value < 0.75 ? 40.0 : 500.0; };
  for (const auto& [ms, expected] : {std::pair(30.0, 0.45), std::pair(100.0, 0.7), std::pair(10.0, 0.0)}) {
    Budget budget(ms, 0, 1, 0.4);
    Frames frames;
    frames.draw(budget, kSearch + 15, steps);
    EXPECT_EQ(budget.value(), expected) << ms;
    EXPECT_EQ(frames.draw(budget, kLong, steps), 0);
  }
}

TEST(Budget, FollowsAChangeOfTheScene) {
  Budget budget(60, 0, 1, 0.4);
  Frames frames(0.03);
  frames.draw(budget, kSearch, doubling);
  for (double factor : {2.0, 1.0, 5.0, 0.25, 1.0}) {
    auto cost = [factor](double value) { return factor * doubling(value); };
    frames.draw(budget, kSearch + 15, cost);
    EXPECT_LE(cost(budget.value()), 1.05 * 60) << factor;
    EXPECT_GE(budget.value(), highestWithin(60, cost) - 0.1) << factor;
    EXPECT_LE(frames.draw(budget, 300, cost), 2) << factor;
  }
}

// A cost that increases gradually, as in an animation.
TEST(Budget, FollowsADrift) {
  Budget budget(60, 0, 1, 0.4);
  Frames frames(0.03);
  double factor = 1;
  auto cost = [&](double value) { return factor * doubling(value); };
  frames.draw(budget, kSearch, cost);
  for (double ratio : {1.003, 1 / 1.003}) {
    int over = 0;
    for (int i = 0; i < 500; ++i, factor *= ratio) {
      frames.draw(budget, 1, cost);
      over += cost(budget.value()) > 1.1 * 60;
    }
    EXPECT_LE(over, 50);
    EXPECT_GE(budget.value(), highestWithin(60, cost) - 0.15);
  }
}

TEST(Budget, EndsIfCostDoesNotDependOnTheValue) {
  Budget cheap(60, 0, 1, 0.4), dear(5, 0, 1, 0.4);
  Frames frames(0.1);
  auto constant = [](double) { return 20.0; };
  frames.draw(cheap, kSearch, constant), frames.draw(dear, kSearch, constant);
  EXPECT_EQ(cheap.value(), 1);
  EXPECT_TRUE(cheap.isMet());
  EXPECT_EQ(dear.value(), 0);
  EXPECT_FALSE(dear.isMet());
  EXPECT_EQ(frames.draw(cheap, kLong, constant) + frames.draw(dear, kLong, constant), 0);
}

TEST(Budget, IgnoresOneSlowFrameAndUnknownTimes) {
  Budget budget(60, 0, 1, 0.4);
  Frames frames;
  frames.draw(budget, kSearch, doubling);
  const double value = budget.value();
  for (double ms : {500.0, std::nan(""), 0.0, 500.0})
    for (int i = 0; i < 5; ++i) EXPECT_FALSE(budget.add(i == 0 ? ms : doubling(value)));
}

// Costs in any order: the search ends at a value within the budget or at the lowest value.
TEST(Budget, EndsOnAnyCosts) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> exponent(0, 5);
  for (int i = 0; i < 300; ++i) {
    std::array<double, Budget::kSteps + 1> costs;
    for (double& cost : costs) cost = 10 * std::exp2(exponent(random));
    auto cost = [&](double value) { return costs[size_t(std::lround(20 * value))]; };
    Budget budget(60, 0, 1, 0.4);
    Frames frames;
    frames.draw(budget, 150, cost);
    EXPECT_TRUE(budget.isMet() || budget.value() == 0);
    EXPECT_EQ(frames.draw(budget, 500, cost), 0);
  }
}

TEST(Budget, ValuesAreShortAndInRange) {
  EXPECT_EQ(Budget(1, 0, 1, 0.33).value(), 0.35) << "rounded to the next of twenty steps";
  EXPECT_EQ(Budget(1, 0, 1, 0.15).value(), 0.15);
  EXPECT_EQ(Budget(1, -2, 1e6, 7).value(), -2);
  EXPECT_EQ(Budget(1, 3, 3, 3).value(), 3);
  EXPECT_EQ(Budget(1, 0, 0.3, 9).value(), 0.3);
}

TEST(Budget, UsesTheParameterWithTheRole) {
  plan::PipelineDesc pipeline;
  pipeline.name = "p";
  try {
    budgetOf(pipeline, 5);
    FAIL();
  } catch (const Error& error) {
    EXPECT_STREQ(error.what(), "--budget-ms needs a parameter with the role 'quality', which 'p' does not have");
    EXPECT_EQ(error.exitCode(), 2);
  }
  plan::ParamDesc param;
  param.name = "effort", param.role = plan::Role::Quality, param.min = 0, param.max = 40;
  pipeline.params = {param};
  pipeline.values = {{"effort", 13.0}};
  EXPECT_EQ(budgetedParam(pipeline).name, "effort");
  EXPECT_EQ(budgetOf(pipeline, 5).value(), 14);
}

}  // namespace budget_test
}  // namespace strobe::lab
