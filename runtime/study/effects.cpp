// SPDX-License-Identifier: MIT
#include "study/effects.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "base/lists.h"

namespace strobe::study {

const char* const kHowToReadEffects =
    "A block is a set of points that differ in one factor only. The effect of a level is its mean difference from the "
    "mean of its block. Blocks that lack a level are left out. An interaction is the remainder of a cell after the "
    "effects of its row and its column. Intervals are Student's t over the blocks, bold if they exclude 0, and are not "
    "corrected for multiple comparisons. Without complete blocks, numbers are fitted by a straight line and other "
    "levels are compared unpaired.";

namespace {

// Point with a finite value, and its group.
struct Levelled {
  const PointGroup* group;
  const Point* point;
  double value;
};

std::vector<Levelled> pointsOf(const Results& results, const std::string& shot, const std::string& measure,
                               const std::string& region) {
  std::vector<Levelled> points;
  for (const PointGroup& group : results.groups)
    for (const Point& point : group.points) {
      double value = point.value(measure, region);
      if (point.role == ArmRole::method && (shot.empty() || group.shot == shot) && std::isfinite(value))
        points.push_back({&group, &point, value});
    }
  return points;
}

// Possible factor, with the level of each point; -1: the point does not have the factor.
struct Candidate {
  Factor factor;
  std::vector<int> levels;  // one per point
};

// Numbers the levels that occur, in the order of `labels`. `levelOf`: label of a point, as an index; -1: none.
template <class LevelOf>
Candidate candidate(const std::string& name, const std::vector<std::string>& labels, const std::vector<double>& numbers,
                    const std::vector<Levelled>& points, const LevelOf& levelOf) {
  Candidate result{{name, {}, {}}, {}};
  for (const Levelled& one : points) result.levels.push_back(levelOf(one));
  std::map<int, int> renumbered = {{-1, -1}};
  for (int label = 0; label < int(labels.size()); ++label) {
    if (!contains(result.levels, label)) continue;
    renumbered[label] = int(result.factor.labels.size());
    result.factor.labels.push_back(labels[size_t(label)]);
    if (!numbers.empty()) result.factor.numbers.push_back(numbers[size_t(label)]);
  }
  for (int& level : result.levels) level = renumbered.at(level);
  return result;
}

template <class It>
int placeOf(const std::vector<It>& all, const It& one) {
  auto found = std::find(all.begin(), all.end(), one);
  return found == all.end() ? -1 : int(found - all.begin());
}

Candidate ofAxis(const AxisSummary& axis, const std::vector<Levelled>& points) {
  std::vector<double> numbers;
  for (const Json& value : axis.values)
    if (value.is_number()) numbers.push_back(value.get<double>());
  if (numbers.size() < axis.values.size()) numbers.clear();
  return candidate(axis.name, axis.labels, numbers, points, [&](const Levelled& one) {
    const Json* value = one.group->valueOn(axis.name);
    return value ? placeOf(axis.values, *value) : -1;
  });
}

std::vector<Candidate> candidatesOf(const Results& results, const std::vector<Levelled>& points) {
  const std::vector<std::string> arms = namesOf(results.arms), shots = namesOf(results.shots);
  std::vector<Candidate> candidates = {
      candidate("arm", arms, {}, points, [&](const Levelled& one) { return placeOf(arms, one.point->arm); }),
      candidate("shot", shots, {}, points, [&](const Levelled& one) { return placeOf(shots, one.group->shot); })};
  for (const AxisSummary& axis : results.axes) candidates.push_back(ofAxis(axis, points));
  std::erase_if(candidates, [](const Candidate& one) { return one.factor.levels() < 2; });
  return candidates;
}

bool byDoubling(const std::vector<double>& numbers) {
  auto [least, most] = std::minmax_element(numbers.begin(), numbers.end());
  return *least > 0 && *most >= 5 * *least;
}

// Sets the slope. Points with equal levels of all factors without numbers form a stratum.
void findSlope(const Effects& effects, const Observations& observations, FactorEffect& result) {
  const size_t factor = result.factor;
  std::map<std::vector<int>, int> strata;
  std::vector<double> x, y;
  std::vector<int> stratum;
  for (const Observation& one : observations) {
    if (one.levels[factor] < 0) continue;
    double number = effects.factors[factor].numbers[size_t(one.levels[factor])];
    x.push_back(result.doubling ? std::log2(number) : number);
    y.push_back(one.value);
    std::vector<int> texts;
    for (size_t f = 0; f < effects.factors.size(); ++f)
      if (effects.factors[f].numbers.empty()) texts.push_back(one.levels[f]);
    stratum.push_back(strata.emplace(texts, int(strata.size())).first->second);
  }
  result.slope = slopeWithin(x, y, stratum);
  result.points = x.size();
}

FactorEffect mainOf(const Effects& effects, const Observations& observations, size_t factor) {
  const Factor& of = effects.factors[factor];
  FactorEffect result{factor, LevelComparison::paired, effectOf(observations, {factor}, {of.levels()})};
  if (result.effect.blocks > 0) return result;
  if (of.numbers.size() >= 3) {
    result.comparison = LevelComparison::slope;
    result.doubling = byDoubling(of.numbers);
    findSlope(effects, observations, result);
  } else {
    result.comparison = LevelComparison::unpaired;
    result.effect = unpairedEffect(observations, factor, of.levels());
  }
  return result;
}

}  // namespace

Effects effectsOf(const Results& results, const std::string& shot, const std::string& measure,
                  const std::string& region) {
  std::vector<Levelled> points = pointsOf(results, shot, measure, region);
  std::vector<Candidate> candidates = candidatesOf(results, points);
  Effects effects;
  effects.points = points.size();
  for (const Candidate& one : candidates) effects.factors.push_back(one.factor);
  Observations observations;
  for (size_t i = 0; i < points.size(); ++i) {
    observations.push_back({{}, points[i].value});
    for (const Candidate& one : candidates) observations.back().levels.push_back(one.levels[i]);
  }
  for (size_t f = 0; f < effects.factors.size(); ++f) effects.main.push_back(mainOf(effects, observations, f));
  for (size_t a = 0; a < effects.factors.size(); ++a)
    for (size_t b = a + 1; b < effects.factors.size(); ++b) {
      PairEffect pair{a, b, effectOf(observations, {a, b}, {effects.factors[a].levels(), effects.factors[b].levels()})};
      if (pair.interaction.blocks > 0) effects.pairs.push_back(std::move(pair));
    }
  return effects;
}

}  // namespace strobe::study
