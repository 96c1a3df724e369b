// SPDX-License-Identifier: MIT
// The truth that gathers behind the window while nothing else is to be done.
#pragma once

#include <functional>

#include "lab/running_truth.h"

namespace strobe::live {

class GatheredTruth {
 public:
  // `pipeline`: "" for the one that declares kind = "truth". The bench must outlive it.
  GatheredTruth(lab::Workbench& bench, const std::string& pipeline) : truth_(bench, pipeline) {}

  static constexpr int kEnough = 4096;  // the noise left is less than a display's 8 bits show

  // Takes a few samples of the shot, whatever pipeline draws it. True if any were due. Returns after 30 ms, and at the
  // next sample if `felt` (may be empty) is true then.
  bool gather(const lab::Shot& shot, const std::function<bool()>& felt = {});
  bool isComplete(const lab::Shot& shot) const;
  // Begins anew at the next `gather`.
  void forget() { key_.clear(); }

  // Equal for shots that have one truth: what it depends on, which is all but how they are drawn.
  static std::string keyOf(const lab::Shot& shot);

  int samples(const lab::Shot& shot) const;  // 0 where the truth is that of another shot
  const image::Image& mean() const { return truth_.mean(); }
  // RMSE of a picture of the shot against the truth so far.
  std::optional<double> errorOf(const lab::Shot& shot, const image::Image& color) const;
  const std::string& pipeline() const { return truth_.pipeline(); }  // "" before it is known
  const std::string& problem() const { return problem_; }            // why it cannot be gathered, or ""
  int interrupted() const { return truth_.interrupted(); }           // steps that input ended

 private:
  lab::RunningTruth truth_;
  std::string key_, problem_;
};

}  // namespace strobe::live
