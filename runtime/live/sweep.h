// SPDX-License-Identifier: MIT
// Pictures of a shot at several values of one or two controls, with errors and times. Drawn in slices while the window
// stays in use. Files are read once, at their first use.
#pragma once

#include "image/draw.h"
#include "lab/batch.h"
#include "live/gathered_truth.h"
#include "live/sweep_axis.h"

namespace strobe::live {

// Result of one point of a parameter sweep: the shot, its picture, GPU times in milliseconds, RMSE
// against ground truth, and the crop with the largest error.
struct SweepPoint {
  std::vector<size_t> at;       // index of the value on each axis
  lab::Shot shot;               // shot with these values
  image::Image color;           // linear, three channels; empty before it is drawn
  std::string problem;          // message of a failure, or ""
  std::vector<double> ms;       // device time of a frame, for each round
  std::optional<double> error;  // RMSE of the linear colour against ground truth with `samples` samples
  int samples = 0;
  image::Rectangle worst;  // crop with the picture's aspect ratio and the largest squared error, `worst_sum`
  double worst_sum = 0;

  std::optional<double> median() const;  // of `ms`
};

// Parameter sweep of a shot over the values of one or two controls. Draws, measures and times the pictures in short
// slices between window frames.
class Sweep {
 public:
  static constexpr int kRounds = 3;       // timed frames of each point
  static constexpr int kOwnSamples = 64;  // samples of a ground truth that belongs to one value
  static constexpr int kEnough = 1024;    // samples of the ground truth that all values share
  static constexpr int kCrop = 48;        // width of the crop with the largest error, px

  // `shown`: shot of the window's ground truth. `truth`: as in GatheredTruth. Throws `Error` without values or if the
  // pictures are too large to keep. `bench` must outlive the sweep.
  Sweep(lab::Workbench& bench, const lab::Shot& shot, std::vector<SweepAxis> axes, const lab::Shot& shown,
        const std::string& truth);

  const std::vector<SweepAxis>& axes() const { return axes_; }
  const std::vector<SweepPoint>& points() const { return points_; }  // the last axis varies fastest
  const lab::Shot& shot() const { return shot_; }
  // True if `shot` equals the swept shot, except for the values of the axes.
  bool isOf(const lab::Shot& shot) const;

  // Works for about `budget_s` seconds, one frame at least: first pictures, then errors, then times, one frame of each
  // point in turn. Errors are measured again when `shared` has improved. True if there was work.
  bool advance(const GatheredTruth& shared, double budget_s);
  void stop() { stopped_ = true; }  // stops drawing and timing
  bool stopped() const { return stopped_; }

  size_t drawn() const;  // points with a picture or a problem
  size_t timed() const;  // points with all times or with a problem
  bool isWhole() const { return stopped_ || (timed() == points_.size() && !samplesOwn()); }
  // True if all points share the window's ground truth.
  bool sharesTruth() const { return own_keys_.empty(); }
  // True while the ground truths of single values are sampled.
  bool samplesOwn() const { return !stopped_ && next_own_ < own_keys_.size(); }
  // Samples of the ground truth behind the errors, the minimum over all points; 0 until every point has an error.
  int samples() const;
  // Point with the crop of the largest error; null until every point has an error.
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
  // Ground truths that belong to single values, sampled one after the other.
  lab::RunningTruth own_;
  std::vector<std::string> own_keys_;
  size_t next_own_ = 0;
  bool own_begun_ = false;
};

// Picture reduced by box filtering until no side is longer than a thumbnail's; never enlarged.
image::Image reduced(const image::Image& linear);

// Linear thumbnail of a point; empty before the point is drawn. Shows the crop of `worst` (Sweep::worst) with its
// pixels as squares, or the whole picture if `worst` is null.
image::Image thumbnailOf(const SweepPoint& point, const SweepPoint* worst);

}  // namespace strobe::live
