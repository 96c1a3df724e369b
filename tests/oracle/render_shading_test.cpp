// SPDX-License-Identifier: MIT
// Colours of a plane against the formulas of glTF 2.0 (appendix B) and KHR_lights_punctual in double precision, with
// points, angles and distances from the scene's parameters; textures against properties of every filter.
#include <fmt/format.h>

#include <cmath>
#include <glm/glm.hpp>
#include <glm/gtc/constants.hpp>

#include "oracle/render.h"

namespace strobe::oracle {
namespace render_shading_test {

using glm::dmat3;
using glm::dvec3;

constexpr int kWidth = 16, kHeight = 12;

dmat3 turnX(double degrees) {
  double c = std::cos(glm::radians(degrees)), s = std::sin(glm::radians(degrees));
  return dmat3(dvec3(1, 0, 0), dvec3(0, c, s), dvec3(0, -s, c));
}
dmat3 turnY(double degrees) {
  double c = std::cos(glm::radians(degrees)), s = std::sin(glm::radians(degrees));
  return dmat3(dvec3(c, 0, -s), dvec3(0, 1, 0), dvec3(s, 0, c));
}

// Parameters of tests/oracle/scenes/lit.lua.
struct Lit {
  int light = 1;
  double tilt_x = 0, tilt_y = 0, metallic = 0, roughness = .5, range = 0, bump_x = 0, bump_y = 0, bump_z = 1, bump = 1;
  double metal = -1, rough = -1, glow = -1, sky = 0, ground = 0;
  dvec3 at = dvec3(1, 2, -1);  // of the light
  double card = 0, card_x = .5, card_y = 1, card_z = 3;

  lab::Shot shot() const {
    Numbers numbers = {{"light", light},         {"tilt_x", tilt_x}, {"tilt_y", tilt_y}, {"metallic", metallic},
                       {"roughness", roughness}, {"range", range},   {"bump_x", bump_x}, {"bump_y", bump_y},
                       {"bump_z", bump_z},       {"bump", bump},     {"metal", metal},   {"rough", rough},
                       {"glow", glow},           {"sky", sky},       {"ground", ground}, {"light_x", at.x},
                       {"light_y", at.y},        {"light_z", at.z},  {"card", card},     {"card_x", card_x},
                       {"card_y", card_y},       {"card_z", card_z}};
    return with(shotOf("lit", kWidth, kHeight, numbers), "none");
  }

  dmat3 turned() const { return turnY(tilt_y) * turnX(tilt_x); }
  dvec3 middle() const { return dvec3(0, 0, -5); }

  // Point of the plane at a pixel's centre.
  dvec3 pointAt(int x, int y) const {
    double focal = kHeight / 2. / std::tan(glm::radians(30.));
    dvec3 ray((x + .5 - kWidth / 2.) / focal, (kHeight / 2. - y - .5) / focal, -1);
    dvec3 normal = turned()[2];
    return ray * (dot(middle(), normal) / dot(ray, normal));
  }

  // True if the pixel shows the plane, and the angle to its normal map is not too flat for the formulas.
  bool isSeen(int x, int y) const {
    dvec3 point = pointAt(x, y);
    return point.z < 0 && distance(point, middle()) < 19 && dot(normal(), -normalize(point)) > .02;
  }

  dvec3 normal() const { return normalize(turned() * dvec3(bump * bump_x, bump * bump_y, std::max(bump_z, 1e-3))); }

  // True if the card is between the point and the light.
  bool isShadowed(dvec3 point, double margin) const {
    double share = (-card_z - point.z) / (at.z - point.z);
    dvec3 met = point + share * (at - point);
    double side = card / 2 + margin;
    return card > 0 && std::abs(met.x - card_x) < side && std::abs(met.y - card_y) < side;
  }

  // Irradiance at normal incidence.
  dvec3 incident(dvec3 point, dvec3& towards) const {
    dvec3 irradiance = 3. * dvec3(1, .9, .7), axis = normalize(middle() - at), offset = at - point;
    towards = light == 1 ? -axis : normalize(offset);
    if (light == 1) return irradiance;
    double distance = length(offset);
    irradiance /= distance * distance;
    if (range > 0) irradiance *= std::clamp(1 - std::pow(distance / range, 4), 0., 1.);
    if (light < 3) return irradiance;
    double inner = std::cos(glm::radians(10.)), outer = std::cos(glm::radians(25.));
    return irradiance * std::pow(std::clamp((dot(-towards, axis) - outer) / (inner - outer), 0., 1.), 2);
  }

