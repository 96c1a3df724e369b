// SPDX-License-Identifier: MIT
#include "live/gathered_truth.h"

#include "base/log.h"
#include "image/metrics.h"

namespace strobe::live {

static const double kTurn_s = 0.03;  // time limit of a turn, so that the window stays responsive

std::string GatheredTruth::keyOf(const lab::Shot& shot) {
  lab::Shot truth = shot;
  truth.pipeline.clear();
  truth.taps.clear();
  truth.aa = 1;
  truth.sets = lab::sceneSettings(shot.sets);
  return lab::canonical(truth);
}

int GatheredTruth::samples(const lab::Shot& shot) const { return key_ == keyOf(shot) ? truth_.samples() : 0; }

bool GatheredTruth::isComplete(const lab::Shot& shot) const { return samples(shot) >= kEnough || !problem_.empty(); }

bool GatheredTruth::gather(const lab::Shot& shot, const std::function<bool()>& felt) {
  bool anew = keyOf(shot) != key_;
  if (!anew && isComplete(shot)) return false;
  double started_s = clockSeconds();
  try {
    if (anew) {
      problem_.clear();
      key_ = keyOf(shot);
      truth_.restart(shot);
    }
    auto in_time = [&] { return clockSeconds() - started_s < kTurn_s; };
    auto goes_on = [&] { return !felt || in_time() || !felt(); };
    while (truth_.step(kEnough - truth_.samples(), goes_on) && in_time()) continue;
  } catch (const Error& error) {
    problem_ = error.what();
  }
  return true;
}

std::optional<double> GatheredTruth::errorOf(const lab::Shot& shot, const image::Image& color) const {
  if (samples(shot) == 0 || !image::sameSize(color, mean())) return {};
  return image::rootMeanSquaredError(color, mean());
}

}  // namespace strobe::live
