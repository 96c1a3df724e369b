// SPDX-License-Identifier: MIT
// Pictures of a shot at several values of one or two of its controls, with their errors and times: drawn in slices
// while the window goes on. Files are read once, when they are first needed.
#pragma once

#include "image/draw.h"
#include "lab/batch.h"
#include "live/gathered_truth.h"
#include "live/sweep_axis.h"

namespace strobe::live {

struct SweepPoint {
  std::vector<size_t> at;       // value of each axis, by number
  lab::Shot shot;               // what is drawn
  image::Image color;           // linear, three channels; empty before it is drawn
  image::Image thumbnail;       // the same, reduced
  std::string problem;          // why it cannot be drawn, or ""
  std::vector<double> ms;       // device time of a frame, by round
  std::optional<double> error;  // RMSE of the linear colour against truth of `samples`
  int samples = 0;
  image::Rectangle worst;  // crop of the shape of the picture with the largest squared error, which is `worst_sum`
  double worst_sum = 0;

  std::optional<double> median() const;  // of `ms`
};

class Sweep {
 public:
  static constexpr int kRounds = 3;       // of frames that are timed
  static constexpr int kOwnSamples = 64;  // of truths that belong to a value each
  static constexpr int kEnough = 1024;    // of the truth that all values share
  static constexpr int kCrop = 48;        // px, width of the crop with the largest error

  // `shown`: what the window's truth is of. `truth`: as in GatheredTruth. Throws `Error` where there are no values or
  // the pictures are too large to be kept. The bench must outlive it.
  Sweep(lab::Workbench& bench, const lab::Shot& shot, std::vector<SweepAxis> axes, const lab::Shot& shown,
        const std::string& truth);

  const std::vector<SweepAxis>& axes() const { return axes_; }
  const std::vector<SweepPoint>& points() const { return points_; }  // the last axis varies fastest
  const lab::Shot& shot() const { return shot_; }
  // Whether a shot is what was swept: alike but for the values of the axes.
  bool isOf(const lab::Shot& shot) const;

  // Goes on for about so long, by one frame at least: pictures first, then errors, then times, a frame of each point in
  // turn. Errors follow `shared` as it gets better. True where there is something new.
  bool advance(const GatheredTruth& shared, double budget_s);
  void stop() { stopped_ = true; }  // draws and times nothing more
  bool stopped() const { return stopped_; }

  size_t drawn() const;  // points that have a picture, or a problem
  size_t timed() const;  // points that have all their times, or a problem
  bool isWhole() const { return stopped_ || (timed() == points_.size() && !samplesOwn()); }
  // Whether all points share one truth, the window's.
  bool sharesTruth() const { return own_keys_.empty(); }
  // Whether truths of single values are still sampled.
  bool samplesOwn() const { return !stopped_ && next_own_ < own_keys_.size(); }
  // Samples of the truth that errors are measured against, the least of all points; 0 while one has no error.
  int samples() const;
  // Point with the crop of the largest error; null before the first error.
  const SweepPoint* worst() const;

 private:
  bool step(const GatheredTruth& shared);
  bool draw();
  bool time();
  bool measure(const GatheredTruth& shared);
  bool sampleOwn();
  void fail(SweepPoint& point, const Error& error);

  lab::Batch batch_;
  lab::Shot shot_;
  std::vector<SweepAxis> axes_;
  std::vector<SweepPoint> points_;
  bool stopped_ = false;
  // Where values have truths of their own: these, one after the other.
  lab::RunningTruth own_;
  std::vector<std::string> own_keys_;
  size_t next_own_ = 0;
  bool own_begun_ = false;
};

// The shot with a value of the control of that name.
lab::Shot withValue(lab::Shot shot, const std::string& name, const plan::Value& value);

}  // namespace strobe::live