  double skyIn(dvec3 direction, int channel) const {
    double below = channel == 1 ? ground / 2 : ground;
    return below + (sky - below) * (.5 + .5 * direction.y);
  }

  dvec3 expected(dvec3 point) const {
    double shine = metal < 0 ? metallic : metal * metallic;
    double width = std::clamp(rough < 0 ? roughness : rough * roughness, .05, 1.), a = width * width;
    dvec3 n = normal(), v = normalize(-point), l(0), light_at = light ? incident(point, l) : dvec3(0);
    dvec3 h = light ? normalize(v + l) : n, result(0);
    double nl = light ? std::max(dot(n, l), 0.) : 0, nv = dot(n, v), nh = dot(n, h), vh = dot(v, h);
    if (light && dot(turned()[2], l) <= 0) nl = 0;
    double bell = nh * nh * (a * a - 1) + 1, d = a * a / (glm::pi<double>() * bell * bell);
    double g = .5 / (nl * std::sqrt(nv * nv * (1 - a * a) + a * a) + nv * std::sqrt(nl * nl * (1 - a * a) + a * a));
    for (int c = 0; c < 3; ++c) {
      double base = dvec3(.8, .5, .2)[c], f0 = .04 + (base - .04) * shine, diffuse = base * (1 - shine);
      double f = f0 + (1 - f0) * std::pow(1 - vh, 5);
      double lit = light ? ((1 - f) * diffuse / glm::pi<double>() + f * d * g) * nl * light_at[c] : 0;
      double rim = f0 + (std::max(1 - width, f0) - f0) * std::pow(1 - std::clamp(nv, 0., 1.), 5);
      double around = diffuse * skyIn(n, c) + rim * skyIn(2 * dot(v, n) * n - v, c);
      result[c] = lit + around + (glow < 0 ? 0 : glow * dvec3(.5, 1, 2)[c]);
    }
    return result;
  }
};

class RenderShading : public RenderTest {
 protected:
  // Tolerance: single precision in a few dozen operations; the slope of a highlight is up to 1 / roughness^2.
  static void expectFormula(const Lit& lit, const std::string& what) {
    image::Image color = colorOf(render(lit.shot()));
    double worst = 0, brightest = 0;
    int seen = 0;
    std::string place;
    for (int y = 0; y < kHeight; ++y)
      for (int x = 0; x < kWidth; ++x) {
        if (!lit.isSeen(x, y)) continue;
        ++seen;
        dvec3 expected = lit.expected(lit.pointAt(x, y));
        for (int c = 0; c < 3; ++c) {
          brightest = std::max(brightest, expected[c]);
          double error = std::abs(color.at(x, y, c) - expected[c]) / (expected[c] + 1e-3);
          if (!(error <= worst))
            worst = error,
            place = fmt::format("({}, {}) is {}, by the formula {}", x, y, color.at(x, y, c), expected[c]);
        }
      }
    EXPECT_LE(worst, 2e-4) << what << ": " << place;
    EXPECT_GT(brightest, 1e-2) << what;
    EXPECT_GT(seen, kWidth * kHeight / 3) << what;
  }
};

TEST_F(RenderShading, LightsFollowTheirExtension) {
  expectFormula({.light = 1}, "directional");
  expectFormula({.light = 1, .tilt_x = -50, .tilt_y = 20}, "directional, tilted");
  expectFormula({.light = 2, .tilt_x = -50}, "point");
  expectFormula({.light = 2, .range = 6}, "point with a range");
  expectFormula({.light = 3, .range = 9, .at = dvec3(.5, 1, -1)}, "spot");
}

TEST_F(RenderShading, SurfacesReflectByTheGltfFormulas) {
  for (double metallic : {0., .6, 1.})
    for (double roughness : {.25, .9})
      expectFormula({.light = 2,
                     .tilt_x = -30,
                     .tilt_y = 15,
                     .metallic = metallic,
                     .roughness = roughness,
                     .at = dvec3(0, 1, -1)},
                    fmt::format("metallic {} roughness {}", metallic, roughness));
  expectFormula({.light = 2, .metallic = .8, .roughness = .9, .metal = .5, .rough = .4}, "by texture");
}

TEST_F(RenderShading, SkyAndGlowAdd) {
  expectFormula({.light = 0, .tilt_x = -60, .roughness = .4, .sky = .8, .ground = .2}, "sky over ground");
  expectFormula({.light = 0, .tilt_x = 40, .metallic = 1, .roughness = .3, .sky = .2, .ground = .6}, "metal");
  expectFormula({.light = 0, .glow = .75, .sky = .1}, "glow");
}

TEST_F(RenderShading, NormalMapsTurnTheNormal) {
  for (auto [x, y] : {std::pair(.5, 0.), std::pair(0., .5), std::pair(-.25, -.5)})
    expectFormula({.light = 2, .tilt_x = -20, .tilt_y = 25, .bump_x = x, .bump_y = y}, fmt::format("bump {} {}", x, y));
  expectFormula({.light = 2, .bump_x = .25, .bump_y = .25, .bump = 2}, "scaled");
  expectFormula({.light = 2, .tilt_y = -40, .bump_x = .5, .bump_z = -.5}, "pointing into the surface");
}

// Points behind the card, as viewed from the light, are dark. Pixels near the shadow's edge or the card are not tested.
TEST_F(RenderShading, ShadowsLieBehindTheCard) {
  Lit lit{.light = 2, .at = dvec3(1, 2, 0), .card = .8};
  image::Image color = colorOf(render(lit.shot()));
  int dark = 0, bright = 0;
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x) {
      dvec3 point = lit.pointAt(x, y), seen = point * (-lit.card_z / point.z);
      bool on_card =
          std::abs(seen.x - lit.card_x) < lit.card / 2 + .3 && std::abs(seen.y - lit.card_y) < lit.card / 2 + .3;
      if (on_card || lit.isShadowed(point, .05) != lit.isShadowed(point, -.05)) continue;
      bool shadowed = lit.isShadowed(point, 0);
      ++(shadowed ? dark : bright);
      double expected = shadowed ? 0 : lit.expected(point).x;
      EXPECT_NEAR(color.at(x, y, 0), expected, 1e-4 + 1e-3 * expected) << x << " " << y;
    }
  EXPECT_GE(dark, 4);
  EXPECT_GE(bright, 100);
}

// ---- within the exposure: truth shades at each sample's time, or at the raster time

constexpr int kTimes = 16;

// Time of sample `k` in exposures; the exposure of a frame ends at the raster time.
double timeOf(int k) { return (k + .5) / kTimes - 1; }

// Mean over the samples' times.
template <typename Function>
dvec3 meanOf(Function&& at) {
  dvec3 sum(0);
  for (int k = 0; k < kTimes; ++k) sum += at(timeOf(k));
  return sum / double(kTimes);
}

class RenderShadingInMotion : public RenderShading {
 protected:
  // `moves` and `spins` as on the command line, per frame.
  static image::Image truth(const Lit& lit, const std::string& shading, std::vector<std::string> moves,
                            std::vector<std::string> spins = {}) {
    lab::Shot shot = with(lit.shot(), "ground_truth",
                          {fmt::format("samples={}", kTimes), "times=midpoint", "shading=" + shading}, "end");
    shot.exposure = 1;
    shot.moves = std::move(moves), shot.spins = std::move(spins);
    return colorOf(render(shot));
  }

