// SPDX-License-Identifier: MIT
#include "study/search.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "base/lists.h"

namespace strobe::study {

using Type = plan::ParamDesc::Type;

namespace {

// ---- numbers

bool isNumber(const plan::ParamDesc& param) { return param.type == Type::Int || param.type == Type::Float; }

double numberOf(const plan::Value& value) {
  const auto* whole = std::get_if<int64_t>(&value);
  return whole ? double(*whole) : std::get<double>(value);
}

// Number as a value of the parameter: in its range, with three significant digits.
plan::Value valueOf(const plan::ParamDesc& param, double number) {
  number = std::clamp(number, param.min.value_or(number), param.max.value_or(number));
  if (param.type == Type::Int) return int64_t(std::llround(number));
  double digits = std::strtod(fmt::format("{:.3g}", number).c_str(), nullptr);
  return std::clamp(digits, param.min.value_or(digits), param.max.value_or(digits));
}

bool isByOctaves(const plan::ParamDesc& param, double number) { return number > 0 && param.min.value_or(-1) >= 0; }

double moved(const plan::ParamDesc& param, double number, double octaves, double share) {
  if (isByOctaves(param, number)) return number * std::exp2(octaves);
  return number + share * (param.max.value_or(1) - param.min.value_or(0));
}

// ---- choices

std::vector<plan::Value> othersOf(const plan::ParamDesc& param, const plan::Value& value) {
  if (param.type == Type::Bool) return {!std::get<bool>(value)};
  std::vector<plan::Value> others;
  for (const std::string& choice : param.choices)
    if (plan::Value(choice) != value) others.emplace_back(choice);
  return others;
}

// Choice for `u` in [0, 1): the last `changed` of the range is divided among the other choices, the rest is the centre.
plan::Value choiceAt(const plan::ParamDesc& param, const plan::Value& centre, double u, double changed) {
  std::vector<plan::Value> others = othersOf(param, centre);
  if (others.empty() || u < 1 - changed) return centre;
  return others[std::min(size_t((u - (1 - changed)) / changed * double(others.size())), others.size() - 1)];
}

constexpr double kFarthest = 3;      // largest distance of a start from its centre, octaves
constexpr double kLeastGain = 0.01;  // of the loss (a logarithm); smaller gains may be noise of times
// Weights of the limit: low during the search, because settings beyond the limit may lead to the best one, and high at
// the end.
constexpr double kLoosely = 3, kFirmly = 10;
// Weight of the limited quantity below the limit, which leaves room to lower the other quantity.
constexpr double kSlack = 0.05;

}  // namespace

Spot startOf(const Space& space) {
  Spot spot;
  for (const Dimension& dimension : space) spot.push_back(dimension.start);
  return spot;
}

Spot spotAt(const Space& space, const Spot& centre, const std::vector<double>& point) {
  auto choices = std::count_if(space.begin(), space.end(), [](const Dimension& one) { return !isNumber(one.param); });
  double changed = std::min(0.5, 4.0 / double(std::max<long>(choices, 1)));
  Spot spot;
  for (size_t d = 0; d < space.size(); ++d) {
    const plan::ParamDesc& param = space[d].param;
    double aside = 2 * point[d] - 1, near = aside * std::abs(aside);
    if (!isNumber(param)) spot.push_back(choiceAt(param, centre[d], point[d], changed));
    else spot.push_back(valueOf(param, moved(param, numberOf(centre[d]), kFarthest * near, near / 2)));
  }
  return spot;
}

std::vector<plan::Value> neighboursOf(const plan::ParamDesc& param, const plan::Value& value, double step) {
  if (!isNumber(param)) return othersOf(param, value);
  std::vector<plan::Value> neighbours;
  double number = numberOf(value);
  for (double side : {-1.0, 1.0}) {
    plan::Value next = valueOf(param, moved(param, number, side * step, side * step / 8));
    if (next == value && param.type == Type::Int) next = valueOf(param, number + side);
    if (next != value) neighbours.push_back(next);
  }
  return neighbours;
}

// ---- goal

bool Goal::holds(const Score& score) const {
  return score.known && (kind == Kind::least_error ? score.cost : score.error) <= limit;
}

double Goal::loss(const Score& score, double weight) const {
  constexpr double kNothing = 1e-12;
  double least = kind == Kind::least_error ? score.error : score.cost;
  double limited = kind == Kind::least_error ? score.cost : score.error;
  double excess = std::max(0.0, std::log(std::max(limited, kNothing) / std::max(limit, kNothing)));
  return std::log(std::max(least, kNothing)) + weight * excess + kSlack * std::log(std::max(limited, kNothing));
}

bool Goal::isBetter(const Score& one, const Score& other) const {
  if (one.known != other.known) return one.known;
  if (holds(one) != holds(other)) return holds(one);
  if (!holds(one)) return loss(one, kFirmly) < loss(other, kFirmly);
  if (kind == Kind::least_error) return std::tie(one.error, one.cost) < std::tie(other.error, other.cost);
  return std::tie(one.cost, one.error) < std::tie(other.cost, other.error);
}

// ---- the search

Search::Search(Space space, Goal goal, Options options, Identity identity, Measure measure, Report report)
    : space_(std::move(space)),
      goal_(goal),
      options_(options),
      identity_(std::move(identity)),
      measure_(std::move(measure)),
      report_(std::move(report)),
      known_(size_t(options.levels)) {}

void Search::say(const std::string& what) const {
  if (report_) report_(what);
}

// Spots with a score, in the given order. Measures new spots while evaluations are left.
std::vector<Search::Found> Search::measured(const std::vector<Spot>& spots, int level) {
  std::map<std::string, Score>& known = known_[size_t(level)];
  std::vector<std::string> identities, new_ones;
  std::vector<Spot> asked;
  for (const Spot& spot : spots) {
    std::string identity = identities.emplace_back(identity_(spot));
    bool is_new = !identity.empty() && !known.count(identity) && evaluations_ < options_.evaluations;
    if (!is_new || contains(new_ones, identity)) continue;
    new_ones.push_back(identity), asked.push_back(spot);
    ++evaluations_;
  }
  std::vector<Score> scores = asked.empty() ? std::vector<Score>() : measure_(asked, level);
  for (size_t i = 0; i < asked.size(); ++i) {
    known[new_ones[i]] = scores[i];
    if (!isLast(level) || !scores[i].known) continue;
    found_.push_back({asked[i], scores[i]});
    if (!best_ || goal_.isBetter(scores[i], best_->score)) best_ = found_.back();
  }
  std::vector<Found> result;
  for (size_t i = 0; i < spots.size(); ++i) {
    auto score = known.find(identities[i]);
    if (score != known.end() && score->second.known) result.push_back({spots[i], score->second});
  }
  return result;
}

// First different starts, as many as can be halved in a third of the evaluations.
std::vector<Spot> Search::chosenStarts(const std::vector<Spot>& starts) {
  double per_start = 0;
  for (int level = 0; level < options_.levels; ++level) per_start += std::pow(options_.keep, -level);
  size_t most = size_t(std::max(1.0, options_.evaluations / (3 * per_start)));
  std::vector<Spot> chosen;
  std::vector<std::string> known;
  for (const Spot& spot : starts) {
    std::string identity = identity_(spot);
    if (identity.empty() || contains(known, identity)) continue;
    known.push_back(identity), chosen.push_back(spot);
    if (chosen.size() == most) break;
  }
  return chosen;
}

// Remaining spots, best first. Always keeps the first given spot, the unchanged setting, because all others are
// compared with it.
std::vector<Search::Found> Search::halved(std::vector<Spot> spots) {
  const Spot first = spots.front();
  std::vector<Found> tried;
  for (int level = 0; level < options_.levels; ++level) {
    tried = measured(spots, level);
    std::stable_sort(tried.begin(), tried.end(), [&](const Found& a, const Found& b) {
      return goal_.loss(a.score, kLoosely) < goal_.loss(b.score, kLoosely);
    });
    say(fmt::format("level {} of {}: {} settings", level + 1, options_.levels, tried.size()));
    size_t kept = (tried.size() + size_t(options_.keep) - 1) / size_t(options_.keep);
    spots.clear();
    for (size_t i = 0; i < kept; ++i) spots.push_back(tried[i].spot);
    addOnce(spots, first);
  }
  return tried;
}

// Moves to the best neighbour along a dimension; false if no neighbour is better.
bool Search::stepAlong(size_t dimension, const Stride& stride, Found& at) {
  std::vector<Spot> spots;
  for (const plan::Value& value : neighboursOf(space_[dimension].param, at.spot[dimension], stride.octaves)) {
    spots.push_back(at.spot);
    spots.back()[dimension] = value;
  }
  double least = goal_.loss(at.score, stride.weight) - kLeastGain;
  bool moved = false;
  for (const Found& one : measured(spots, options_.levels - 1)) {
    double loss = goal_.loss(one.score, stride.weight);
    if (loss < least) at = one, least = loss, moved = true;
  }
  return moved;
}

// Steps along every dimension while the loss improves, starting with the dimension of the last walk, until no dimension
// improves. False if `most` evaluations are used up.
bool Search::walk(Found at, const Stride& stride, int most) {
  for (bool moved = true; moved;) {
    if (evaluations_ >= most) return false;
    moved = false;
    for (size_t i = 0; i < space_.size() && evaluations_ < most; ++i) {
      while (evaluations_ < most && stepAlong(next_, stride, at)) moved = true;
      if (evaluations_ < most) next_ = (next_ + 1) % space_.size();
    }
    say(fmt::format("steps of {} octave{}", stride.octaves, stride.octaves == 1 ? "" : "s"));
  }
  return evaluations_ < most;
}

void Search::run(const std::vector<Spot>& starts) {
  std::vector<Spot> chosen = chosenStarts(starts);
  if (chosen.empty()) return;
  std::vector<Found> left = halved(chosen);
  if (!best_) return;
  auto first = std::find_if(left.begin(), left.end(), [&](const Found& one) { return one.spot == chosen.front(); });
  int rest = options_.evaluations - evaluations_;
  if (first != left.end()) walk(*first, {1, kLoosely}, evaluations_ + 2 * rest / 5);
  if (first != left.begin()) walk(left.front(), {1, kLoosely}, evaluations_ + 2 * rest / 5);
  finished_ = true;
  for (double octaves : {1.0, 0.5, 0.25})
    finished_ = walk(*best_, {octaves, kFirmly}, options_.evaluations) && finished_;
}

}  // namespace strobe::study
