// SPDX-License-Identifier: MIT
// Curved paths against rotations in closed form, and against straight paths without rotation. The tests catch a wrong
// coefficient, bound or time of an arc or parabola, each at the wheel or blade with the largest effect; a curved search
// that misses a turning surface; curves that change straight paths; and curves from earlier frames across a cut.
#include <algorithm>
#include <map>

#include "common/refusal.h"
#include "oracle/render.h"

namespace strobe::oracle {
namespace render_curves_test {

constexpr int kSide = 96;
constexpr double kDegrees = 60;

lab::Shot wedge() { return shotOf("wedge", kSide, kSide, {{"from", 20}, {"to", 65}, {"degrees", kDegrees}}); }

glm::dvec2 turned(glm::dvec2 p, double t) {
  double angle = -glm::radians(kDegrees * t);  // y points down
  return {std::cos(angle) * p.x - std::sin(angle) * p.y, std::sin(angle) * p.x + std::cos(angle) * p.y};
}

// Position relative to the middle of the picture, px.
glm::dvec2 placeOf(int x, int y, int height = kSide) {
  return glm::dvec2(x + .5, y + .5) - glm::dvec2(kSide, height) / 2.;
}

RotatingPolygon exactWedge() {
  RotatingPolygon wedge{{{kSide / 2., kSide / 2.}}, {kSide / 2., kSide / 2.}};
  wedge.angle = -glm::radians(kDegrees);
  for (double direction : {20.0, 42.5, 65.0}) {
    double phi = glm::radians(direction), radius = 4 * kSide;
    wedge.corners.push_back({kSide / 2. + radius * std::cos(phi), kSide / 2. - radius * std::sin(phi)});
  }
  return wedge;
}

// Root mean square error over the pixels whose surfaces stay in the picture; with `inside`, only over pixels with the
// wedge at the raster time.
double errorOf(const lab::Picture& picture, Window window, bool inside = false) {
  const RotatingPolygon exact = exactWedge();
  double sum = 0;
  int count = 0;
  for (int y = 0; y < kSide; ++y)
    for (int x = 0; x < kSide; ++x) {
      if (glm::length(placeOf(x, y)) > kSide / 2. - 1) continue;
      if (inside && imageOf(picture, "velocity").at(x, y, 0) == 0) continue;
      sum += std::pow(colorOf(picture).at(x, y, 0) - exposeCentre(exact, window, x, y).colour, 2);
      ++count;
    }
  return std::sqrt(sum / count);
}

// Wedges evenly around a hub that moves left by `slide` px over the exposure: points follow cycloids.
struct Wheel {
  std::string what;
  double from, to;  // degrees from +x, y up
  int blades;
  double slide;
  double hub;  // px; closer to the hub a blade is narrower than 3 px and may be missed
  double degrees = kDegrees;
  int height = kSide;     // of the picture
  double slides_off = 0;  // px to the right over the exposure, of cards that cover the right half at the raster time
};

lab::Shot shotOfWheel(const Wheel& wheel) {
  return shotOf("wedge", kSide, wheel.height,
                {{"from", wheel.from},
                 {"to", wheel.to},
                 {"degrees", wheel.degrees},
                 {"blades", double(wheel.blades)},
                 {"slide", wheel.slide},
                 {"slides_off", wheel.slides_off}});
}

// True if the point of the picture is on a blade.
bool isOnBlade(const Wheel& wheel, glm::dvec2 place, double t) {
  const glm::dvec2 own = place + glm::dvec2(wheel.slide * t, 0);
  const double apart = 360.0 / wheel.blades;
  const double angle = glm::degrees(std::atan2(-own.y, own.x)) - wheel.degrees * t - wheel.from;
  return angle - apart * std::floor(angle / apart) < wheel.to - wheel.from;
}

// Exact coverage of the pixels beyond the hub whose surfaces stay in the picture; NaN for other pixels. With cards,
// only pixels with a blade at the raster time count: at other pixels a blade is found only where a tap along the cards'
// motion meets it.
std::vector<double> coverageOf(const Wheel& wheel, Window window) {
  constexpr int kTimes = 1024;
  std::vector<double> coverage(size_t(kSide * wheel.height), NAN);
  int count = 0;
  for (int y = 0; y < wheel.height; ++y)
    for (int x = 0; x < kSide; ++x) {
      const glm::dvec2 place = placeOf(x, y, wheel.height);
      auto timeOf = [&](int k) { return glm::mix(window.open, window.close, (k + .5) / kTimes); };
      double nearest = INFINITY, farthest = 0, covered = 0;
      for (int k = 0; k < kTimes; ++k) {
        const double from_hub = glm::length(place + glm::dvec2(wheel.slide * timeOf(k), 0));
        nearest = std::min(nearest, from_hub), farthest = std::max(farthest, from_hub);
        bool hidden = wheel.slides_off > 0 && place.x >= wheel.slides_off * timeOf(k);
        covered += isOnBlade(wheel, place, timeOf(k)) && !hidden;
      }
      if (wheel.slides_off > 0 && !isOnBlade(wheel, place, 0)) continue;
      if (nearest < wheel.hub || farthest > kSide / 2. - 1 - wheel.slide) continue;
      coverage[size_t(y * kSide + x)] = covered / kTimes;
      ++count;
    }
  EXPECT_GT(count, 300) << wheel.what;
  return coverage;
}

// Root mean square error over the pixels with a coverage.
double errorOf(const std::vector<double>& coverage, const lab::Picture& picture) {
  double sum = 0;
  int count = 0;
  for (size_t i = 0; i < coverage.size(); ++i) {
    if (std::isnan(coverage[i])) continue;
    sum += std::pow(colorOf(picture).at(int(i % kSide), int(i / kSide), 0) - coverage[i], 2);
    ++count;
  }
  return std::sqrt(sum / count);
}

class RenderCurves : public RenderTest {
 protected:
  static lab::Picture drawn(const Wheel& wheel, const std::string& curve, const Anchor& anchor) {
    return render(
        with(shotOfWheel(wheel), hybridSteps(), {"mask=all", "samples=64", "trajectory=" + curve}, anchor.name));
  }
};

// A parabola passes through the point's position at both ends and in the middle of the exposure.
TEST_F(RenderCurves, ParabolasPassThroughExactPositions) {
  for (const Anchor& anchor : anchors()) {
    lab::Shot shot = with(wedge(), "hybrid_layered", {"trajectory=quadratic"}, anchor.name);
    shot.taps = {"raster_curve.curve"};
    lab::Picture picture = render(shot);
    const image::Image& curve = picture.frame.taps.at("raster_curve.curve").floats;
    int seen = 0;
    for (int y = 0; y < kSide; ++y)
      for (int x = 0; x < kSide; ++x) {
        if (imageOf(picture, "velocity").at(x, y, 0) == 0) continue;
        ++seen;
        auto at = [&](double u) { return turned(placeOf(x, y), glm::mix(anchor.window.open, anchor.window.close, u)); };
        auto fromLine = [&](double u) { return at(u) - glm::mix(at(0), at(1), u); };
        const glm::dvec2 b = fromLine(.5);
        for (int k = 0; k < 2; ++k) EXPECT_NEAR(curve.at(x, y, k), b[k], 1e-3) << anchor.name;
        for (int k = 2; k < 4; ++k) EXPECT_EQ(curve.at(x, y, k), 0) << anchor.name;
      }
    EXPECT_GT(seen, 500);
  }
}

// Cells of one pixel. Their bounds, as straight displacements from the raster time, contain the point at all times and
// its displacement over the exposure. They exceed these by at most 1.25 times the path deviation of a sixteenth of the
// arc.
TEST_F(RenderCurves, BoundsOfArcsContainEveryPoint) {
  for (const Anchor& anchor : anchors()) {
    std::vector<std::string> settings = {"trajectory=arc"};
    for (const char* node : {"raster_bounds", "revealed_bounds", "classify_cells", "composite"})
      settings.push_back(fmt::format("{}.cell_side=1", node));
    lab::Shot shot = with(wedge(), "hybrid_layered", settings, anchor.name);
    shot.taps = {"raster_bounds.bounds"};
    const lab::Picture picture = render(shot);
    const image::Image& bounds = picture.frame.taps.at(shot.taps[0]).floats;
    const double open = anchor.window.open, close = anchor.window.close, far = -open > close ? open : close;
    int seen = 0;
    for (int y = 0; y < kSide; ++y)
      for (int x = 0; x < kSide; ++x) {
        if (imageOf(picture, "velocity").at(x, y, 0) == 0) continue;
        ++seen;
        const glm::dvec2 place = placeOf(x, y);
        glm::dvec2 low = turned(place, close) - turned(place, open), high = low;
        for (int k = 0; k <= 256; ++k) {
          const glm::dvec2 there = (turned(place, glm::mix(open, close, k / 256.)) - place) / far;
          low = glm::min(low, there), high = glm::max(high, there);
        }
        const double bulge = glm::length(place) * std::pow(glm::radians(kDegrees) / 16, 2) / 8;
        const double wider = 1.25 * bulge / std::abs(far);
        for (int k = 0; k < 2; ++k) {
          // The curve is known to 1e-3 px; the positions here are 256 samples.
          EXPECT_LE(bounds.at(x, y, k), low[k] + 5e-3) << anchor.name << ' ' << x << ' ' << y;
          EXPECT_GE(bounds.at(x, y, k), low[k] - wider - 5e-3) << anchor.name << ' ' << x << ' ' << y;
          EXPECT_GE(bounds.at(x, y, 2 + k), high[k] - 5e-3) << anchor.name << ' ' << x << ' ' << y;
          EXPECT_LE(bounds.at(x, y, 2 + k), high[k] + wider + 5e-3) << anchor.name << ' ' << x << ' ' << y;
        }
      }
    EXPECT_GT(seen, 500) << anchor.name;
  }
}

TEST_F(RenderCurves, CurvesFollowATurningWedge) {
  for (const Anchor& anchor : anchors()) {
    std::map<std::string, double> errors;
    for (const char* curve : {"line", "quadratic", "arc"})
      errors[curve] =
          errorOf(render(with(wedge(), hybridSteps(), {"mask=all", "samples=64", fmt::format("trajectory={}", curve)},
                              anchor.name)),
                  anchor.window);
    EXPECT_LE(errors["arc"], errors["line"] / 5) << anchor.name;
    EXPECT_LE(errors["quadratic"], errors["line"] / 5) << anchor.name;
    EXPECT_LE(errors["arc"], errors["quadratic"] + 1e-3) << anchor.name;
    for (const auto& [curve, error] : errors) fmt::print("{} {}: {:.4f}\n", anchor.name, curve, error);
  }
}

TEST_F(RenderCurves, ArcsFollowABladeAndARollingWheel) {
  for (const Wheel& wheel :
       {Wheel{"blade", 30, 50, 1, 0, 8}, Wheel{"wheel", 0, 45, 4, 20, 4}, Wheel{"fan", 0, 30, 5, 0, 6}})
    for (const Anchor& anchor : anchors()) {
      std::map<std::string, double> errors;
      const std::vector<double> coverage = coverageOf(wheel, anchor.window);
      for (const char* curve : {"line", "arc"}) errors[curve] = errorOf(coverage, drawn(wheel, curve, anchor));
      EXPECT_LE(errors["arc"], errors["line"] / 5) << wheel.what << ", " << anchor.name;
      fmt::print("{} {}: {:.4f}, {:.4f}\n", wheel.what, anchor.name, errors["line"], errors["arc"]);
    }
}

// An arc holds the angle of rotation for any motion of its centre, also over a full turn with equal ends.
TEST_F(RenderCurves, ArcsHoldTheAngleOfRotation) {
  for (double slide : {0., 15.})
    for (double degrees : {30., 170., 360., 430.})
      for (const Anchor& anchor : anchors()) {
        const std::string what = fmt::format("{}, {} degrees, {} px", anchor.name, degrees, slide);
        lab::Shot shot =
            with(shotOfWheel({what, 20, 65, 1, slide, 0, degrees}), "hybrid_layered", {"trajectory=arc"}, anchor.name);
        shot.taps = {"raster_curve.curve"};
        const lab::Picture picture = render(shot);
        const image::Image& curve = picture.frame.taps.at("raster_curve.curve").floats;
        int seen = 0;
        for (int y = 0; y < kSide; ++y)
          for (int x = 0; x < kSide; ++x) {
            if (glm::length(placeOf(x, y)) < 4 || (curve.at(x, y, 0) == 0 && curve.at(x, y, 1) == 0)) continue;
            ++seen;
            EXPECT_NEAR(curve.at(x, y, 2), 0, 5e-3) << what;
            EXPECT_NEAR(curve.at(x, y, 3), -glm::radians(degrees), 5e-3) << what;  // y points down
          }
        EXPECT_GT(seen, 500) << what;
      }
}

// Rotations beyond a sixth of a turn, the limit of parabolas.
TEST_F(RenderCurves, ArcsFollowLongerRotationsThanParabolas) {
  for (const Wheel& wheel : {Wheel{"half a turn", 20, 65, 1, 0, 4, 180}, Wheel{"a full turn", 20, 65, 1, 0, 4, 360},
                             Wheel{"rolls", 0, 45, 3, 12, 6, 300}})
    for (const Anchor& anchor : anchors()) {
      std::map<std::string, double> errors;
      const std::vector<double> coverage = coverageOf(wheel, anchor.window);
      for (const char* curve : {"line", "quadratic", "arc"})
        errors[curve] = errorOf(coverage, drawn(wheel, curve, anchor));
      const std::string what = wheel.what + ", " + anchor.name;
      EXPECT_LE(errors["arc"], errors["line"] / 5) << what;
      EXPECT_LE(errors["arc"], errors["quadratic"] / 2) << what;
      fmt::print("{}: {:.4f}, {:.4f}, {:.4f}\n", what, errors["line"], errors["quadratic"], errors["arc"]);
    }
}

// Without rotation no curve is computed, and the picture equals the one with straight paths.
TEST_F(RenderCurves, StraightPathsCostNothing) {
  auto drawn = [&](const lab::Shot& shot, const std::string& curve) {
    return render(with(shot, "hybrid_layered", {"trajectory=" + curve}));
  };
  const lab::Shot slides = shotOf("textured_bar", 64, 24);
  const lab::Picture line = drawn(slides, "line");
  for (const char* curve : {"quadratic", "arc"}) {
    const lab::Picture curved = drawn(slides, curve);
    EXPECT_TRUE(identical(colorOf(line), colorOf(curved))) << curve;
    for (const auto& step : curved.frame.times) EXPECT_EQ(step.name.find("_curve"), std::string::npos) << step.name;
    const lab::Picture turned = drawn(wedge(), curve);
    bool runs = std::any_of(turned.frame.times.begin(), turned.frame.times.end(),
                            [](const auto& step) { return step.name == "raster_curve"; });
    EXPECT_TRUE(runs) << curve;
  }
}

// A card with straight motion, farther from the turning blade than either moves, is blurred as with straight paths.
TEST_F(RenderCurves, RotationDoesNotChangeStraightPathsBesideIt) {
  const lab::Shot shot = shotOf("beside", 160, 32);
  auto drawn = [&](const std::string& curve) {
    return colorOf(render(with(shot, "hybrid_layered", {"tile=8", "trajectory=" + curve})));
  };
  const image::Image line = drawn("line");
  for (const char* curve : {"quadratic", "arc"}) {
    const image::Image curved = drawn(curve);
    int different = 0, turned = 0;
    for (int y = 0; y < line.height; ++y)
      for (int x = 0; x < line.width; ++x)
        for (int k = 0; k < 3; ++k) (x < 56 ? turned : different) += line.at(x, y, k) != curved.at(x, y, k);
    EXPECT_EQ(different, 0) << curve;
    EXPECT_GT(turned, 0) << curve;
  }
}

TEST_F(RenderCurves, UnsupportedCombinationsAreRefused) {
  auto problemOf = [&](const std::vector<std::string>& settings) -> std::string {
    return testing::refusalOf([&] { render(with(wedge(), hybridSteps(), settings)); });
  };
  EXPECT_NE(problemOf({"trajectory=arc", "range=split"}).find("set range = whole"), std::string::npos);
  EXPECT_NE(problemOf({"trajectory=arc", "displacement=extrapolated"})
                .find("trajectory = arc: arcs need poses inside of the exposure"),
            std::string::npos);
  EXPECT_NE(
      problemOf({"trajectory=arc", "composite=in_gather"}).find("composite = in_gather supports straight paths only"),
      std::string::npos);
}

// --- From poses of earlier frames

constexpr double kSlow = 5;  // degrees over the scene's default exposure of half a frame
constexpr double kPerFrame = 2 * kSlow;

lab::Shot slowWedge() { return shotOf("wedge", kSide, kSide, {{"from", 20}, {"to", 65}, {"degrees", kSlow}}); }

std::vector<std::string> foretold(const std::string& trajectory) {
  return {"displacement=extrapolated", "trajectory=" + trajectory};
}

// Exposure of two frames up to the raster time: the curve passes through the poses of both.
TEST_F(RenderCurves, CurvesPassThroughPosesOfEarlierFrames) {
  constexpr int kFrames = 2;
  lab::Shot shot = with(slowWedge(), "hybrid_layered", foretold("quadratic"), "end");
  shot.exposure = kFrames;
  shot.taps = {"raster_curve.curve"};
  const lab::Picture picture = render(shot);
  const image::Image &velocity = imageOf(picture, "velocity"),
                     &curve = picture.frame.taps.at("raster_curve.curve").floats;
  int seen = 0;
  for (int y = 0; y < kSide; ++y)
    for (int x = 0; x < kSide; ++x) {
      const glm::dvec2 d(velocity.at(x, y, 0), velocity.at(x, y, 1)), b(curve.at(x, y, 0), curve.at(x, y, 1));
      if (glm::length(d) == 0) continue;
      ++seen;
      for (int k = 1; k <= kFrames; ++k) {
        const double u = 1 - double(k) / kFrames;
        const glm::dvec2 at = d * (u - 1) + 4 * u * (1 - u) * b;
        const glm::dvec2 expected = turned(placeOf(x, y), -k * kPerFrame / kDegrees) - placeOf(x, y);
        // Single precision of the positions, times the sum of their coefficients, which is below 32.
        EXPECT_LE(glm::length(at - expected), 1e-3) << -k << ", " << x << " " << y;
      }
    }
  EXPECT_GT(seen, 500);
}

// x = 12 t + 5 t^2 / 2, t in exposures: the quadratic curve is the exact path for every anchor.
TEST_F(RenderCurves, QuadraticCurvesMatchUniformAcceleration) {
  const lab::Shot bent = shotOf("bent", 96, 32, {{"before", 12}, {"after", 12}, {"bend", 5}});
  for (const Anchor& anchor : anchors()) {
    lab::Shot shot = with(bent, "hybrid_layered", foretold("quadratic"), anchor.name);
    shot.taps = {"raster_curve.curve"};
    const lab::Picture picture = render(shot);
    const image::Image& curve = picture.frame.taps.at("raster_curve.curve").floats;
    for (int x = 32; x < 60; ++x) {
      EXPECT_NEAR(imageOf(picture, "velocity").at(x, 16, 0), 12 + 5 * (anchor.window.open + anchor.window.close) / 2,
                  1e-3)
          << anchor.name;
      EXPECT_NEAR(curve.at(x, 16, 0), -5. / 8, 1e-3) << anchor.name;
      for (int k = 1; k < 4; ++k) EXPECT_NEAR(curve.at(x, 16, k), 0, 1e-3) << anchor.name;
    }
  }
}

// Exposure of half a frame, twenty degrees per frame. At f frames a line misses f (f + 1) / 2 second differences of the
// rotation and a parabola f (f + 1) (f + 2) / 6 third differences. A third difference is a third of a second one, so at
// the ends of these exposures the error of a parabola is less than a third of the error of a line.
TEST_F(RenderCurves, ExtrapolatedCurvesFollowRotation) {
  for (const Anchor& anchor : anchors()) {
    std::map<std::string, double> farthest;
    for (const char* trajectory : {"line", "quadratic"}) {
      lab::Shot shot = shotOf("wedge", kSide, kSide, {{"from", 20}, {"to", 65}, {"degrees", 2 * kSlow}});
      shot = with(shot, "hybrid_layered", foretold(trajectory), anchor.name);
      const bool is_line = trajectory == std::string("line");
      if (!is_line) shot.taps = {"raster_curve.curve"};
      const lab::Picture picture = render(shot);
      const image::Image& velocity = imageOf(picture, "velocity");
      for (int y = 0; y < kSide; ++y)
        for (int x = 0; x < kSide; ++x) {
          const glm::dvec2 d(velocity.at(x, y, 0), velocity.at(x, y, 1));
          if (glm::length(d) == 0) continue;
          glm::dvec2 b(0);
          if (!is_line) {
            const image::Image& curve = picture.frame.taps.at("raster_curve.curve").floats;
            b = {curve.at(x, y, 0), curve.at(x, y, 1)};
          }
          const double open = anchor.window.open;
          auto off = [&](double t) { return 4 * (t - open) * (1 - t + open) * b; };
          for (double t : {open, open + .25, open + .5, open + .75, open + 1}) {
            const glm::dvec2 at = d * t + off(t) - off(0);
            const glm::dvec2 exact = turned(placeOf(x, y), t * 2 * kSlow / kDegrees) - placeOf(x, y);
            farthest[trajectory] = std::max(farthest[trajectory], glm::length(at - exact));
          }
        }
    }
    EXPECT_GT(farthest["line"], .5) << anchor.name;
    EXPECT_LE(farthest["quadratic"], farthest["line"] / 2.5) << anchor.name;
  }
}

// Straight paths run no curve pass. If everything is modelled, each straight texel keeps its displacement bit for bit.
TEST_F(RenderCurves, ExtrapolatedCurvesKeepStraightPaths) {
  auto drawn = [&](const std::string& trajectory, bool everything) {
    lab::Shot shot = with(shotOf("textured_bar", 64, 24), "hybrid_layered", foretold(trajectory));
    shot.model_everything = everything;
    return render(shot);
  };
  const image::Image expected = colorOf(drawn("line", false));
  for (bool everything : {false, true}) {
    const lab::Picture picture = drawn("quadratic", everything);
    EXPECT_TRUE(identical(colorOf(picture), expected)) << everything;
    bool runs = std::any_of(picture.frame.times.begin(), picture.frame.times.end(),
                            [](const auto& step) { return step.name == "raster_curve"; });
    EXPECT_EQ(runs, everything);
  }
}

// Poses beyond a cut are not used: with one pose left the path is straight.
TEST_F(RenderCurves, ExtrapolatedCurvesEndAtACut) {
  auto drawn = [&](const std::string& trajectory, const std::string& cuts) {
    lab::Shot shot = with(slowWedge(), "hybrid_layered", foretold(trajectory));
    shot.cuts = cuts;
    return colorOf(render(shot));
  };
  const std::string in_the_second = fmt::format("{}", -1.5 / 24), in_the_third = fmt::format("{}", -2.5 / 24);
  const image::Image line = drawn("line", ""), quadratic = drawn("quadratic", "");
  EXPECT_TRUE(identical(drawn("quadratic", in_the_second), line));
  EXPECT_TRUE(identical(drawn("quadratic", in_the_third), quadratic));
  EXPECT_GT(oracle::largestDifference(line, quadratic), .01);
}

}  // namespace render_curves_test
}  // namespace strobe::oracle
