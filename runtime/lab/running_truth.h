// SPDX-License-Identifier: MIT
// Progressive truth: steps of a few samples each, averaged in double precision. A step takes as many samples as all
// steps before it, while steps are short enough. Larger steps repeat the once-per-step work on static surfaces less
// often, and their sample times are more even.
#pragma once

#include <functional>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "lab/workbench.h"

namespace strobe::lab {

class Session;

// Progressive ground truth of one shot: the running mean of the samples so far, with its standard error. Restarts for
// another shot.
class RunningTruth {
 public:
  struct Steps {
    int first = 4, most = 64;  // samples per step
    double longest_s = 0.5;    // seconds; the step after a longer step does not grow; infinite: no time limit
  };

  // `pipeline`: needs a parameter with the role sample_count and the output "color"; may have parameters with the roles
  // sample_times and regions. "": the pipeline that declares kind = "truth". The bench must outlive this object.
  explicit RunningTruth(Workbench& bench, std::string pipeline, const Steps& steps);
  explicit RunningTruth(Workbench& bench, std::string pipeline = "") : RunningTruth(bench, std::move(pipeline), {}) {}
  ~RunningTruth();

  // Discards all samples and starts on another shot. Takes the scene settings of the shot, but not its pipeline
  // settings. Throws `Error` if the pipeline cannot be drawn.
  void restart(const Shot& shot);

  // Takes one step of at most `most` samples. Its random numbers depend only on the seed of the shot and the number of
  // the step. `goes_on` (may be empty) is called between samples; if it returns false, the step is dropped and the next
  // step has half as many samples. Returns false before the first `restart`, and for `most` = 0.
  bool step(int most = std::numeric_limits<int>::max(), const std::function<bool()>& goes_on = {});

  // Name of the pipeline; "" if it was not given and `restart` has not run.
  const std::string& pipeline() const { return pipeline_; }
  // Mean of all samples: linear colour, three channels; empty before the first step.
  const image::Image& mean() const { return mean_; }
  int samples() const { return samples_; }
  int interrupted() const { return interrupted_; }  // steps dropped since the last restart

  // Standard error of the mean, estimated from the differences between steps: root mean square over pixels and
  // channels. Infinite before the second step.
  double standardError() const;

 private:
  void add(const image::Image& color, int samples);
  const script::Settings& settings();

  Workbench& bench_;
  std::string pipeline_;
  Steps steps_;
  script::Settings settings_;  // settings of the first step; empty until needed
  std::string count_;          // name of the parameter with the role sample_count
  std::unique_ptr<Session> session_;
  uint32_t seed_ = 0;
  int taken_ = 0, samples_ = 0, next_ = 0;     // steps, samples in total, samples of the next step
  int set_ = 0, interrupted_ = 0;              // samples set in the session; steps dropped
  std::vector<double> mean_so_far_, squares_;  // mean colour; sums of squared step differences
  image::Image mean_;
};

}  // namespace strobe::lab
