// SPDX-License-Identifier: MIT
// Truth that gets better while one looks: steps of a few samples each, averaged in double precision. A step takes as
// many samples as all before it while it is short enough: what a step does once, where things rest, is done for more of
// them then, and their times lie more evenly.
#pragma once

#include <functional>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "lab/workbench.h"

namespace strobe::lab {

class Session;

class RunningTruth {
 public:
  struct Steps {
    int first = 4, most = 64;  // samples
    double longest_s = 0.5;  // a step that took longer is not followed by a larger one; infinite: the same steps always
  };

  // `pipeline`: "" for the one that declares kind = "truth". It has a parameter of the role sample_count, and may have
  // those of the roles sample_times and regions; its output is "color". The bench must outlive this.
  explicit RunningTruth(Workbench& bench, std::string pipeline, const Steps& steps);
  explicit RunningTruth(Workbench& bench, std::string pipeline = "") : RunningTruth(bench, std::move(pipeline), {}) {}
  ~RunningTruth();

  // Forgets everything and starts on another shot (its pipeline's settings are not taken, the scene's are).
  // Throws `Error` where the pipeline cannot be drawn.
  void restart(const Shot& shot);

  // Takes one step of at most `most` samples, with random numbers of its own that depend on the shot's seed and the
  // number of the step alone. `goes_on` (may be empty) is called between samples: where it is false, the step is
  // dropped and the next one has half as many. False before a shot is given, and where `most` is 0.
  bool step(int most = std::numeric_limits<int>::max(), const std::function<bool()>& goes_on = {});

  // "" where it was not given and nothing was started yet.
  const std::string& pipeline() const { return pipeline_; }
  // Linear colour of three channels; empty before the first step.
  const image::Image& mean() const { return mean_; }
  int samples() const { return samples_; }
  int interrupted() const { return interrupted_; }  // steps dropped since the last restart

  // Of the mean: root mean square over pixels and channels, from how the steps differ; infinite before the second.
  double standardError() const;

 private:
  void add(const image::Image& color, int samples);
  const script::Settings& settings();

  Workbench& bench_;
  std::string pipeline_;
  Steps steps_;
  script::Settings settings_;  // of the first step; empty until they are needed
  std::string count_;          // the parameter of the role sample_count
  std::unique_ptr<Session> session_;
  uint32_t seed_ = 0;
  int taken_ = 0, samples_ = 0, next_ = 0;     // steps, samples of all, samples of the next
  int set_ = 0, interrupted_ = 0;              // samples that the session is set to; steps dropped
  std::vector<double> mean_so_far_, squares_;  // of colours by samples, and of the steps' differences from it
  image::Image mean_;
};

}  // namespace strobe::lab
