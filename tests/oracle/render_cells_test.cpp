// SPDX-License-Identifier: MIT
// Cells skip work. The cell size must not change the picture.
#include <fmt/format.h>

#include <cmath>

#include "oracle/render.h"

namespace strobe::oracle {
namespace render_cells_test {

class RenderCells : public RenderTest {
 protected:
  static lab::Shot room(const std::string& camera, const std::string& anchor) {
    lab::Shot shot;
    shot.scene = "living_room";
    shot.camera = camera;
    shot.anchor = anchor;
    shot.width = 160;
    shot.height = 90;
    return shot;
  }
  static lab::Picture celled(const lab::Shot& shot, const std::vector<std::string>& nodes, int cell,
                             const std::string& pipeline = "hybrid_layered", std::vector<std::string> settings = {}) {
    settings.push_back("tile=20");
    for (const std::string& node : nodes) settings.push_back(fmt::format("{}.cell_side={}", node, cell));
    return render(with(shot, pipeline, settings));
  }
};

// Nodes that share cells: the composite reads the mask's bounds too.
const std::vector<std::string> kNodes = {"mask_bounds",     "mask_ids",       "cull_candidates", "mask",
                                         "revealed_bounds", "classify_cells", "composite"};

// The lowest and highest id in each cell. The picture's border cuts off the last cells.
TEST_F(RenderCells, CellsHoldTheIdsOfTheirPixels) {
  constexpr int kSide = 7;
  std::vector<std::string> settings;
  for (const std::string& node : kNodes) settings.push_back(fmt::format("{}.cell_side={}", node, kSide));
  lab::Shot shot = with(shotOf("crowd", 64, 40), "hybrid_layered", settings);
  shot.taps = {"mask_ids.ids"};
  const lab::Picture picture = render(shot);
  const image::UintImage &ids = picture.frame.taps.at(shot.taps[0]).uints, &id = picture.frame.outputs.at("id").uints;
  ASSERT_EQ(ids.height, (40 + kSide - 1) / kSide);
  for (int y = 0; y < ids.height; ++y)
    for (int x = 0; x < ids.width; ++x) {
      uint32_t least = UINT32_MAX, greatest = 0;
      for (int j = kSide * y; j < std::min(kSide * y + kSide, id.height); ++j)
        for (int i = kSide * x; i < std::min(kSide * x + kSide, id.width); ++i) {
          least = std::min(least, id.at(i, j, 0));
          greatest = std::max(greatest, id.at(i, j, 0));
        }
      EXPECT_EQ(ids.at(x, y, 0), least) << x << ' ' << y;
      EXPECT_EQ(ids.at(x, y, 1), greatest) << x << ' ' << y;
    }
}

// Cells of the disocclusion mask.
struct MaskCells {
  const image::Image& bounds;  // of the displacements in each cell
  const image::UintImage& ids;
  int side, picture;

  vec2 low(ivec2 cell) const { return {bounds.at(cell.x, cell.y, 0), bounds.at(cell.x, cell.y, 1)}; }
  vec2 high(ivec2 cell) const { return {bounds.at(cell.x, cell.y, 2), bounds.at(cell.x, cell.y, 3)}; }

  // True if a walk from `own` for candidate b may end in the cell with a result other than "no". Lengths are compared
  // to within `slack` px.
  bool concerns(ivec2 own, ivec2 cell, vec2 b, float t, float slack) const {
    const uint32_t only = ids.at(own.x, own.y, 0);
    if (ids.at(own.x, own.y, 1) == only && ids.at(cell.x, cell.y, 0) == only && ids.at(cell.x, cell.y, 1) == only)
      return false;
    const float longest = glm::length(glm::max(glm::abs(low(own) - b), glm::abs(high(own) - b)));
    const float from_b = glm::length(glm::clamp(b, low(cell), high(cell)) - b);
    const vec2 apart = glm::max(glm::abs(high(cell) - low(own)), glm::abs(high(own) - low(cell)));
    return from_b <= std::max(1.f, .25f * longest) + slack || std::abs(t) * glm::length(apart) >= .5f - slack;
  }

