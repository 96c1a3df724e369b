// SPDX-License-Identifier: MIT
#include "image/regions.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "base/error.h"

namespace strobe::image {

namespace {

int coloursOf(const Image& image) { return std::min(image.channels, 3); }

// Calls `visit(x, y, difference)` for each selected pixel with the largest difference of its channels.
template <class Visit>
void forDifferences(const Image& a, const Image& b, const Image& mask, Visit visit) {
  bool alike = sameSize(a, b) && coloursOf(a) == coloursOf(b);
  STROBE_ASSERT(alike, "{}x{}x{} and {}x{}x{}", a.width, a.height, a.channels, b.width, b.height, b.channels);
  forPixels(a, mask, [&](int x, int y) {
    double largest = 0;
    for (int c = 0; c < coloursOf(a); ++c) {
      double difference = std::abs(double(a.at(x, y, c)) - b.at(x, y, c));
      largest = std::max(largest, std::isnan(difference) ? std::numeric_limits<double>::infinity() : difference);
    }
    visit(x, y, largest);
  });
}

}  // namespace

bool isIn(const Image& mask, int x, int y) { return mask.empty() || mask.at(x, y, 0) >= 0.5f; }

double contrast(const Image& image, const Image& mask) {
  std::array<double, 3> sum{}, squares{};
  double count = 0, variance = 0;
  forPixels(image, mask, [&](int x, int y) {
    ++count;
    for (int c = 0; c < coloursOf(image); ++c) {
      double value = image.at(x, y, c);
      sum[size_t(c)] += value;
      squares[size_t(c)] += value * value;
    }
  });
  if (count == 0) return std::numeric_limits<double>::quiet_NaN();
  for (size_t c = 0; c < size_t(coloursOf(image)); ++c)
    variance += std::max(0.0, squares[c] / count - sum[c] / count * (sum[c] / count));
  return std::sqrt(variance / coloursOf(image));
}

double largestColour(const Image& image, const Image& mask) {
  double largest = 0;
  forPixels(image, mask, [&](int x, int y) {
    for (int c = 0; c < coloursOf(image); ++c) largest = std::max(largest, std::abs(double(image.at(x, y, c))));
  });
  return largest;
}

Difference largestDifference(const Image& a, const Image& b, const Image& mask) {
  Difference largest;
  forDifferences(a, b, mask, [&](int x, int y, double difference) {
    if (difference > largest.value) largest = {difference, x, y};
  });
  return largest;
}

NotFinite notFiniteIn(const Image& image) {
  NotFinite found;
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x)
      for (int c = 0; c < coloursOf(image); ++c) {
        float value = image.at(x, y, c);
        if (std::isfinite(value)) continue;
        if (found.pixels++ == 0) found.x = x, found.y = y, found.value = value;
        break;
      }
  return found;
}

int countDifferent(const Image& a, const Image& b, double tolerance, const Image& mask) {
  int count = 0;
  forDifferences(a, b, mask, [&](int, int, double difference) { count += difference > tolerance; });
  return count;
}

}  // namespace strobe::image
