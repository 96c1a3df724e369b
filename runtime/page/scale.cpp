// SPDX-License-Identifier: MIT
#include "page/scale.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "page/number.h"

namespace strobe::page {

namespace {

constexpr double kZeroShare = 0.07;  // share of a logarithmic axis for the value 0 and the gap after it

// Round an exponent to 1, 3 or 10 times a power of ten.
double roundedDown(double power) {
  double whole = std::floor(power + 1e-9);
  return power - whole >= std::log10(3.0) - 1e-9 ? whole + std::log10(3.0) : whole;
}

double roundedUp(double power) {
  double whole = std::ceil(power - 1e-9);
  return whole - power >= 1 - std::log10(3.0) - 1e-9 ? whole - 1 + std::log10(3.0) : whole;
}

}  // namespace

Scale::Scale(Kind kind, const std::vector<double>& values, bool rounded) : kind_(kind), values_(values) {
  std::erase_if(values_, [](double value) { return !std::isfinite(value); });
  std::sort(values_.begin(), values_.end());
  values_.erase(std::unique(values_.begin(), values_.end()), values_.end());
  if (isListed()) return;
  std::vector<double> used;
  for (double value : values_) {
    if (kind == Kind::log && value == 0) zero_ = true;
    else if (kind == Kind::linear) used.push_back(value);
    else if (value > 0) used.push_back(std::log10(value));
  }
  if (used.empty()) return;
  low_ = used.front();
  high_ = used.back();
  if (rounded && kind == Kind::log) low_ = roundedDown(low_), high_ = roundedUp(high_);
  if (high_ - low_ < 1e-9 * std::max(1.0, std::abs(low_))) high_ = low_ + std::max(1.0, std::abs(low_));
  if (kind != Kind::linear) return;
  step_ = niceStep();
  if (rounded) low_ = step_ * std::floor(low_ / step_ + 1e-9), high_ = step_ * std::ceil(high_ / step_ - 1e-9);
}

double Scale::gap() const { return zero_ ? kZeroShare : 0; }

double Scale::slot() const { return kind_ == Kind::slots && !values_.empty() ? 1.0 / double(values_.size()) : 0; }

double Scale::at(double value) const {
  if (isListed()) {
    if (values_.empty()) return 0;
    size_t i = size_t(std::lower_bound(values_.begin(), values_.end(), value) - values_.begin());
    i = std::min(i, values_.size() - 1);
    if (kind_ == Kind::slots) return (double(i) + 0.5) * slot();
    return values_.size() < 2 ? 0 : double(i) / double(values_.size() - 1);
  }
  if (kind_ == Kind::linear) return std::clamp((value - low_) / (high_ - low_), 0.0, 1.0);
  if (value <= 0) return 0;
  return gap() + (1 - gap()) * std::clamp((std::log10(value) - low_) / (high_ - low_), 0.0, 1.0);
}

// Labels at powers of ten, also at 2 and 5 times them if the scale has less than 2.2 decades. Small ticks between the
// labels, up to 8 decades.
std::vector<Tick> Scale::logTicks() const {
  std::vector<Tick> ticks;
  if (zero_) ticks.push_back({0, "0"});
  double span = high_ - low_;
  for (int power = int(std::floor(low_)); power <= int(std::ceil(high_)); ++power)
    for (int digit = 1; digit <= 9; ++digit) {
      double exponent = power + std::log10(double(digit));
      if (exponent < low_ - 1e-9 || exponent > high_ + 1e-9) continue;
      bool large = digit == 1 || (span < 2.2 && (digit == 2 || digit == 5));
      if (!large && span > 8) continue;
      double value = std::strtod(fmt::format("{}e{}", digit, power).c_str(), nullptr);
      ticks.push_back({at(value), large ? shownNumber(value) : ""});
    }
  return ticks;
}

// Step of about an eighth of the range: 1, 1.5, 2, 3, 5 or 10 times a power of ten.
double Scale::niceStep() const {
  double raw = (high_ - low_) / 8, power = std::pow(10.0, std::floor(std::log10(raw)));
  for (double factor : {1.0, 1.5, 2.0, 3.0, 5.0})
    if (factor * power >= raw) return factor * power;
  return power * 10;
}

std::vector<Tick> Scale::linearTicks() const {
  std::vector<Tick> ticks;
  double first = std::ceil(low_ / step_ - 1e-9);
  for (int i = 0; (first + i) * step_ <= high_ + 1e-9 * step_; ++i) {
    double value = (first + i) * step_;
    ticks.push_back({at(value), shownNumber(value)});
  }
  return ticks;
}

std::vector<Tick> Scale::ticks() const {
  if (kind_ == Kind::log) return logTicks();
  if (kind_ == Kind::linear) return linearTicks();
  std::vector<Tick> ticks;
  for (double value : values_) ticks.push_back({at(value), shownNumber(value)});
  return ticks;
}

}  // namespace strobe::page
