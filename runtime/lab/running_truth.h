// SPDX-License-Identifier: MIT
// Truth that gets better while one looks: steps of a few samples each, averaged in double precision.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "lab/workbench.h"

namespace strobe::lab {

class Session;

class RunningTruth {
 public:
  // `pipeline`: "" for the one that declares kind = "truth". It has a parameter of the role sample_count, and may have
  // those of the roles sample_times and regions; its output is "color". The bench must outlive this.
  explicit RunningTruth(Workbench& bench, std::string pipeline = "", int samples_per_step = 4);
  ~RunningTruth();

  // Forgets everything and starts on another shot (its pipeline's settings are not taken, the scene's are).
  // Throws `Error` where the pipeline cannot be drawn.
  void restart(const Shot& shot);

  // Takes one step, with random numbers of its own that depend on the shot's seed and the number of the step alone.
  // False before a shot is given.
  bool step();

  // "" where it was not given and nothing was started yet.
  const std::string& pipeline() const { return pipeline_; }
  // Linear colour of three channels; empty before the first step.
  const image::Image& mean() const { return mean_; }
  int samples() const { return steps_ * samples_per_step_; }

  // Of the mean: root mean square over pixels and channels, from how the steps differ; infinite before the second.
  double standardError() const;

 private:
  void add(const image::Image& color);
  const script::Settings& settings();

  Workbench& bench_;
  std::string pipeline_;
  int samples_per_step_ = 0;
  script::Settings settings_;  // of a step; empty until they are needed
  std::unique_ptr<Session> session_;
  uint32_t seed_ = 0;
  int steps_ = 0;
  std::vector<double> sum_, squares_;  // of the steps' colours, and of their differences from the mean so far
  image::Image mean_;
};

}  // namespace strobe::lab
