// SPDX-License-Identifier: MIT
// A search for the best setting of some parameters: starts that fill the space, successive halving (Jamieson and
// Talwalkar 2016) over levels of which each measures better and costs more than the one before, then coordinate steps
// from where nothing is changed, from the best start, and from the best of all.
// It knows nothing of pictures: what a setting gives is asked of the caller. The same answers lead to the same search.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "plan/description.h"

namespace strobe::study {

// A parameter that is varied, and where it starts.
struct Dimension {
  plan::ParamDesc param;
  plan::Value start;
};
using Space = std::vector<Dimension>;

// A value for each dimension.
using Spot = std::vector<plan::Value>;

// The start of each dimension.
Spot startOf(const Space& space);

// The spot that a point of the unit cube gives around `centre`: numbers up to three octaves from their value there
// (where that or the range is not above 0: up to half the range), mostly nearer; about four of the other parameters
// have another of their values.
Spot spotAt(const Space& space, const Spot& centre, const std::vector<double>& point);

// The values next to one: every other choice; of a number one step up and one down, `step` octaves each (else eighths
// of the range), with three significant digits.
std::vector<plan::Value> neighboursOf(const plan::ParamDesc& param, const plan::Value& value, double step);

// What a setting gave.
struct Score {
  bool known = false;  // false: it was refused, or not measured
  double error = 0, cost = 0;
};

// Least error at a cost of at most `limit`, or least cost at an error of at most that.
struct Goal {
  enum class Kind { least_error, least_cost };
  Kind kind = Kind::least_error;
  double limit = 1;

  bool holds(const Score& score) const;
  // Less is better: the logarithm of what is to be least, `weight` times that of how often the limit is exceeded, and a
  // little of that of what is limited.
  double loss(const Score& score, double weight) const;
  // Of two scores, of which one that holds is better than one that does not.
  bool isBetter(const Score& one, const Score& other) const;
};

class Search {
 public:
  struct Options {
    int evaluations = 1;  // at most, each of a setting at a level
    int levels = 3;       // the last one counts
    int keep = 3;         // one of so many goes on to the next level
  };
  // What names all that a setting decides: equal ones are measured once. "" where it is refused.
  using Identity = std::function<std::string(const Spot&)>;
  using Measure = std::function<std::vector<Score>(const std::vector<Spot>&, int level)>;
  // After each halving and each round of steps.
  using Report = std::function<void(const std::string& what)>;

  struct Found {
    Spot spot;
    Score score;
  };

  Search(Space space, Goal goal, Options options, Identity identity, Measure measure, Report report = {});

  // Starts are tried in order, as many different ones as a third of the evaluations allow.
  void run(const std::vector<Spot>& starts);

  // What was measured at the last level, in that order.
  const std::vector<Found>& found() const { return found_; }
  const std::optional<Found>& best() const { return best_; }  // by the goal; none where nothing was measured
  int evaluations() const { return evaluations_; }
  bool finished() const { return finished_; }  // no step improves the best; false: evaluations were used up

 private:
  // How far a step goes along a number, and how much the limit weighs.
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
  size_t next_ = 0;  // dimension of the next step: a walk that ends early leaves the others to the next one
  int evaluations_ = 0;
  bool finished_ = false;
};

}  // namespace strobe::study
