// SPDX-License-Identifier: MIT
#include "live/sweep.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/lists.h"
#include "base/log.h"
#include "image/draw.h"
#include "image/metrics.h"
#include "math/statistics.h"

namespace strobe::live {

static const size_t kMostBytes = size_t{2} << 30;  // limit of all pictures, which are kept for their errors
static const double kBetter = 1.25;                // growth of the sample count after which errors are measured again

// Steps for ground truths of single values. The steps do not depend on time, so that equal values have equal errors.
static const lab::RunningTruth::Steps kOwnSteps{4, 16, std::numeric_limits<double>::infinity()};

std::optional<double> SweepPoint::median() const {
  if (ms.empty()) return {};
  return strobe::median(ms);
}

// Returns the shot with another value of the control `name`.
static lab::Shot withValue(lab::Shot shot, const std::string& name, const plan::Value& value) {
  for (const lab::ShotOption& option : lab::shotOptions())
    for (const lab::ShotField& field : option.fields)
      if (field.isValue() && field.declaration.name == name) return field.set(shot, value), shot;
  lab::putSetting(shot.sets, name, value);
  return shot;
}

// Points of all combinations of values, in order.
static std::vector<SweepPoint> pointsOf(const lab::Shot& shot, const std::vector<SweepAxis>& axes) {
  std::vector<SweepPoint> points(1);
  points.front().shot = shot;
  for (const SweepAxis& axis : axes) {
    std::vector<SweepPoint> next;
    for (const SweepPoint& point : points)
      for (size_t i = 0; i < axis.values.size(); ++i) {
        next.push_back({point.at, withValue(point.shot, axis.declaration.name, axis.values[i])});
        next.back().at.push_back(i);
      }
    points = std::move(next);
  }
  return points;
}

Sweep::Sweep(lab::Workbench& bench, const lab::Shot& shot, std::vector<SweepAxis> axes, const lab::Shot& shown,
             const std::string& truth)
    : batch_(bench), shot_(shot), axes_(std::move(axes)), own_(bench, truth, kOwnSteps) {
  shot_.taps.clear();
  points_ = pointsOf(shot_, axes_);
  if (points_.empty() || axes_.empty()) throw Error("a sweep needs values");
  size_t bytes = 0;
  std::string key = GatheredTruth::keyOf(shown);
  for (const SweepPoint& point : points_) {
    bytes += size_t(point.shot.width) * size_t(point.shot.height) * 3 * sizeof(float);
    addOnce(own_keys_, GatheredTruth::keyOf(point.shot));
  }
  if (own_keys_.size() == 1 && own_keys_.front() == key) own_keys_.clear();
  if (bytes > kMostBytes)
    throw Error(
        fmt::format("{} pictures of {}x{} exceed the memory of a sweep ({} MiB): use fewer steps or a smaller size",
                    points_.size(), shot_.width, shot_.height, kMostBytes >> 20));
}

bool Sweep::isOf(const lab::Shot& shot) const {
  auto base = [this](lab::Shot of) {
    for (const SweepAxis& axis : axes_) of = withValue(of, axis.declaration.name, axis.values.front());
    return lab::canonical(of);
  };
  return base(shot) == base(shot_);
}

// ---- slices

bool Sweep::advance(const GatheredTruth& shared, double budget_s) {
  double started_s = clockSeconds();
  if (!step(shared)) return false;
  while (clockSeconds() - started_s < budget_s && step(shared)) continue;
  return true;
}

bool Sweep::step(const GatheredTruth& shared) { return draw() || measure(shared) || sampleOwn() || time(); }

void Sweep::fail(SweepPoint& point, const Error& error) {
  point.problem = error.message();
  point.color = {};
}

bool Sweep::draw() {
  auto next = std::find_if(points_.begin(), points_.end(),
                           [](const SweepPoint& point) { return point.color.empty() && point.problem.empty(); });
  if (stopped_ || next == points_.end()) return false;
  try {
    next->color = image::threeChannels(*batch_.color(next->shot));
    batch_.forgetColorsOf(next->shot.pipeline);
  } catch (const Error& error) {
    fail(*next, error);
  }
  return true;
}

// Squared error of each pixel, summed over channels. Each term is limited to `kMost`; a non-finite error counts as the
// limit.
static image::Image squaredErrors(const image::Image& color, const image::Image& truth) {
  constexpr float kMost = 1e6f;
  image::Image errors(color.width, color.height, 1);
  for (size_t i = 0; i < color.values.size(); ++i) {
    float off = color.values[i] - truth.values[i];
    errors.values[i / size_t(color.channels)] += off * off < kMost ? off * off : kMost;
  }
  return errors;
}

static void measureAgainst(const image::Image& truth, SweepPoint& point) {
  point.error = image::rootMeanSquaredError(point.color, truth);
  const image::Image errors = squaredErrors(point.color, truth);
  const int width = std::min(Sweep::kCrop, errors.width);
  point.worst = image::worstWindow(errors, width, width * errors.height / errors.width);
  point.worst_sum = 0;
  for (int y = 0; y < point.worst.height; ++y)
    for (int x = 0; x < point.worst.width; ++x)
      point.worst_sum += double(errors.at(point.worst.x + x, point.worst.y + y, 0));
}

bool Sweep::measure(const GatheredTruth& shared) {
  if (!sharesTruth()) return false;
  for (SweepPoint& point : points_) {
    int samples = point.color.empty() ? 0 : shared.samples(point.shot);
    if (samples == 0 || (point.error && samples < kBetter * point.samples)) continue;
    if (image::sameSize(point.color, shared.mean())) measureAgainst(shared.mean(), point);
    point.samples = samples;
    return true;
  }
  return false;
}

bool Sweep::sampleOwn() {
  if (!samplesOwn()) return false;
  std::vector<SweepPoint*> of_it;
  for (SweepPoint& point : points_)
    if (!point.color.empty() && GatheredTruth::keyOf(point.shot) == own_keys_[next_own_]) of_it.push_back(&point);
  auto next = [this] { ++next_own_, own_begun_ = false; };
  if (of_it.empty()) return next(), true;
  try {
    if (!std::exchange(own_begun_, true)) own_.restart(of_it.front()->shot);
    own_.step();
  } catch (const Error& error) {
    for (SweepPoint* point : of_it) fail(*point, error);
    return next(), true;
  }
  for (SweepPoint* point : of_it) {
    point->samples = own_.samples();
    if (image::sameSize(point->color, own_.mean())) measureAgainst(own_.mean(), *point);
  }
  if (own_.samples() >= kOwnSamples) next();
  return true;
}

// Times a frame of the point with the fewest times, or of the first such point.
bool Sweep::time() {
  SweepPoint* next = nullptr;
  for (SweepPoint& point : points_)
    if (point.problem.empty() && point.ms.size() < kRounds && (!next || point.ms.size() < next->ms.size()))
      next = &point;
  if (stopped_ || !next) return false;
  try {
    next->ms.push_back(batch_.timeInTurn({next->shot}, {1, 1}).front().ms.front());
  } catch (const Error& error) {
    fail(*next, error);
  }
  return true;
}

// ---- progress

size_t Sweep::drawn() const {
  return size_t(std::count_if(points_.begin(), points_.end(),
                              [](const SweepPoint& point) { return !point.color.empty() || !point.problem.empty(); }));
}

size_t Sweep::timed() const {
  return size_t(std::count_if(points_.begin(), points_.end(), [](const SweepPoint& point) {
    return point.ms.size() >= kRounds || !point.problem.empty();
  }));
}

const SweepPoint* Sweep::worst() const {
  const auto most = std::max_element(points_.begin(), points_.end(), [](const SweepPoint& a, const SweepPoint& b) {
    return a.worst_sum < b.worst_sum;
  });
  return samples() == 0 || most->worst_sum == 0 ? nullptr : &*most;
}

int Sweep::samples() const {
  int least = 0;
  for (const SweepPoint& point : points_) {
    if (!point.problem.empty()) continue;
    if (!point.error) return 0;
    least = least == 0 ? point.samples : std::min(least, point.samples);
  }
  return least;
}

// ---- thumbnails

static const int kThumbnail = 192;  // longer side, pixels

image::Image reduced(const image::Image& linear) {
  const int longer = std::max(linear.width, linear.height);
  if (longer <= kThumbnail) return linear;
  return image::shrunk(linear, std::max(1, kThumbnail * linear.width / longer),
                       std::max(1, kThumbnail * linear.height / longer));
}

image::Image thumbnailOf(const SweepPoint& point, const SweepPoint* worst) {
  if (!worst || point.color.empty()) return reduced(point.color);
  const image::Rectangle area = image::scaledCrop(worst->worst, double(point.color.width) / worst->color.width,
                                                  double(point.color.height) / worst->color.height, point.color);
  const image::Image small = reduced(image::crop(point.color, area));
  return image::magnify(small, std::max(1, kThumbnail / std::max(small.width, small.height)));
}

}  // namespace strobe::live
