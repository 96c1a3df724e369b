// SPDX-License-Identifier: MIT
// Blurs of engines and papers since 2020, with their known strengths and weaknesses. Against closed forms, or against
// truth where no closed form exists.
#include <fmt/format.h>

#include <bit>
#include <cmath>

#include "oracle/render.h"

namespace strobe::oracle {
namespace render_peers_test {

constexpr int kWidth = 256, kRows = 8, kRow = 4;

class RenderPeers : public RenderTest {};

// --- Bevy: each pixel blurs along its own displacement

// A bar over black. Inside the bar, the share of taps on the bar equals its share of the exposure. Outside, where truth
// has ramps too, the picture stays sharp, bit for bit.
TEST_F(RenderPeers, BevyBlursNothingOutsideASilhouette) {
  const Strips bar = {{96, 160, 20, {1}}, {-kInfinity, kInfinity, 0, {0}}};
  constexpr int kSamples = 32;
  for (const Anchor& anchor : anchors()) {
    SCOPED_TRACE(anchor.name);
    lab::Shot shot = shotOf("bar", kWidth, kRows);
    image::Image sharp = colorOf(render(with(shot, "none", {}, anchor.name)));
    image::Image color = colorOf(render(with(shot, "bevy", {fmt::format("samples={}", kSamples)}, anchor.name)));
    double missed = 0, softest = 1;
    for (int x = 0; x < kWidth; ++x) {
      double exact = exposeCentre(bar, anchor.window, x).colour;
      bool inside = x >= 96 && x < 160;
      if (inside) {
        EXPECT_NEAR(color.at(x, kRow, 0), exact, 1. / kSamples + 1e-6) << x;
        softest = std::min(softest, double(color.at(x, kRow, 0)));
      } else {
        EXPECT_EQ(color.at(x, kRow, 0), sharp.at(x, kRow, 0)) << x;
        missed = std::max(missed, exact);
      }
    }
    bool centred = anchor.name == "centre";
    EXPECT_LT(softest, centred ? .55 : .1);  // half the ramp, or the whole ramp
    EXPECT_GT(missed, centred ? .45 : .9);   // the missing half, or the whole ramp at the other end
  }
}

// A nearer and faster surface on the pixel's own line counts even if it moves away: a ghost that truth does not have.
TEST_F(RenderPeers, BevyShowsGhostsOfDepartingSurfaces) {
  lab::Shot shot = shotOf("textured_bar", kWidth, kRows,
                          {{"d_f", 20}, {"d_b", -12}, {"period_b", 8}, {"b_light", .2}, {"b_dark", .2}});
  image::Image color = colorOf(render(with(shot, "bevy", {"samples=32"}, "end")));
  // Right of a bar that has come from the left, only the background of .2 is ever visible.
  EXPECT_GT(color.at(162, kRow, 0), .4);
  EXPECT_FLOAT_EQ(color.at(180, kRow, 0), .2f);
}

// --- Lee, Kwon and Oh 2024: full layers, searched back along displacements

// Three cards directly behind each other that move apart before a static wall.
const Strips kStack = {{32, 96, 20, {.9}}, {32, 96, 16, {.6}}, {32, 96, 12, {.3}}, {-kInfinity, kInfinity, 0, {.1}}};

lab::Shot stacked() {
  Numbers numbers;
  for (size_t k = 0; k < 3; ++k) {
    const Strip& card = kStack[k];
    for (const auto& [name, value] :
         Numbers{{"left", card.left}, {"right", card.right}, {"d", card.d}, {"v", card.pattern.even}})
      numbers.push_back({fmt::format("{}{}", name, k), value});
  }
  return shotOf("cards", 128, kRows, numbers);
}

// Index of the farthest surface that is visible at a pixel within the exposure, 0 for the first.
int farthestSeen(const Strips& strips, Window window, int x) {
  int farthest = 0;
  for (int i = 0; i < 256; ++i) {
    double t = window.open + (window.close - window.open) * (i + .5) / 256;
    farthest = std::max(farthest, seenAt(strips, x + .5, t).surface);
  }
  return farthest;
}

// With as many layers as surfaces the picture is exact up to the number of samples inside the silhouettes, where the
// search follows each layer's own displacement. With fewer layers, only pixels that show a surface without a layer are
// wrong.
TEST_F(RenderPeers, Lee2024ResolvesAsManySurfacesAsLayers) {
  constexpr int kSamples = 64;
  for (int layers = 1; layers <= 4; ++layers)
    for (const Anchor& anchor : anchors()) {
      SCOPED_TRACE(fmt::format("{} layers, {}", layers, anchor.name));
      lab::Shot shot =
          with(stacked(), "lee2024",
               {fmt::format("layer_count={}", layers), fmt::format("samples={}", kSamples), "tile=20"}, anchor.name);
      image::Image color = colorOf(render(shot));
      double worst = 0;
      for (int x = 32; x < 96; ++x) {
        Exposure exact = exposeCentre(kStack, anchor.window, x);
        double error = std::abs(color.at(x, kRow, 0) - exact.colour);
        bool is_held = farthestSeen(kStack, anchor.window, x) < layers;
        if (is_held) {
          EXPECT_LE(error, exact.variation / kSamples + 1e-4) << x;
        }
        if (!is_held) worst = std::max(worst, error);
      }
      EXPECT_EQ(worst > .1, layers < 4) << worst;
    }
}

// A surface outside the picture at the raster time is in no layer, however many layers exist.
TEST_F(RenderPeers, Lee2024MissesSurfacesOutsideThePicture) {
  const Strips gone = {{260, 300, 60, {1}}, {-kInfinity, kInfinity, 0, {0}}};
  lab::Shot shot = shotOf("bar", kWidth, kRows, {{"left", 260}, {"right", 300}, {"d_f", 60}});
  image::Image color = colorOf(render(with(shot, "lee2024", {"layer_count=4"}, "end")));
  for (int x = 0; x < kWidth; ++x) EXPECT_EQ(color.at(x, kRow, 0), 0) << x;
  EXPECT_GT(exposeCentre(gone, kCloseAnchor, 230).colour, .4);
}

// A pixel on no path of its own layers gets the displacement of passing surfaces from its tile only.
TEST_F(RenderPeers, Lee2024FindsNothingOutsideByOwnDisplacements) {
  lab::Shot shot = shotOf("bar", kWidth, kRows);
  image::Image own = colorOf(render(with(shot, "lee2024", {"paths=own"}, "end")));
  image::Image tiles = colorOf(render(with(shot, "lee2024", {"paths=tiles", "samples=64"}, "end")));
  image::Image sharp = colorOf(render(with(shot, "none")));
  const Strips bar = {{96, 160, 20, {1}}, {-kInfinity, kInfinity, 0, {0}}};
  for (int x = 70; x < 96; ++x) {
    EXPECT_EQ(own.at(x, kRow, 0), sharp.at(x, kRow, 0)) << x;
    EXPECT_NEAR(tiles.at(x, kRow, 0), exposeCentre(bar, kCloseAnchor, x).colour, 1. / 64 + 1e-4) << x;
  }
}

// --- Unity HDRP: tiles scattered along their motion, weights by alignment of motions

// A bar of four tiles that has moved 90 px. The tiles of 16 px on its path hold its displacement, distant tiles do not,
// and the blur has the full length.
TEST_F(RenderPeers, HdrpBlursFartherThanATile) {
  const Strips bar = {{160, 224, 90, {1}}, {-kInfinity, kInfinity, 0, {0}}};
  lab::Shot shot = shotOf("bar", kWidth, 16, {{"left", 160}, {"right", 224}, {"d_f", 90}});
  shot = with(shot, "hdrp", {"samples=64"}, "end");
  shot.taps = {"scatter_max.dominant"};
  lab::Picture picture = render(shot);
  const image::Image& dominant = picture.frame.taps.at(shot.taps[0]).floats;
  for (int tile = 0; tile < kWidth / 16; ++tile) {
    double covered = 0;
    for (int x = 16 * tile; x < 16 * tile + 16; ++x) covered += exposeCentre(bar, kCloseAnchor, x).coverage;
    if (covered > 0) {
      EXPECT_FLOAT_EQ(dominant.at(tile, 0, 0), 90) << tile;
    }
    bool far_off = 16 * (tile + 2) < 70 || 16 * (tile - 1) > 224;  // by at least a tile from the bar's whole path
    if (far_off) {
      EXPECT_EQ(dominant.at(tile, 0, 0), 0) << tile;
    }
  }
  for (int x = 0; x < kWidth; ++x)
    EXPECT_NEAR(colorOf(picture).at(x, kRow, 0), exposeCentre(bar, kCloseAnchor, x).colour, 1.5 / 64) << x;
}

// Tiles 10 to 13 scatter their displacement to the tiles between their positions at the two ends of the exposure.
TEST_F(RenderPeers, HdrpTilesScatterAlongTheirWholePath) {
  constexpr int kTiles = kWidth / 16;
  constexpr double kLength = 90, kFrom = 10, kTo = 13;
  for (const Anchor& anchor : anchors()) {
    lab::Shot shot = shotOf("bar", kWidth, 16, {{"left", 16 * kFrom}, {"right", 16 * (kTo + 1)}, {"d_f", kLength}});
    shot = with(shot, "hdrp", {}, anchor.name);
    shot.taps = {"scatter_length.length"};
    const lab::Picture picture = render(shot);
    const image::UintImage& length = picture.frame.taps.at(shot.taps[0]).uints;
    const double first = kFrom + std::round(kLength / 16 * anchor.window.open),
                 last = kTo + std::round(kLength / 16 * anchor.window.close);
    for (int tile = 0; tile < kTiles; ++tile)
      EXPECT_EQ(std::bit_cast<float>(length.at(tile, 0, 0)), first <= tile && tile <= last ? kLength : 0)
          << anchor.name << ' ' << tile;
  }
}

// `a` moves 12 px right, `b` 10 px down; both lie in one tile, far from each other.
lab::Shot crossing(double a_x) {
  return shotOf("crossing", 96, 96,
                {{"a_left", 0}, {"a_top", 64}, {"a_x", a_x}, {"b_left", 40}, {"b_top", 20}, {"b_x", 0}, {"b_y", 10}});
}

TEST_F(RenderPeers, HdrpLosesOneOfTwoMotionsInATile) {
  auto color = [](double a_x, const std::string& pipeline, const std::vector<std::string>& settings) {
    return colorOf(render(with(crossing(a_x), pipeline, settings, "end")));
  };
  const std::vector<std::string> one_tile = {"tile=96"};
  image::Image alone = color(0, "hdrp", one_tile), crossed = color(12, "hdrp", one_tile), sharp = color(12, "none", {});
  for (int y = 8; y < 56; ++y) {
    double exact = .2 + .4 * barAtCentre(20, 52, 10, kCloseAnchor, y);
    EXPECT_NEAR(alone.at(56, y, 0), exact, .4 / 10) << y;              // without other motion: blurred, by 10 taps
    EXPECT_NEAR(crossed.at(56, y, 0), sharp.at(56, y, 0), 1e-5) << y;  // with faster motion in the tile: sharp
  }
  EXPECT_NEAR(barAtCentre(20, 52, 10, kCloseAnchor, 15), .55, 1e-9);  // the coverage that is lost
}

// The weights keep a surface that moves across the dominant displacement from being smeared along it.
TEST_F(RenderPeers, HdrpSpreadsNothingAcrossItsOwnMotion) {
  auto beside = [](const std::string& pipeline) {
    return colorOf(render(with(crossing(12), pipeline, {"tile=96"}, "end"))).at(36, 36, 0);
  };
  EXPECT_NEAR(beside("hdrp"), .2, 1e-6);
  EXPECT_GT(beside("jimenez2014"), .3);
}

// --- Oberberger, Chajdas and Westermann 2022: one ray per pixel at a random time, a filter along the motion

// A striped bar over static stripes: the mean of each column over rows and seeds, against the exact exposure.
constexpr int kTallRows = 64, kSeeds = 16;
const Strips kStriped = {{96, 160, 20, {.9, .6, 8, 96}}, {-kInfinity, kInfinity, 0, {.4, .1, 8, 0}}};

lab::Shot oneRay(int levels, int seed) {
  lab::Shot shot =
      with(shotOf("textured_bar", kWidth, kTallRows), "oberberger2022", {fmt::format("octaves={}", levels)}, "end");
  shot.seed = uint32_t(seed);
  return shot;
}

double meanOfColumn(const image::Image& color, int x) {
  double sum = 0;
  for (int y = 0; y < kTallRows; ++y) sum += color.at(x, y, 0) / kTallRows;
  return sum;
}

// Mean colour of a column over the times that pixels draw from: the middles of 32 parts of the exposure.
double meanOfTimes(int x) {
  double sum = 0;
  for (int i = 0; i < 32; ++i) sum += seenAt(kStriped, x + .5, (i + .5) / 32 - 1).colour / 32;
  return sum;
}

// Largest bias of a column's mean over seeds, among the columns that the bar covers at some time.
double biasOf(const std::vector<image::Image>& pictures) {
  double worst = 0;
  for (int x = 76; x < 160; ++x) {
    double mean = 0;
    for (const image::Image& color : pictures) mean += meanOfColumn(color, x) / double(pictures.size());
    worst = std::max(worst, std::abs(mean - meanOfTimes(x)));
  }
  return worst;
}

// Noise: standard deviation of the pixels from the mean of their column.
double noiseOf(const image::Image& color) {
  double squares = 0;
  for (int x = 76; x < 160; ++x) {
    double mean = meanOfColumn(color, x);
    for (int y = 0; y < kTallRows; ++y) squares += std::pow(color.at(x, y, 0) - mean, 2) / (84 * kTallRows);
  }
  return std::sqrt(squares);
}

// Rays alone are unbiased and noisy. The filter removes most of the noise, but adds a bias that no number of averaged
// pictures removes. Colours lie in a range of .8, so a standard deviation is at most .4.
TEST_F(RenderPeers, Oberberger2022IsUnbiasedWithoutItsFilter) {
  std::vector<image::Image> rays, filtered;
  for (int seed = 1; seed <= kSeeds; ++seed) {
    rays.push_back(colorOf(render(oneRay(0, seed))));
    filtered.push_back(colorOf(render(oneRay(4, seed))));
  }
  double four_errors = 4 * .4 / std::sqrt(kSeeds * kTallRows);
  EXPECT_LT(biasOf(rays), four_errors);
  EXPECT_GT(biasOf(filtered), .1);
  double before = noiseOf(rays.front()), after = noiseOf(filtered.front());
  EXPECT_LT(after, .5 * before);
  EXPECT_GT(after, .01);
}

// Pixels with different motions are all blurred along the longer one: a static wall behind a moving bar is smeared,
// although truth shows it sharp.
TEST_F(RenderPeers, Oberberger2022SmearsStaticSurfacesAlongMotion) {
  // The contrast of static stripes behind a bar of one colour, reduced by the bar's share of the time.
  lab::Shot shot = shotOf("textured_bar", kWidth, kTallRows, {{"f_light", .25}, {"f_dark", .25}, {"period_b", 2}});
  auto contrast = [&](int levels) {
    image::Image color = colorOf(render(with(shot, "oberberger2022", {fmt::format("octaves={}", levels)}, "end")));
    double sum = 0;
    for (int x = 80; x < 92; x += 4) sum += meanOfColumn(color, x) - meanOfColumn(color, x + 2);
    return sum / 3;
  };
  EXPECT_LT(contrast(4), .5 * contrast(0));
  EXPECT_GT(contrast(0), .1);
}

}  // namespace render_peers_test
}  // namespace strobe::oracle
