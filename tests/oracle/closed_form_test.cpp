// SPDX-License-Identifier: MIT
// The closed forms against brute force: M midpoint samples of a step function are off by at most its variation / (2M).
#include "oracle/closed_form.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

namespace strobe::oracle {
namespace closed_form_test {

constexpr Window kAnchors[] = {kCloseAnchor, kCentreAnchor, kOpenAnchor};

double midpoints(Window window, int count, const std::function<double(double)>& colour_at) {
  double sum = 0;
  for (int i = 0; i < count; ++i) sum += colour_at(window.open + (window.close - window.open) * (i + 0.5) / count);
  return sum / count;
}

// Rounding of the sums; the bounds themselves are exact.
constexpr double kRounding = 1e-9;

// Three textured surfaces that move both ways: one hides and uncovers another.
Strips threeStrips() {
  return {{60.2, 90.7, 17.3, {0.9, 0.6, 6, 60.2}},
          {80.4, 110.1, -9.1, {0.7, 0.2, 5, 3}},
          {-kInfinity, kInfinity, -4.7, {0.4, 0.1, 8, 1.5}}};
}

TEST(Strips, MatchBruteForceWithinItsBound) {
  constexpr int kCount = 2000;
  Strips strips = threeStrips();
  int total_changes = 0;
  for (Window window : kAnchors)
    for (int i = 30; i < 140; ++i) {
      Exposure exact = exposeCentre(strips, window, i);
      auto colour = [&](double t) { return seenAt(strips, i + 0.5, t).colour; };
      ASSERT_NEAR(exact.colour, midpoints(window, kCount, colour), exact.variation / (2 * kCount) + kRounding) << i;
      ASSERT_LE(exact.variation, exact.changes * exact.jump + kRounding);
      total_changes += exact.changes;
    }
  EXPECT_GT(total_changes, 300);
}

TEST(Strips, PixelMeansMatchBruteForceInSpaceAndTime) {
  constexpr int kTimes = 1000, kPlaces = 64;
  Strips strips = threeStrips();
  for (Window window : kAnchors)
    for (int i : {55, 61, 70, 78, 88, 95, 104}) {
      double brute = 0;
      for (int s = 0; s < kPlaces; ++s)
        brute += midpoints(window, kTimes, [&](double t) { return seenAt(strips, i + (s + 0.5) / kPlaces, t).colour; });
      // Few of the step lines in the (x, t) square are parallel to its sides, so the error is far below 1 / kPlaces.
      EXPECT_NEAR(exposePixel(strips, window, i).colour, brute / kPlaces, 1e-3) << i;
    }
}

MovingPolygon slantedQuad(bool flipped) {
  MovingPolygon picture{{{20.3, 12.1}, {50.2, 16.8}, {45.9, 40.4}, {17.6, 33.3}},
                        {11.5, -6.25},
                        {0.9, 0.6, 4, 1, 2},
                        {-3.5, 2.25},
                        {0.4, 0.1, 8, 0, 0}};
  if (flipped) std::reverse(picture.corners.begin(), picture.corners.end());
  return picture;
}

TEST(Quad, MatchesBruteForceWithinItsBound) {
  constexpr int kCount = 500;
  for (Window window : kAnchors)
    for (bool flipped : {false, true}) {
      MovingPolygon picture = slantedQuad(flipped);
      for (int y = 0; y < 56; y += 3)
        for (int x = 0; x < 72; x += 2) {
          Exposure exact = exposeCentre(picture, window, x, y);
          double brute = midpoints(window, kCount, [&](double t) {
            return seenAt(picture, {x + 0.5, y + 0.5}, t).colour;
          });
          ASSERT_NEAR(exact.colour, brute, exact.variation / (2 * kCount) + kRounding) << x << " " << y;
        }
    }
}

RotatingPolygon blade(double angle) {
  return {{{32, 32}, {60, 26}, {61, 38}}, {32, 32}, angle, 1, {0.4, 0.1, 8, 0, 0}};
}

TEST(Rotation, MatchesBruteForceWithinItsBound) {
  constexpr int kCount = 1000;
  for (Window window : kAnchors)
    for (double angle : {0.0, 0.4, -1.3, 4.0, 9.0}) {
      RotatingPolygon picture = blade(angle);
      for (int y = 1; y < 64; y += 5)
        for (int x = 0; x < 64; x += 3) {
          Exposure exact = exposeCentre(picture, window, x, y);
          double brute = midpoints(window, kCount, [&](double t) {
            return seenAt(picture, {x + 0.5, y + 0.5}, t).colour;
          });
          ASSERT_NEAR(exact.colour, brute, exact.variation / (2 * kCount) + kRounding) << angle << " " << x << " " << y;
        }
    }
}

}  // namespace closed_form_test
}  // namespace strobe::oracle
