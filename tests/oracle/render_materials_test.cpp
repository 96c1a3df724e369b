// SPDX-License-Identifier: MIT
// Sides, alpha and samplers of materials: equal by rasterisation, rays and truth, with every ray tracing backend.
#include <fmt/format.h>

#include <cmath>

#include "common/source.h"
#include "oracle/render.h"

namespace strobe::oracle {
namespace render_materials_test {

const std::string kTwoWays = sourceFolder() / "tests/oracle/pipelines/two_ways.lua";

class RenderMaterials : public RenderTest {
 protected:
  static double meanOf(const image::Image& color) {
    double sum = 0;
    for (size_t i = 0; i < color.values.size(); i += size_t(color.channels)) sum += color.values[i];
    return sum / (double(color.width) * color.height);
  }

  // Share of pixels whose red differs by more than rounding.
  static double shareOfOthers(const image::Image& a, const image::Image& b) {
    int others = 0;
    for (int y = 0; y < a.height; ++y)
      for (int x = 0; x < a.width; ++x) others += std::abs(a.at(x, y, 0) - b.at(x, y, 0)) > 1e-6;
    return double(others) / (a.width * a.height);
  }

  static void expectCards(const image::Image& color, const std::vector<bool>& seen, const std::string& what) {
    for (int column = 0; column < int(seen.size()); ++column)
      EXPECT_NEAR(color.at(8 * column + 4, 4, 0), seen[size_t(column)] ? .9 : .2, 1e-6) << what << ", card " << column;
  }
};

// glTF 2.0, 3.7.4 and 3.9.6: the sign of the determinant decides which winding is the front.
TEST_F(RenderMaterials, BackFacesShowOnDoubleSidedMaterialsOnly) {
  const std::vector<bool> seen = {true, false, true, true, false, true, false, true};
  for (const std::string& backend : backends()) {
    lab::Shot shot = shotOf("sides", 64, 8);
    shot.backend = backend;
    for (bool both : {false, true}) {
      shot.faces = both ? "both" : "material";
      std::vector<bool> expected = both ? std::vector<bool>(8, true) : seen;
      lab::Picture picture = render(with(shot, kTwoWays));
      expectCards(colorOf(picture), expected, backend + ", raster");
      expectCards(imageOf(picture, "ray_color"), expected, backend + ", rays");
      expectCards(colorOf(render(with(shot, "ground_truth", {"samples=2"}))), expected, backend + ", truth");
      std::vector<std::string> passing = {"mask=all", "termination=instance", "advance=instance_filter"};
      expectCards(colorOf(render(with(shot, hybridSteps(), passing))), expected, backend + ", hybrid");
    }
  }
}

// A closed object hides its back faces: drawing them makes no difference.
TEST_F(RenderMaterials, ClosedObjectsHideTheirBackFaces) {
  for (const char* pipeline : {"ground_truth", "hybrid", "none"}) {
    lab::Shot shot = with(shotOf("closed", 64, 40), pipeline);
    if (std::string(pipeline) == "ground_truth") shot.sets.push_back({"samples", "8"});
    lab::Picture material = render(shot);
    shot.faces = "both";
    EXPECT_TRUE(identical(colorOf(material), colorOf(render(shot)))) << pipeline;
    EXPECT_GT(rms(colorOf(material)), .05) << pipeline;
  }
}

TEST_F(RenderMaterials, FactsDescribeTheMaterials) {
  auto facts = [](const lab::Picture& picture) { return picture.record["facts"].dump(); };
  lab::Shot shot = with(shotOf("sides", 64, 8), "none");
  EXPECT_NE(facts(render(shot)).find("one_sided"), std::string::npos);
  shot.faces = "both";
  EXPECT_EQ(facts(render(shot)).find("one_sided"), std::string::npos);
  EXPECT_EQ(facts(render(with(shotOf("cut_out", 32, 8), "none"))).find("blend"), std::string::npos);
}

// Each pixel shows the card or the wall. The share of the card is alpha, within 4 standard deviations of independent
// pixels.
TEST_F(RenderMaterials, BlendingCoversAShareOfPoints) {
  for (double alpha : {0., .25, .6, 1.}) {
    lab::Shot shot = with(shotOf("veil", 64, 64, {{"alpha", alpha}}), kTwoWays);
    lab::Picture picture = render(shot);
    const image::Image &raster = colorOf(picture), &rays = imageOf(picture, "ray_color");
    double share = std::sqrt(alpha * (1 - alpha) / (64 * 64));
    EXPECT_NEAR(meanOf(raster), .2 + .7 * alpha, .7 * 4 * share + 1e-5) << alpha;
    for (float value : {raster.at(3, 5, 0), raster.at(40, 20, 0)})
      EXPECT_LT(std::min(std::abs(value - .2), std::abs(value - .9)), 1e-6) << alpha;
    // Points within single precision of a border between two cells may fall to either side.
    EXPECT_LE(shareOfOthers(raster, rays), .005) << alpha;
    lab::Picture truth = render(with(shotOf("veil", 64, 64, {{"alpha", alpha}}), "ground_truth", {"samples=4"}));
    EXPECT_LE(shareOfOthers(raster, colorOf(truth)), .005)
        << "without motion truth equals the raster image, alpha " << alpha;
  }
}

// Subpixel samples hit other points, and so do samples at other times while the card moves. The mean of N samples
// converges to the blend as fast as with independent samples.
TEST_F(RenderMaterials, BlendingConverges) {
  const double alpha = .25, expected = .2 + .7 * alpha;
  auto spread = [&](const image::Image& color) {
    double sum = 0;
    for (int y = 8; y < 56; ++y)
      for (int x = 8; x < 56; ++x) sum += std::pow(color.at(x, y, 0) - expected, 2);
    return std::sqrt(sum / (48 * 48));
  };
  const double of_16 = .7 * std::sqrt(alpha * (1 - alpha) / 16);
  lab::Shot still = with(shotOf("veil", 64, 64, {{"alpha", alpha}}), "none");
  still.aa = 16;
  EXPECT_NEAR(spread(colorOf(render(still))), of_16, .25 * of_16);
  lab::Shot moving = shotOf("veil", 64, 64, {{"alpha", alpha}, {"shift", 16}});
  EXPECT_NEAR(spread(colorOf(render(with(moving, "ground_truth", {"samples=16"})))), of_16, .25 * of_16);
}

// ---- samplers

// Nearest texels, computed from their indices; the checker's first field is black.
TEST_F(RenderMaterials, NearestLookupsReturnTheNearestTexel) {
  auto texel = [](double place, const std::string& wrap) {
    int index = int(std::floor(place * 8));
    if (wrap == "clamp") return std::clamp(index, 0, 7);
    int turn = (index % 16 + 16) % 16;
    if (wrap == "mirror") return turn < 8 ? turn : 15 - turn;
    return turn % 8;
  };
  for (const char* wrap : {"repeat", "mirror", "clamp"}) {
    // 2.5 repeats over 64 px: a texel is 3.2 px wide, and no pixel's centre is within 0.02 texels of a texel's border.
    const double repeats = 2.5, start = -.753;
    lab::Shot shot = shotOf("sampler", 64, 64, {{"repeats", repeats}, {"start", start}});
    shot.sets.push_back({"scene.wrap", wrap});
    lab::Picture picture = render(with(shot, kTwoWays));
    lab::Picture truth = render(with(shot, "ground_truth", {"samples=1"}));
    const image::Image &color = colorOf(picture), &rays = imageOf(picture, "ray_color"), &true_color = colorOf(truth);
    int wrong = 0, white = 0;
    for (int y = 0; y < 64; ++y)
      for (int x = 0; x < 64; ++x) {
        double u = (x + .5) / 64 * repeats + start, v = (y + .5) / 64 * repeats + start;
        float expected = float((texel(u, wrap) + texel(v, wrap)) % 2);
        white += expected > .5f;
        for (const image::Image* one : {&color, &rays, &true_color}) wrong += one->at(x, y, 0) != expected;
      }
    EXPECT_EQ(wrong, 0) << wrap;
    EXPECT_GT(white, 500) << wrap;
  }
}

// Linear lookups blend, and smaller levels are grey. Nearest lookups of the first level give neither.
TEST_F(RenderMaterials, TexturesUseTheChosenFilter) {
  auto blended = [](const std::string& filter, double repeats) {
    lab::Shot shot = shotOf("sampler", 64, 64, {{"repeats", repeats}, {"start", .003}});
    shot.sets.push_back({"scene.filter", filter});
    const image::Image color = colorOf(render(with(shot, "none")));
    int between = 0;
    for (int y = 0; y < 64; ++y)
      for (int x = 0; x < 64; ++x) between += color.at(x, y, 0) > .05 && color.at(x, y, 0) < .95;
    return between / (64. * 64);
  };
  EXPECT_EQ(blended("nearest", 1), 0);
  EXPECT_EQ(blended("nearest", 37), 0);
  EXPECT_GT(blended("linear", 1), .2);
  EXPECT_GT(blended("linear", 37), .99);
}

}  // namespace render_materials_test
}  // namespace strobe::oracle
