// SPDX-License-Identifier: MIT
#include "page/number.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace strobe::page {

std::string shownError(double value) {
  if (std::isnan(value)) return kNotMeasured;
  if (value == 0) return "0";
  if (std::abs(value) < 1e-6) return fmt::format("{:.1e}", value);
  int digits = 1 - int(std::floor(std::log10(std::abs(value))));
  return fmt::format("{:.{}f}", value, std::max(5, digits));
}

std::string shownShare(double share) {
  if (std::isnan(share)) return kNotMeasured;
  double percent = 100 * share;
  if (percent == 0) return "0 %";
  if (percent < 1e-3) return fmt::format("{:.1e} %", percent);
  int digits = std::max(0, 2 - int(std::floor(std::log10(percent))));
  return fmt::format("{:.{}f} %", percent, digits);
}

std::string shownCount(double count) { return std::isnan(count) ? kNotMeasured : fmt::format("{:.0f}", count); }

std::string shownMs(double ms) {
  if (std::isnan(ms)) return kNotMeasured;
  return ms < 10 ? fmt::format("{:.2f} ms", ms) : fmt::format("{:.0f} ms", ms);
}

std::string shownPixels(double pixels) {
  return std::abs(pixels) < 999.5 ? fmt::format("{:.1f}", pixels) : fmt::format("{:.0f}", pixels);
}

static std::string superscript(int number) {
  static const char* const kDigits[] = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  std::string text;
  for (char c : std::to_string(number)) text += c == '-' ? "⁻" : kDigits[c - '0'];
  return text;
}

std::string shownNumber(double value) {
  if (value == 0) return "0";
  double power = std::log10(std::abs(value));
  if (power > -3.5 && power < 4.5) return fmt::format("{:g}", value);
  int whole = int(std::floor(power + 1e-9));
  double front = value / std::pow(10.0, whole);
  return (std::abs(front - 1) < 1e-9 ? "" : fmt::format("{:g}·", front)) + "10" + superscript(whole);
}

}  // namespace strobe::page
