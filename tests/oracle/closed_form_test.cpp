// SPDX-License-Identifier: MIT
// The closed forms against published values, against each other, and against brute force: M samples of a step function
// are off by at most its variation / (2M), whatever the function.
#include "oracle/closed_form.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

namespace strobe::oracle {
namespace closed_form_test {

constexpr Window kAnchors[] = {kCloseAnchor, kCentreAnchor, kOpenAnchor};

double midpoints(Window window, int count, const std::function<double(double)>& colour_at) {
  double sum = 0;
  for (int i = 0; i < count; ++i) sum += colour_at(window.open + (window.close - window.open) * (i + 0.5) / count);
  return sum / count;
}

// A repeatable sequence in [0, 1) for jitter.
double hashed(int i) {
  double x = std::sin(i * 12.9898 + 4.1) * 43758.5453;
  return x - std::floor(x);
}

double jittered(Window window, int count, int seed, const std::function<double(double)>& colour_at) {
  double sum = 0;
  for (int i = 0; i < count; ++i)
    sum += colour_at(window.open + (window.close - window.open) * (i + hashed(seed * count + i)) / count);
  return sum / count;
}

// Rounding of the sums; the bounds themselves are exact.
constexpr double kRounding = 1e-9;

TEST(Edge, LeadingEdgeOfTheCloseAnchorIsARamp) {
  // 20 px over the exposure, ending with the edge at 160: .975, .925, ... .025 over the 20 pixels inside.
  for (int o = -20; o <= -1; ++o)
    EXPECT_NEAR(halfPlaneOverPixel(160, 20, kCloseAnchor, 160 + o), 0.975 - 0.05 * (o + 20), 1e-12) << o;
  EXPECT_NEAR(halfPlaneOverPixel(160, 20, kCloseAnchor, 139), 1, 1e-12);
  EXPECT_EQ(halfPlaneOverPixel(160, 20, kCloseAnchor, 160), 0);
}

TEST(Edge, CentreAndPixelAgreeAwayFromTheEndsOfTheRamp) {
  for (int i = 141; i < 159; ++i)
    EXPECT_NEAR(halfPlaneAtCentre(160, 20, kCloseAnchor, i), halfPlaneOverPixel(160, 20, kCloseAnchor, i), 1e-12);
}

TEST(Edge, AtRestItIsTheSharpImage) {
  EXPECT_EQ(halfPlaneAtCentre(10.4, 0, kCloseAnchor, 10), 0);
  EXPECT_EQ(halfPlaneAtCentre(10.6, 0, kCloseAnchor, 10), 1);
  EXPECT_NEAR(halfPlaneOverPixel(10.4, 0, kCloseAnchor, 10), 0.4, 1e-12);
}

TEST(Edge, SlowMotionTendsToTheSharpImage) {
  EXPECT_NEAR(halfPlaneOverPixel(10.4, 1e-6, kCloseAnchor, 10), 0.4, 1e-5);
  EXPECT_NEAR(halfPlaneOverPixel(10.4, -1e-6, kOpenAnchor, 10), 0.4, 1e-5);
}

TEST(Bar, NarrowerThanItsPathPeaksAtWidthOverPath) {
  double peak = 0;
  for (int i = 0; i < 64; ++i) peak = std::max(peak, barAtCentre(30, 35, 20, kCentreAnchor, i));
  EXPECT_NEAR(peak, 5.0 / 20, 1e-12);
}

TEST(Bar, MatchesTheGeneralIntegral) {
  for (Window window : kAnchors)
    for (double d : {0.0, 0.3, 7.25, -7.25, 20.0, -33.0})
      for (int i = 0; i < 128; ++i) {
        Strips strips{{40.3, 71.8, d, {1}}, {-kInfinity, kInfinity, 0, {0}}};
        ASSERT_NEAR(exposeCentre(strips, window, i).coverage, barAtCentre(40.3, 71.8, d, window, i), 1e-9) << d << i;
        ASSERT_NEAR(exposePixel(strips, window, i).coverage, barOverPixel(40.3, 71.8, d, window, i), 1e-9) << d << i;
      }
}

TEST(Bar, OverAStaticCheckerIsAMixture) {
  Pattern checker{0.4, 0.1, 8, 0};
  Strips strips{{40, 72, 20, {0.9}}, {-kInfinity, kInfinity, 0, checker}};
  for (int i = 0; i < 128; ++i) {
    double alpha = barOverPixel(40, 72, 20, kCloseAnchor, i);
    ASSERT_NEAR(exposePixel(strips, kCloseAnchor, i).colour, alpha * 0.9 + (1 - alpha) * checker.at(i + 0.5), 1e-9);
  }
}

// Three textured surfaces with motions of both signs, one hiding and showing another.
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
      ASSERT_NEAR(exact.colour, jittered(window, kCount, i, colour), exact.variation / kCount + kRounding) << i;
      ASSERT_LE(exact.variation, exact.changes * exact.jump + kRounding);
      total_changes += exact.changes;
    }
  EXPECT_GT(total_changes, 300);
}

