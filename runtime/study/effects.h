// SPDX-License-Identifier: MIT
// What arms, shots and axes do to a measure: math/effects.h on the points of an experiment.
#pragma once

#include <string>
#include <vector>

#include "math/effects.h"
#include "study/results.h"

namespace strobe::study {

// What varies among the points: "arm", "shot" or the name of an axis.
struct Factor {
  std::string name;
  std::vector<std::string> labels;  // of its levels
  std::vector<double> numbers;      // of its levels, where all of them are numbers

  size_t levels() const { return labels.size(); }
};

// How one factor is compared.
enum class Comparison {
  paired,    // within complete blocks
  unpaired,  // no block is complete: its levels never stand beside each other under the same conditions
  slope,     // none is, and its levels are three numbers or more: a straight line, a height for each arm, shot and text
};

struct FactorEffect {
  size_t factor = 0;
  Comparison comparison = Comparison::paired;
  MainEffect effect;  // by level, unless it is a slope
  Slope slope;
  bool doubling = false;  // the slope is per doubling, not per unit
};

struct PairEffect {
  size_t first = 0, second = 0;
  Interaction interaction;  // of at least one complete block
};

struct Effects {
  size_t points = 0;            // that have the value
  std::vector<Factor> factors;  // with two levels or more
  std::vector<FactorEffect> main;
  std::vector<PairEffect> pairs;
};

// For the pages that show effects.
extern const char* const kHowToReadEffects;

// Of the methods of one shot, or of all shots (""), that have a finite value.
Effects effectsOf(const Results& results, const std::string& shot, const std::string& measure,
                  const std::string& region);

}  // namespace strobe::study
