// SPDX-License-Identifier: MIT
// Search for the best setting of some parameters, in three phases: starts that fill the space; successive halving
// (Jamieson and Talwalkar 2016) over levels, each more precise and more costly than the level before; coordinate steps
// from the unchanged setting, from the best start and from the best of all.
// The search does not depend on pictures: the caller measures settings. Equal measurements lead to the same search.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "plan/description.h"

namespace strobe::study {

// Varied parameter and its start value.
struct Dimension {
  plan::ParamDesc param;
  plan::Value start;
};
using Space = std::vector<Dimension>;

// Setting: a value for each dimension.
using Spot = std::vector<plan::Value>;

// Start values of all dimensions.
Spot startOf(const Space& space);

// Setting around `centre` at a point of the unit cube. A number moves by up to three octaves, mostly less; by up to
// half the range if the number is not above 0 or the range contains negative values. About four of the other parameters
// change their value.
Spot spotAt(const Space& space, const Spot& centre, const std::vector<double>& point);

// Neighbours of a value: every other choice; for a number, one step up and one step down of `step` octaves (or `step`
// eighths of the range), with three significant digits.
std::vector<plan::Value> neighboursOf(const plan::ParamDesc& param, const plan::Value& value, double step);

// Measured error and cost of a setting.
struct Score {
  bool known = false;  // false: refused, or not measured
  double error = 0, cost = 0;
};

// Least error at a cost of at most `limit`, or least cost at an error of at most `limit`.
struct Goal {
  enum class Kind { least_error, least_cost };
  Kind kind = Kind::least_error;
  double limit = 1;

  bool holds(const Score& score) const;
  // Lower is better: logarithm of the minimised quantity, plus `weight` times the logarithm of the excess over the
  // limit, plus a small multiple of the logarithm of the limited quantity.
  double loss(const Score& score, double weight) const;
  // True if `one` is better. A score within the limit is better than a score beyond the limit.
  bool isBetter(const Score& one, const Score& other) const;
};

// Search for the parameter values with the least error at a limited cost, or the least cost at a limited error, within
// a limited number of evaluations.
class Search {
 public:
  struct Options {
    int evaluations = 1;  // at most; one evaluation is one setting at one level
    int levels = 3;       // the last level decides
    int keep = 3;         // one of `keep` settings reaches the next level
  };
  // Key of everything that a setting determines: settings with the same key are measured once. "" if the setting is
  // refused.
  using Identity = std::function<std::string(const Spot&)>;
  using Measure = std::function<std::vector<Score>(const std::vector<Spot>&, int level)>;
  // Called after each halving and each round of steps.
  using Report = std::function<void(const std::string& what)>;

  struct Found {
    Spot spot;
    Score score;
  };

  Search(Space space, Goal goal, Options options, Identity identity, Measure measure, Report report = {});

  // Tries the starts in order, as many different starts as a third of the evaluations allow, then searches.
  void run(const std::vector<Spot>& starts);

  // Settings measured at the last level, in the order of measurement.
  const std::vector<Found>& found() const { return found_; }
  const std::optional<Found>& best() const { return best_; }  // by the goal; empty if nothing was measured
  int evaluations() const { return evaluations_; }
  bool finished() const { return finished_; }  // true: no step improves the best; false: evaluations were used up

 private:
  // Step along a number in octaves, and weight of the limit in the loss.
  struct Stride {
    double octaves, weight;
  };
  bool isLast(int level) const { return level + 1 == options_.levels; }
  std::vector<Found> measured(const std::vector<Spot>& spots, int level);
  std::vector<Spot> chosenStarts(const std::vector<Spot>& starts);
  std::vector<Found> halved(std::vector<Spot> spots);
  bool stepAlong(size_t dimension, const Stride& stride, Found& at);
  bool walk(Found at, const Stride& stride, int most);
  void say(const std::string& what) const;

  const Space space_;
  const Goal goal_;
  const Options options_;
  const Identity identity_;
  const Measure measure_;
  const Report report_;
  std::vector<std::map<std::string, Score>> known_;  // by level and identity
  std::vector<Found> found_;
  std::optional<Found> best_;
  size_t next_ = 0;  // dimension of the next step; a walk continues where the last walk ended
  int evaluations_ = 0;
  bool finished_ = false;
};

}  // namespace strobe::study