  // Tolerance of single precision, as above.
  template <typename Expected>
  static void expect(const image::Image& color, const Lit& lit, const Expected& expected, const std::string& what) {
    int seen = 0;
    for (int y = 0; y < kHeight; ++y)
      for (int x = 0; x < kWidth; ++x) {
        if (!lit.isSeen(x, y)) continue;
        ++seen;
        dvec3 value = expected(lit.pointAt(x, y));
        for (int c = 0; c < 3; ++c)
          EXPECT_NEAR(color.at(x, y, c), value[c], 2e-4 * value[c] + 1e-6) << what << " " << x << " " << y;
      }
    EXPECT_GT(seen, kWidth * kHeight / 3) << what;
  }
};

// A plane that turns about its own normal looks the same at any time, with its highlight. With frozen shading the
// highlight turns along with the surface.
TEST_F(RenderShadingInMotion, FrozenHighlightsTurnWithTheSurface) {
  Lit lit{.light = 2, .roughness = .35, .at = dvec3(1, 1, -3)};
  const double degrees = 40;
  auto still = [&](dvec3 point) { return lit.expected(point); };
  auto carried = [&](dvec3 point) {
    return meanOf([&](double time) {
      double angle = glm::radians(-degrees * time), c = std::cos(angle), s = std::sin(angle);
      return lit.expected(dvec3(c * point.x - s * point.y, s * point.x + c * point.y, point.z));
    });
  };
  std::vector<std::string> spin = {fmt::format("plane=0,0,1,{}", degrees)};
  image::Image full = truth(lit, "full", {}, spin), frozen = truth(lit, "frozen", {}, spin);
  expect(full, lit, still, "full");
  expect(frozen, lit, carried, "frozen");
  EXPECT_GT(rmsDifference(full, frozen), .01) << "the two differ";
}

// A light moves over a static scene: with frozen shading nothing blurs.
TEST_F(RenderShadingInMotion, LightsMoveOnlyWithFullShading) {
  Lit lit{.light = 2, .at = dvec3(1, 1, -3)};
  const dvec3 way(-2, .5, .25);
  std::vector<std::string> move = {"light=-2,0.5,0.25"};
  auto moved = [&](dvec3 point) {
    return meanOf([&](double time) {
      Lit then = lit;
      then.at += way * time;
      return then.expected(point);
    });
  };
  expect(truth(lit, "full", move), lit, moved, "full");
  EXPECT_LE(oracle::largestDifference(truth(lit, "frozen", move), colorOf(render(lit.shot()))), 1e-6)
      << "the raster image";
}

// The shadow of a card that moves over a static plane. Pixels on the card at any time, or at the shadow's edge at any
// sample, are not tested.
TEST_F(RenderShadingInMotion, ShadowsMoveOnlyWithFullShading) {
  Lit lit{.light = 2, .at = dvec3(1, 2, 0), .card = .8};
  const double way = -.6;
  image::Image full = truth(lit, "full", {"card=-0.6,0,0"}), frozen = truth(lit, "frozen", {"card=-0.6,0,0"});
  auto at = [&](double time) {
    Lit then = lit;
    then.card_x += way * time;
    return then;
  };
  int partly = 0, still = 0;
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x) {
      dvec3 point = lit.pointAt(x, y), seen = point * (-lit.card_z / point.z);
      bool looked_at = true;
      double free = 0;
      for (int k = -1; k < kTimes; ++k) {
        Lit then = at(k < 0 ? 0 : timeOf(k));
        bool on_card =
            std::abs(seen.x - then.card_x) < lit.card / 2 + .01 && std::abs(seen.y - lit.card_y) < lit.card / 2 + .01;
        looked_at = looked_at && !on_card && then.isShadowed(point, 1e-3) == then.isShadowed(point, -1e-3);
        if (k >= 0) free += then.isShadowed(point, 0) ? 0 : 1. / kTimes;
      }
      if (!looked_at) continue;
      partly += free > 0 && free < 1;
      still += !lit.isShadowed(point, 0);
      double bright = lit.expected(point).x, captured = lit.isShadowed(point, 0) ? 0 : bright;
      EXPECT_NEAR(full.at(x, y, 0), free * bright, 1e-4 + 1e-3 * bright) << x << " " << y;
      EXPECT_NEAR(frozen.at(x, y, 0), captured, 1e-4 + 1e-3 * bright) << x << " " << y;
    }
  EXPECT_GE(partly, 6);
  EXPECT_GE(still, 80);
}