  // True if a path for candidate b enters such a cell. Paths start at several pixels and displacements of `own`,
  // advance one pixel per step and continue `farther` px past their end.
  bool isCrossed(ivec2 own, vec2 b, float t, int farther) const {
    for (int k = 0; k < 25 * 4; ++k) {
      const vec2 d = glm::mix(low(own), high(own), vec2(float(k % 5), float(k / 5 % 5)) / 4.f);
      const ivec2 from = glm::min(own * side + ivec2(k / 25 % 2, k / 50) * (side - 1), picture - 1);
      const vec2 whole = -t * (d - b);
      const float whole_px = glm::length(whole);
      if (whole_px < .51f) continue;
      for (int i = 1; i <= int(std::ceil(whole_px)) + farther; ++i) {
        const ivec2 at = from + ivec2(glm::round(whole / whole_px * float(i)));
        if (glm::min(at.x, at.y) < 0 || glm::max(at.x, at.y) >= picture) break;
        if (concerns(own, at / side, b, t, -.01f)) return true;
      }
    }
    return false;
  }

  // True if such a cell lies within reach of a path in any direction.
  bool isNearAny(ivec2 own, vec2 b, float t, int farther) const {
    const float longest = std::abs(t) * glm::length(glm::max(glm::abs(low(own) - b), glm::abs(high(own) - b)));
    if (longest < .49f) return false;
    const int around = (int(longest) + farther) / side + 2;
    for (int y = std::max(own.y - around, 0); y <= std::min(own.y + around, bounds.height - 1); ++y)
      for (int x = std::max(own.x - around, 0); x <= std::min(own.x + around, bounds.width - 1); ++x)
        if (concerns(own, {x, y}, b, t, .01f)) return true;
    return false;
  }
};

// A cell keeps each candidate of its tile with a path into a cell where a walk may end. It drops each candidate without
// such a cell nearby.
TEST_F(RenderCells, CellsKeepTheCandidatesThatCross) {
  constexpr int kSide = 10, kTile = 20, kPicture = 96, kLimit = 24, kMargin = 1;
  for (const Anchor& anchor : anchors()) {
    lab::Shot shot = with(shotOf("wedge", kPicture, kPicture, {{"from", 20}, {"to", 65}, {"degrees", 60}}),
                          "hybrid_layered", {fmt::format("tile={}", kTile), "limit=0.25"}, anchor.name);
    shot.taps = {"mask_bounds.bounds", "mask_ids.ids"};
    for (int k = 0; k < 4; ++k) shot.taps.push_back(fmt::format("gather_candidates.candidates_{}", k));
    for (int k = 0; k < 4; ++k) shot.taps.push_back(fmt::format("cull_candidates.culled_{}", k));
    const lab::Picture picture = render(shot);
    const MaskCells cells{picture.frame.taps.at(shot.taps[0]).floats, picture.frame.taps.at(shot.taps[1]).uints, kSide,
                          kPicture};
    auto motion = [&](int of, ivec2 at, int k) {
      const image::Image& image = picture.frame.taps.at(shot.taps[size_t(of + k / 2)]).floats;
      return vec2(image.at(at.x, at.y, k % 2 * 2), image.at(at.x, at.y, k % 2 * 2 + 1));
    };
    int kept = 0, left_out = 0;
    for (int y = 0; y < cells.bounds.height; ++y)
      for (int x = 0; x < cells.bounds.width; ++x)
        for (int k = 0; k < 8; ++k) {
          const ivec2 own(x, y);
          const vec2 b = motion(2, own * kSide / kTile, k);
          if (b.x > 1e8f) continue;  // none
          bool has = false, crossed = false, any = false;
          for (int i = 0; i < 8; ++i) has = has || motion(6, own, i) == b;
          for (double t : {anchor.window.open, anchor.window.close}) {
            if (t == 0) continue;
            crossed = crossed || cells.isCrossed(own, b, float(t), kMargin + kLimit);
            any = any || cells.isNearAny(own, b, float(t), kMargin + kLimit + 4);
          }
          if (crossed) EXPECT_TRUE(has) << anchor.name << ' ' << x << ' ' << y << ' ' << b.x << ' ' << b.y;
          if (!any) EXPECT_FALSE(has) << anchor.name << ' ' << x << ' ' << y << ' ' << b.x << ' ' << b.y;
          ++(has ? kept : left_out);
        }
    EXPECT_GT(kept, 50) << anchor.name;
    EXPECT_GT(left_out, 50) << anchor.name;
  }
}

// Sides that divide the tile side. Cells of other sides test the candidates of several tiles.
TEST_F(RenderCells, CellSizeDoesNotChangeTheMask) {
  for (const char* camera : {"main", "tracking"})
    for (const char* anchor : {"end", "centre"}) {
      SCOPED_TRACE(fmt::format("{} {}", camera, anchor));
      lab::Picture finest = celled(room(camera, anchor), kNodes, 1);
      ASSERT_GT(rms(imageOf(finest, "mask")), 0.05);
      for (int cell : {4, 10, 20})
        EXPECT_TRUE(identical(imageOf(celled(room(camera, anchor), kNodes, cell), "mask"), imageOf(finest, "mask")))
            << "cells of " << cell << " px";
    }
}

int countDifferent(const image::Image& a, const image::Image& b, float by) {
  int count = 0;
  for (int y = 0; y < a.height; ++y)
    for (int x = 0; x < a.width; ++x) {
      float most = 0;
      for (int c = 0; c < 3; ++c) most = std::max(most, std::abs(a.at(x, y, c) - b.at(x, y, c)));
      count += most > by;
    }
  return count;
}

// A cell as large as the picture skips nothing. Skipped pixels are copied, not summed: the difference is 8 roundings of
// 2^-24 each for 16 samples of colours up to 4. Single pixels beside static edges differ more: a sample takes a surface
// within half the distance between two samples, and where the fastest motion passes that may be the pixel's neighbour.
TEST_F(RenderCells, CellSizeDoesNotChangeThePicture) {
  for (const char* camera : {"main", "tracking"}) {
    SCOPED_TRACE(camera);
    lab::Shot shot = room(camera, "end");
    image::Image truth = colorOf(render(with(shot, "ground_truth", {"samples=64", "mark_regions=false"})));
    // The mask has no cells, so only the composite changes.
    const std::vector<std::string> nodes = {"raster_bounds", "revealed_bounds", "classify_cells", "composite"};
    auto drawn = [&](int cell) { return colorOf(celled(shot, nodes, cell, hybridSteps(), {"mask=moving"})); };
    image::Image whole = drawn(1024);
    for (int cell : {1, 10, 33}) {
      SCOPED_TRACE(fmt::format("cells of {} px", cell));
      image::Image left_out = drawn(cell);
      EXPECT_LE(countDifferent(left_out, whole, 2e-6f), whole.width * whole.height / 500);
      EXPECT_LE(rmsDifference(left_out, truth), rmsDifference(whole, truth) * 1.0001);
    }
  }
}

// Truth has no cells: copied pixels are static in it, bit for bit.
TEST_F(RenderCells, SkippedPixelsAreStatic) {
  lab::Shot shot = room("main", "end");
  shot.taps = {"classify_cells.moved"};
  lab::Picture picture = render(with(shot, "hybrid_layered", {"tile=20"}));
  shot.taps.clear();
  const image::Image& moved = picture.frame.taps.at("classify_cells.moved").floats;
  lab::Shot at_once = shot;
  at_once.exposure = 0;
  image::Image still = colorOf(render(with(at_once, "ground_truth", {"samples=1", "mark_regions=false"})));
  image::Image truth = colorOf(render(with(shot, "ground_truth", {"samples=32", "mark_regions=false"})));
  int left_out = 0;
  for (int y = 0; y < still.height; ++y)
    for (int x = 0; x < still.width; ++x) {
      if (moved.at(x / 10, y / 10, 0) > .5f) continue;
      ++left_out;
      for (int c = 0; c < 3; ++c) ASSERT_EQ(truth.at(x, y, c), still.at(x, y, c)) << "pixel " << x << ", " << y;
    }
  EXPECT_GT(left_out, still.width * still.height / 2);
}

}  // namespace render_cells_test
}  // namespace strobe::oracle
