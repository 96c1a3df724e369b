// SPDX-License-Identifier: MIT
// Shutter curves compared with hand-computed integrals, and bit for bit with their own mirror images.
#include "math/shutter_curve.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "base/error.h"

namespace strobe {
namespace shutter_curve_test {

// A curve and its integral up to time t.
struct Case {
  std::string text;
  std::function<double(double)> share;
  double tolerance = 1e-9;
};

double erfShare(double sigma, double reach, double t) {
  double at = std::clamp(t - .5, -reach, reach), whole = std::erf(reach / sigma / std::sqrt(2));
  return .5 + .5 * std::erf(at / sigma / std::sqrt(2)) / whole;
}

const std::vector<Case>& cases() {
  static const std::vector<Case> cases = {
      {"triangle", [](double t) { return t < .5 ? 2 * t * t : 1 - 2 * (1 - t) * (1 - t); }},
      {"trapezoid",  // opening and closing take 1/4 each: area 3/4
       [](double t) {
         if (t < .25) return 2 * t * t / .75;
         return t < .75 ? (.125 + (t - .25)) / .75 : 1 - 2 * (1 - t) * (1 - t) / .75;
       }},
      {"trapezoid:0.5,0", [](double t) { return t < .5 ? t * t / .75 : (.25 + (t - .5)) / .75; }},
      // Piecewise linear with 61 knots: the density has an error of at most h^2/8 times its second derivative.
      {"gaussian", [](double t) { return erfShare(1. / 6, .5, t); }, 1e-3},
      {"gaussian:0.05", [](double t) { return erfShare(.05, .2, t); }, 2e-3},
      {"0,1", [](double t) { return t * t; }},
      {"3,1", [](double t) { return (3 * t - t * t) / 2; }},
      // Open twice, closed in between.
      {"0=1,0.25=1,0.25=0,0.75=0,0.75=1,1=1",
       [](double t) { return t < .25   ? 2 * t
                             : t < .75 ? .5
                                       : .5 + 2 * (t - .75); }},
  };
  return cases;
}

TEST(ShutterCurve, SharesAreIntegralsAndTimesTheirInverse) {
  for (const Case& one : cases()) {
    ShutterCurve curve = ShutterCurve::from(one.text);
    EXPECT_FALSE(curve.isBox());
    for (int i = 0; i <= 200; ++i) {
      double at = i / 200.;
      EXPECT_NEAR(curve.shareBefore(at), one.share(at), one.tolerance) << one.text << " " << at;
      double time = curve.timeOf(at);
      EXPECT_NEAR(one.share(time), at, one.tolerance) << one.text << " " << at;
      EXPECT_GE(time, 0);
      EXPECT_LE(time, 1);
    }
  }
}

TEST(ShutterCurve, MirrorImagesAreMirroredBitForBit) {
  const std::pair<std::string, std::string> pairs[] = {
      {"triangle", "triangle"},
      {"trapezoid", "trapezoid"},
      {"trapezoid:0.1,0.3", "trapezoid:0.3,0.1"},
      {"gaussian", "gaussian"},
      {"gaussian:0.07", "gaussian:0.07"},
      {"0.2,1,0.5", "0.5,1,0.2"},
      {"0=1,0.3=1,0.3=0,1=0.5", "0=0.5,0.7=0,0.7=1,1=1"},
  };
  for (const auto& [text, back] : pairs) {
    ShutterCurve curve = ShutterCurve::from(text), mirrored = ShutterCurve::from(back);
    for (int end : {0, 1}) {
      const auto &a = curve.knotsFrom(end), &b = mirrored.knotsFrom(1 - end);
      ASSERT_EQ(a.size(), b.size()) << text;
      ASSERT_LE(a.size(), ShutterCurve::kMostKnots);
      for (size_t i = 0; i < a.size(); ++i) {
        EXPECT_EQ(a[i].distance, b[i].distance) << text;
        EXPECT_EQ(a[i].share, b[i].share) << text;
        EXPECT_EQ(a[i].weight, b[i].weight) << text;
      }
    }
    for (int i = 0; i <= 32; ++i)
      EXPECT_EQ(mirrored.timeOf(1 - i / 64.), 1 - curve.timeOf(i / 64.)) << text << " " << i;
  }
}

TEST(ShutterCurve, ConstantWeightsAreABox) {
  for (const char* text : {"box", "1,1", "2,2,2", "trapezoid:0,0", "0=3,0.3=3,1=3"}) {
    ShutterCurve curve = ShutterCurve::from(text);
    EXPECT_TRUE(curve.isBox()) << text;
    for (double share : {0., .1, 1. / 3, .7, 1.}) EXPECT_EQ(curve.timeOf(share), share);
  }
}

std::string refusal(const std::string& text) {
  try {
    ShutterCurve::from(text);
  } catch (const Error& error) {
    EXPECT_EQ(error.exitCode(), 2);
    return error.what();
  }
  return "accepted";
}

TEST(ShutterCurve, MistakesAreNamed) {
  const std::pair<std::string, std::string> mistakes[] = {
      {"", "is not one of box"},
      {"boxy", "did you mean 'box'?"},
      {"box:1", "is not one of box"},
      {"trapezoid:0.6,0.6", "their sum at most 1"},
      {"trapezoid:-0.1,0", "their sum at most 1"},
      {"trapezoid:0.5", "the number of values after ':' must be 2"},
      {"trapezoid:a,b", "'a' is not a number"},
      {"gaussian:0", "0.01 to 10"},
      {"1", "2 to 62 weights"},
      {"0,0", "the area under the curve is close to 0"},
      {"1,-1", "a weight is below 0"},
      {"0=1,0.5=1", "the times must start at 0 and end at 1"},
      {"0=1,0.6=1,0.5=1,1=1", "the times must not decrease"},
      {"0=1,1", "'1' is not TIME=WEIGHT"},
      {"1,,1", "'' is not a number"},
      {"1e999,1", "is not a number"},
  };
  for (const auto& [text, part] : mistakes) EXPECT_NE(refusal(text).find(part), std::string::npos) << refusal(text);
}

}  // namespace shutter_curve_test
}  // namespace strobe