// Mean of the middle of the picture, and its root mean square distance from one half.
struct Contrast {
  double mean = 0, spread = 0;
};

class RenderTextures : public RenderTest {
 protected:
  static Contrast stripes(double per_metre, double texels, double along, double tilt_x, double tilt_y,
                          int segments = 1) {
    constexpr int kSide = 64, kFirst = 20, kLast = 44;
    lab::Shot shot = shotOf("lit", kSide, kSide,
                            {{"light", 0},
                             {"stripes", per_metre},
                             {"texels", texels},
                             {"along", along},
                             {"tilt_x", tilt_x},
                             {"tilt_y", tilt_y},
                             {"segments", segments}});
    image::Image color = colorOf(render(with(shot, "none")));
    Contrast contrast;
    const double pixels = std::pow(kLast - kFirst, 2);
    for (int y = kFirst; y < kLast; ++y)
      for (int x = kFirst; x < kLast; ++x) {
        contrast.mean += color.at(x, y, 0) / pixels;
        contrast.spread += std::pow(color.at(x, y, 0) - .5, 2) / pixels;
      }
    contrast.spread = std::sqrt(contrast.spread);
    return contrast;
  }
};

// Seen head-on, a pixel is 0.09 m wide. Much wider stripes keep nearly all of their contrast (.5); much narrower ones
// blur to the mean of black and white.
TEST_F(RenderTextures, LargeStripesAreSharpAndSmallOnesGrey) {
  for (double along : {0., 1.}) {
    Contrast large = stripes(1, 8, along, 0, 0);
    EXPECT_NEAR(large.mean, .5, .1);
    EXPECT_GT(large.spread, .42) << along;
    Contrast small = stripes(60, 8, along, 0, 0);
    EXPECT_NEAR(small.mean, .5, .01);
    EXPECT_LT(small.spread, .01) << along;
  }
}

