// SPDX-License-Identifier: MIT
// A panel of cells passes a wall of cells, per pixel against the closed form: truth converges to it, and hybrid_layered
// has about the error of truth with as many samples.
#include <algorithm>
#include <cmath>

#include "oracle/render.h"

namespace strobe::oracle {
namespace render_passage_test {

constexpr int kWidth = 96, kHeight = 54;
constexpr double kAngle = 17;  // degrees, upwards

// A second implementation of scripts/scenes/stability/passage.lua and lib/stage.lua.
struct Panel {
  double left, top, right, bottom, cell, slant;
  uint32_t seed;
  std::vector<glm::dvec3> colors;

  double slantAt(double y) const { return slant * (y - (top + bottom) / 2); }
  bool holds(glm::dvec2 p) const {
    const double x = p.x - slantAt(p.y);
    return left <= x && x < right && top <= p.y && p.y < bottom;
  }
  glm::dvec3 colorAt(glm::dvec2 p) const {
    const auto column = uint32_t((p.x - slantAt(p.y) - left) / cell), row = uint32_t((p.y - top) / cell);
    uint32_t state = column * 374761393u + row * 668265263u + seed * 362437u;
    state = (state ^ (state >> 13)) * 1274126177u;
    return colors[((state ^ (state >> 16)) / 7) % colors.size()];
  }
};

const Panel kWall{-8, -8, kWidth + 8, kHeight + 8,
                  9,  0,  1,          {{.05, .12, .35}, {.25, .55, .7}, {.02, .05, .08}, {.45, .7, .55}}};
const Panel kPanel{33, 16, 62, 37, 12, .17, 2, {{.9, .35, .1}, {.95, .75, .2}, {.6, .08, .12}}};

// Mean colour at a pixel's centre over the exposure: exact, by integration between the passages of cell borders.
glm::dvec3 exposureAt(int x, int y, double speed, Window window) {
  const glm::dvec2 pixel(x + .5, y + .5);
  const glm::dvec2 d = speed * glm::dvec2(std::cos(glm::radians(kAngle)), -std::sin(glm::radians(kAngle)));
  std::vector<double> times = {window.open, window.close};
  auto addBorders = [&](double from, double to, double cell, double place, double rate) {
    auto add = [&](double border) {
      const double t = (place - border) / rate;  // place - rate * t = border
      if (rate != 0 && t > window.open && t < window.close) times.push_back(t);
    };
    for (double border = from; border < to; border += cell) add(border);
    add(to);
  };
  addBorders(kPanel.top, kPanel.bottom, kPanel.cell, pixel.y, d.y);
  addBorders(kPanel.left, kPanel.right, kPanel.cell, pixel.x - kPanel.slantAt(pixel.y), d.x - kPanel.slant * d.y);
  std::sort(times.begin(), times.end());
  glm::dvec3 sum(0);
  for (size_t i = 0; i + 1 < times.size(); ++i) {
    const glm::dvec2 now = pixel - d * ((times[i] + times[i + 1]) / 2);
    sum += (times[i + 1] - times[i]) * (kPanel.holds(now) ? kPanel.colorAt(now) : kWall.colorAt(pixel));
  }
  return sum / (window.close - window.open);
}

// Root mean square difference from the closed form.
double errorOf(const image::Image& color, double speed, Window window) {
  double sum = 0;
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x) {
      const glm::dvec3 apart =
          glm::dvec3(color.at(x, y, 0), color.at(x, y, 1), color.at(x, y, 2)) - exposureAt(x, y, speed, window);
      sum += glm::dot(apart, apart);
    }
  return std::sqrt(sum / (kWidth * kHeight));
}

class RenderPassage : public RenderTest {
 protected:
  static image::Image drawn(double speed, const Anchor& anchor, const std::string& pipeline,
                            const std::vector<std::string>& set) {
    lab::Shot shot = shotOf("../stability/passage", kWidth, kHeight, {{"speed", speed}, {"angle", kAngle}});
    return colorOf(render(with(shot, pipeline, set, anchor.name)));
  }
};

TEST_F(RenderPassage, TruthConvergesToTheClosedForm) {
  for (const Anchor& anchor : anchors()) {
    double last = INFINITY;
    for (int samples : {16, 256, 1024}) {
      const image::Image truth =
          drawn(20, anchor, "ground_truth", {fmt::format("samples={}", samples), "times=midpoint"});
      const double off = errorOf(truth, 20, anchor.window);
      EXPECT_LT(off, last / 3) << anchor.name << ", " << samples;
      last = off;
    }
  }
}

// Successive samples are at least two pixels apart. If they were closer, truth would resolve parts of a pixel.
TEST_F(RenderPassage, LayersHaveTheErrorOfTruthWithAsManySamples) {
  double most = 0;
  for (const Anchor& anchor : anchors())
    for (double speed : {10., 30., 100.})
      for (const char* samples : {"samples=1", "samples=4"}) {
        const double layered = errorOf(drawn(speed, anchor, "hybrid_layered", {samples}), speed, anchor.window);
        const double floor =
            errorOf(drawn(speed, anchor, "ground_truth", {samples, "times=midpoint"}), speed, anchor.window);
        EXPECT_LE(layered, 1.3 * floor) << anchor.name << ", " << speed << " px, " << samples;
        most = std::max(most, layered / floor);
      }
  fmt::print("at most {:.3f} times the error of truth of as many samples\n", most);
}

}  // namespace render_passage_test
}  // namespace strobe::oracle
