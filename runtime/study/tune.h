// SPDX-License-Identifier: MIT
// The best setting of a pipeline for a picture: a search (study/search.h) whose settings are points of an experiment.
// Where times decide nothing it is the same every time; what the store has is not drawn and not timed again.
#pragma once

#include <set>

#include "study/results.h"
#include "study/search.h"
#include "study/store.h"

namespace strobe::study {

// What is sought, for which picture.
struct Wish {
  lab::Shot shot;                 // pipeline and settings: those are kept, the other parameters are varied from there
  std::vector<std::string> vary;  // parameters that are varied; empty: those of `spaceOf`
  std::string base;               // pipeline whose cost is 1; "": the shot's own
  std::string measure = "rmse";   // of the error
  std::string region = "inner";
  bool own = false;  // cost is the time of the passes that a frame without blur does not have; else the frame's

  enum class Limit { ms, ratio, error, error_ratio };  // of the base's cost and error
  Limit limits = Limit::ratio;
  double limit = 1;
  int evaluations = 120;

  // Names of the measures of cost: milliseconds, and as a multiple of the base's in the same rounds.
  std::string msName() const { return own ? "ms_own" : "ms"; }
  std::string ratioName() const { return own ? "own_ratio" : "ms_ratio"; }
};

// One setting as it was measured at last.
struct Measured {
  script::Settings changed;                              // from the wish's shot
  double error = 0, whole_error = 0, ms = 0, ratio = 0;  // errors in the region and over the picture
  std::string command;                                   // draws it
};

struct Tuned {
  Results results;                  // of every setting that was measured; `command` is left to the caller
  std::optional<Measured> chosen;   // none: nothing meets the limit
  std::optional<Measured> nearest;  // to the limit
  Measured start, base;
  script::Settings values;  // of every parameter of the chosen one that has not its default
  int evaluations = 0;
  bool finished = false;  // no single step improves it; false: evaluations were used up
};

// Parameters that a search varies: of those of the pipeline that are not set the ones that `vary` names, else all but
// those that make it another question (shading, sample times, regions) and those that nodes of `captured` follow, which
// is what every method starts from. Throws `Error` (exit code 2) for a name that is none, with the nearest.
Space spaceOf(const plan::PipelineDesc& pipeline, const std::set<std::string>& captured, const Wish& wish);

// Throws `Error` where truth, the base or the shot as it is cannot be drawn.
Tuned tune(const Wish& wish, lab::Workbench& bench, const Store& store);

// The preset as a file: what it is, a text in lines, and its values.
std::string presetText(const std::vector<std::string>& doc, const script::Settings& values);

}  // namespace strobe::study