// The filter does not depend on the size of the textured triangles, here 0.25 m.
TEST_F(RenderTextures, SmallTrianglesDoNotChangeTheFilter) {
  EXPECT_LT(stripes(60, 8, 0, 0, 0, 160).spread, .01);
  EXPECT_LT(stripes(20, 8, 1, 70, 0, 160).spread, .05);
}

// A plane turned by 70 degrees recedes three times as fast as it spreads. Stripes along the receding direction, 3 px
// wide in the middle, stay; stripes across it, 1 px wide there, vanish.
TEST_F(RenderTextures, StripesAcrossTheRecedingDirectionAreBlurred) {
  EXPECT_GT(stripes(3.5, 8, 0, 70, 0).spread, .25);
  EXPECT_LT(stripes(20, 8, 1, 70, 0).spread, .05);
  EXPECT_GT(stripes(3.5, 8, 1, 0, 70).spread, .25);
  EXPECT_LT(stripes(20, 8, 0, 0, 70).spread, .05);
}

// Planes that recede faster than 1:16 are filtered like planes at that limit, along the same direction: stripes along
// it stay as sharp.
TEST_F(RenderTextures, GrazingPlanesKeepTheFilterDirection) {
  auto spreadAt = [](double facing) {
    const image::Image color = colorOf(render(with(shotOf("grazing", 32, 32, {{"facing", facing}}), "none")));
    double sum = 0;
    for (float value : color.values) sum += value;
    const double mean = sum / double(color.values.size());
    double squares = 0;
    for (float value : color.values) squares += std::pow(value - mean, 2);
    return std::sqrt(squares / double(color.values.size()));
  };
  const double not_yet = spreadAt(.0626), just = spreadAt(.0624);
  EXPECT_GT(not_yet, .4);
  EXPECT_NEAR(just, not_yet, .01) << "the two planes differ slightly in angle";
}

// By rasterisation and by rays.
TEST_F(RenderTextures, CutOutHolesAreTransparent) {
  for (double alpha : {.25, .75}) {
    lab::Shot shot = shotOf("cut_out", 32, 8, {{"alpha", alpha}});
    for (const char* mode : {"rays", "raster"}) {
      image::Image color = colorOf(render(with(shot, "ground_truth", {"samples=1", fmt::format("mode={}", mode)})));
      EXPECT_NEAR(color.at(4, 4, 0), .9, 1e-6) << mode;
      EXPECT_NEAR(color.at(27, 4, 0), alpha < .5 ? .2 : .9, 1e-6) << mode;
    }
  }
}

}  // namespace render_shading_test
}  // namespace strobe::oracle
