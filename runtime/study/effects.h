// SPDX-License-Identifier: MIT
// Effects of arms, shots and axes on a measure: math/effects.h for the points of an experiment.
#pragma once

#include <string>
#include <vector>

#include "math/effects.h"
#include "study/results.h"

namespace strobe::study {

// Variable of the points: "arm", "shot" or the name of an axis.
struct Factor {
  std::string name;
  std::vector<std::string> labels;  // names of the levels
  std::vector<double> numbers;      // numbers of the levels; empty unless all levels are numbers

  size_t levels() const { return labels.size(); }
};

// Method of comparison between the levels of a factor.
enum class LevelComparison {
  paired,    // within complete blocks
  unpaired,  // no block is complete: no conditions have measurements of all levels
  slope,     // no block is complete, three or more numeric levels: line with an offset per stratum
};

// Main effect of one factor on a measure: an effect per level, or a slope over numeric levels,
// per unit or per doubling.
struct FactorEffect {
  size_t factor = 0;
  LevelComparison comparison = LevelComparison::paired;
  Effect effect;  // by level; unused for a slope
  Estimate slope;
  size_t points = 0;      // of the slope
  bool doubling = false;  // the slope is per doubling, not per unit
};

// Interaction of two factors: the part of their joint effect on a measure beyond the sum of their main effects.
struct PairEffect {
  size_t first = 0, second = 0;
  Effect interaction;  // has at least one complete block
};

// Statistical analysis of one measure: factors, main effects and pairwise interactions, with 95 % intervals.
struct Effects {
  size_t points = 0;            // number of points with a finite value
  std::vector<Factor> factors;  // with two levels or more
  std::vector<FactorEffect> main;
  std::vector<PairEffect> pairs;
};

// Explanation for pages that show effects.
extern const char* const kHowToReadEffects;

// Effects on a measure over the methods of one shot, or of all shots (""), at points with a finite value.
Effects effectsOf(const Results& results, const std::string& shot, const std::string& measure,
                  const std::string& region);

}  // namespace strobe::study