TEST(Strips, JitteredSamplesAreUnbiased) {
  Strips strips = threeStrips();
  constexpr int kCount = 16, kRuns = 4000;
  for (int i : {70, 85, 100}) {
    Exposure exact = exposeCentre(strips, kCloseAnchor, i);
    double sum = 0;
    for (int run = 0; run < kRuns; ++run)
      sum += jittered(kCloseAnchor, kCount, run, [&](double t) { return seenAt(strips, i + 0.5, t).colour; });
    // Variance of a run is at most changes * J^2 / (4 M^2); five standard errors.
    double sigma = exact.jump * std::sqrt(exact.changes) / (2 * kCount) / std::sqrt(kRuns);
    EXPECT_NEAR(sum / kRuns, exact.colour, 5 * sigma + kRounding) << i;
  }
}

TEST(Strips, OverThePixelMatchBruteForceInSpaceAndTime) {
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

TEST(Strips, TimeReversalSwapsTheAnchors) {
  Strips strips = threeStrips(), reversed = strips;
  for (Strip& strip : reversed) strip.d = -strip.d;
  for (int i = 30; i < 140; ++i)
    ASSERT_NEAR(exposeCentre(strips, kCloseAnchor, i).colour, exposeCentre(reversed, kOpenAnchor, i).colour, 1e-12);
}

TEST(Strips, UniformMotionIsABoxFilter) {
  // Everything moves by 16 px over stripes of period 16: the mean of the two, everywhere.
  Strips strips{{-kInfinity, kInfinity, 16, {0.8, 0.2, 8, 3}}};
  for (int i = 0; i < 40; ++i) {
    EXPECT_NEAR(exposeCentre(strips, kCentreAnchor, i).colour, 0.5, 1e-12);
    EXPECT_NEAR(exposePixel(strips, kCentreAnchor, i).colour, 0.5, 1e-12);
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

TEST(Quad, AlignedAndMovingAlongXIsABar) {
  MovingPolygon picture{{{20, 10}, {40, 10}, {40, 30}, {20, 30}}, {12, 0}, {1}, {}, {0}};
  for (int x = 0; x < 64; ++x) {
    EXPECT_NEAR(exposeCentre(picture, kCloseAnchor, x, 15).coverage, barAtCentre(20, 40, 12, kCloseAnchor, x), 1e-12);
    EXPECT_EQ(exposeCentre(picture, kCloseAnchor, x, 30).coverage, 0);
  }
}

TEST(Quad, DiagonalMotionOfASquareIsTheOverlapOfTwoBars) {
  // The covering times are the intersection of those along x and along y.
  MovingPolygon picture{{{20, 10}, {40, 10}, {40, 30}, {20, 30}}, {10, 10}, {1}, {}, {0}};
  Exposure exact = exposeCentre(picture, kCloseAnchor, 35, 22);
  EXPECT_NEAR(exact.coverage, std::min((40 - 35.5) / 10, (30 - 22.5) / 10), 1e-12);
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

TEST(Rotation, WithinAWedgeTheAngleAloneDecides) {
  double angle = 0.9;
  RotatingPolygon picture = blade(angle);
  double from = std::atan2(-6, 28), to = std::atan2(6, 29);
  for (Window window : kAnchors)
    for (int y = 12; y < 52; ++y)
      for (int x = 33; x < 50; ++x) {
        if (std::hypot(x + 0.5 - 32, y + 0.5 - 32) > 24) continue;
        double covered = 0;
        for (auto [first, last] : wedgeIntervals(from, to, angle, window, std::atan2(y + 0.5 - 32, x + 0.5 - 32)))
          covered += last - first;
        ASSERT_NEAR(exposeCentre(picture, window, x, y).coverage, covered, 1e-9) << x << " " << y;
      }
}

TEST(Rotation, AFullTurnCoversEveryDirectionEqually) {
  double turn = 2 * std::numbers::pi;
  double share = (std::atan2(6, 29) - std::atan2(-6, 28)) / turn;
  for (auto [x, y] : {std::pair{40, 30}, {20, 30}, {33, 50}, {10, 22}})
    EXPECT_NEAR(exposeCentre(blade(turn), kCentreAnchor, x, y).coverage, share, 1e-9);
}

}  // namespace closed_form_test
}  // namespace strobe::oracle
