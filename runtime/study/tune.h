// SPDX-License-Identifier: MIT
// Best setting of a pipeline for a picture: a search (study/search.h) over settings, which are points of an experiment.
// The result is reproducible if times do not affect it. Points in the store are not drawn or timed again.
#pragma once

#include <set>

#include "study/results.h"
#include "study/search.h"
#include "study/store.h"

namespace strobe::study {

// Request: goal and picture.
struct TuneRequest {
  lab::Shot shot;                 // pipeline and fixed settings; other parameters are varied from their values
  std::vector<std::string> vary;  // varied parameters; empty: chosen by `spaceOf`
  std::string base;               // pipeline with a cost of 1; "": pipeline of the shot
  std::string measure = "rmse";   // measure of the error
  std::string region = "inner";
  bool own = false;  // cost is the time of the method's own passes (run.h); false: of the frame

  enum class Limit { ms, ratio, error, error_ratio };  // limited quantity; ratios are to the base
  Limit limits = Limit::ratio;
  double limit = 1;
  int evaluations = 120;

  // Measures of cost: milliseconds, and ratio to the base in the same rounds.
  std::string msName() const { return own ? "ms_own" : "ms"; }
  std::string ratioName() const { return own ? "own_ratio" : "ms_ratio"; }
};

// Final measurement of one setting.
struct Measured {
  script::Settings changed;                              // settings that differ from the shot of the request
  double error = 0, whole_error = 0, ms = 0, ratio = 0;  // errors in the region and in the picture
  std::string command;                                   // draws the picture
};

// Result of tuning a pipeline: the best setting within the limit, the start and base settings with error and cost,
// and all measurements.
struct Tuned {
  Results results;                  // all measured settings; the caller sets `command`
  std::optional<Measured> chosen;   // empty: no setting meets the limit
  std::optional<Measured> nearest;  // setting nearest to the limit, if no setting meets the limit
  Measured start, base;
  script::Settings values;  // parameters of `chosen` that differ from their defaults
  int evaluations = 0;
  bool finished = false;  // true: no single step improves `chosen`; false: evaluations were used up
};

// Parameters that a search varies: the parameters in `vary`, or all parameters of the pipeline that are not set. The
// latter do not include parameters that change the task (shading, sample times, regions) and parameters of the nodes in
// `captured`, because every method starts from these nodes. Throws `Error` (exit code 2) for an unknown name, with the
// nearest name.
Space spaceOf(const plan::PipelineDesc& pipeline, const std::set<std::string>& captured, const TuneRequest& request);

// Throws `Error` if truth, the base or the shot with its start values cannot be drawn.
Tuned tune(const TuneRequest& request, lab::Workbench& bench, const Store& store);

// Text of a preset file: description in lines, and values.
std::string presetText(const std::vector<std::string>& doc, const script::Settings& values);

}  // namespace strobe::study
