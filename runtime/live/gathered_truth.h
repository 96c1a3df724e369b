// SPDX-License-Identifier: MIT
// Ground truth that accumulates in the background while the window is idle.
#pragma once

#include <functional>

#include "lab/running_truth.h"

namespace strobe::live {

// Ground truth of the window's shot, sampled in short steps while the window is idle. Restarts for another shot and
// measures the RMSE of a picture.
class GatheredTruth {
 public:
  // `pipeline`: pipeline of the ground truth; "" for the pipeline that declares kind = "truth". `bench` must outlive
  // this object.
  GatheredTruth(lab::Workbench& bench, const std::string& pipeline) : truth_(bench, pipeline) {}

  static constexpr int kEnough = 4096;  // samples; the remaining noise is invisible in the 8 bits of a display

  // Adds samples for the shot; the shot's pipeline has no effect. True if samples were due. Runs steps of samples until
  // 30 ms have passed. A longer step ends at the next sample if `felt` (may be empty) returns true.
  bool gather(const lab::Shot& shot, const std::function<bool()>& felt = {});
  bool isComplete(const lab::Shot& shot) const;
  // Restarts at the next `gather`.
  void forget() { key_.clear(); }

  // Key of a shot's ground truth. Equal for shots that differ only in the pipeline, its values, `taps` and `aa`.
  static std::string keyOf(const lab::Shot& shot);

  int samples(const lab::Shot& shot) const;  // 0 if the ground truth belongs to another shot
  const image::Image& mean() const { return truth_.mean(); }
  // RMSE of `color` against the ground truth so far. Empty without samples or if the sizes differ.
  std::optional<double> errorOf(const lab::Shot& shot, const image::Image& color) const;
  const std::string& pipeline() const { return truth_.pipeline(); }  // "" until the pipeline is chosen
  const std::string& problem() const { return problem_; }            // message of a failure, or ""
  int interrupted() const { return truth_.interrupted(); }           // number of steps that input ended

 private:
  lab::RunningTruth truth_;
  std::string key_, problem_;
};

}  // namespace strobe::live
