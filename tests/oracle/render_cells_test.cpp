// SPDX-License-Identifier: MIT
// Cells show what need not be looked at: how large they are must not show in the picture.
#include <fmt/format.h>

#include <cmath>

#include "oracle/render.h"

namespace strobe::oracle {
namespace {

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
  static lab::Picture celled(const lab::Shot& shot, const std::vector<std::string>& nodes, int cell) {
    std::vector<std::string> settings = {"preset=captured", "tile=20"};
    for (const std::string& node : nodes) settings.push_back(fmt::format("{}.cell_side={}", node, cell));
    return render(with(shot, "hybrid", settings));
  }
};

const std::vector<std::string> kOfMask = {"mask_bounds", "mask_ids", "mask_crossings", "mask"};
const std::vector<std::string> kOfComposite = {"raster_bounds", "revealed_bounds", "motion_reach", "composite"};

// Cells that divide tiles: of one that does not the candidates of several tiles are tried.
TEST_F(RenderCells, DoNotShowInTheMask) {
  for (const char* camera : {"main", "tracking"})
    for (const char* anchor : {"close", "centre"}) {
      SCOPED_TRACE(fmt::format("{} {}", camera, anchor));
      lab::Picture finest = celled(room(camera, anchor), kOfMask, 1);
      ASSERT_GT(rms(imageOf(finest, "mask")), 0.05);
      for (int cell : {4, 10, 20})
        EXPECT_TRUE(identical(imageOf(celled(room(camera, anchor), kOfMask, cell), "mask"), imageOf(finest, "mask")))
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

// A cell as large as the picture leaves nothing out. What is left out is copied, not added up: 8 roundings of 2^-24
// each for 16 samples of colours up to 4. Single pixels beside edges at rest differ by more: a sample takes what is
// within half the distance between two samples of its place, and that may be the pixel's neighbour where the fastest
// motion around goes by.
TEST_F(RenderCells, DoNotShowInThePicture) {
  for (const char* camera : {"main", "tracking"}) {
    SCOPED_TRACE(camera);
    lab::Shot shot = room(camera, "close");
    image::Image truth = colorOf(render(with(shot, "ground_truth", {"samples=64", "mark_regions=false"})));
    image::Image whole = colorOf(celled(shot, kOfComposite, 1024));
    for (int cell : {1, 10, 33}) {
      SCOPED_TRACE(fmt::format("cells of {} px", cell));
      image::Image left_out = colorOf(celled(shot, kOfComposite, cell));
      EXPECT_LE(countDifferent(left_out, whole, 2e-6f), whole.width * whole.height / 500);
      EXPECT_LE(rmsDifference(left_out, truth), rmsDifference(whole, truth) * 1.0001);
    }
  }
}

// By truth, which knows no cells: what is copied is at rest there, bit for bit.
TEST_F(RenderCells, LeaveOutWhatNothingReaches) {
  lab::Shot shot = room("main", "close");
  shot.taps = {"motion_reach.moved"};
  lab::Picture picture = render(with(shot, "hybrid", {"tile=20"}));
  shot.taps.clear();
  const image::Image& moved = picture.frame.taps.at("motion_reach.moved").floats;
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

}  // namespace
}  // namespace strobe::oracle
