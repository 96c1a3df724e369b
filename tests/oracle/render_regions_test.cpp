// SPDX-License-Identifier: MIT
// The region `self` of truth against a box in plan view, where each column's view ray hits at most one of four sides.
#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <optional>

#include "oracle/render.h"

namespace strobe::oracle {
namespace render_regions_test {

// Plan view: x to the right, z towards the camera. The view rays are parallel to z.
struct Box {
  double side = 30, at = 48, yaw = 20, degrees = 0, d_f = 0, left = 0, right = 0;

  lab::Shot shot() const {
    return shotOf("turning_box", 96, 4,
                  {{"side", side},
                   {"at", at},
                   {"yaw", yaw},
                   {"degrees", degrees},
                   {"d_f", d_f},
                   {"left", left},
                   {"right", right}});
  }

  double angle(double t) const { return (yaw + degrees * t) * std::numbers::pi / 180; }

  // Component along z of the normal of side `i`: positive towards the camera.
  static double facing(int i, double angle) { return std::cos(angle + i * std::numbers::pi / 2); }

  struct Seen {
    int side;
    double along;   // on the side, from its middle, px
    double margin;  // to the nearest end of a side, pixels of the picture
  };

  // Side that is visible at t in the column of centre `x`; every side of a convex shape that faces the camera is
  // visible.
  std::optional<Seen> seen(double x, double t) const {
    double from_axis = x - at - d_f * t, angle = this->angle(t);
    for (int i = 0; i < 4; ++i) {
      double turned = angle + i * std::numbers::pi / 2, facing = std::cos(turned);
      if (facing <= 1e-9) continue;
      // Middle of the side: its normal (sin, cos) times half a side; its direction: (cos, -sin).
      double along = (from_axis - std::sin(turned) * side / 2) / facing;
      if (std::abs(along) < side / 2) return Seen{i, along, (side / 2 - std::abs(along)) * facing};
    }
    return std::nullopt;
  }

  double columnAtCapture(const Seen& seen) const {
    double turned = angle(0) + seen.side * std::numbers::pi / 2;
    return at + std::sin(turned) * side / 2 + seen.along * std::cos(turned);
  }
  bool isBehindPost(double x) const { return x >= left && x < right; }
  bool isOccludedAtCapture(const Seen& seen) const {
    return facing(seen.side, angle(0)) <= 0 || isBehindPost(columnAtCapture(seen));
  }
};

class RenderRegions : public RenderTest {};

// Compares the columns of `self`, whose rows are all equal.
int expectSelf(const lab::Picture& picture, const Box& box, Window window, int samples, const std::string& what) {
  const image::Image& self = imageOf(picture, "self");
  const image::Image& hidden = imageOf(picture, "hidden");
  int found = 0;
  for (int x = 0; x < self.width; ++x) {
    double column = x + .5;
    auto now = box.seen(column, 0);
    bool expected = false, is_sure = !now || now->margin > 1e-2;
    for (int i = 0; i < samples && !box.isBehindPost(column); ++i) {
      auto seen = box.seen(column, window.open + (i + .5) / samples * (window.close - window.open));
      is_sure = is_sure && (!seen || seen->margin > 1e-2);
      expected = expected || (now && seen && box.isOccludedAtCapture(*seen));
    }
    if (!is_sure) continue;
    found += expected;
    for (int y = 0; y < self.height; ++y) {
      EXPECT_EQ(self.at(x, y, 0) > .5f, expected) << what << " column " << x;
      EXPECT_LE(self.at(x, y, 0), hidden.at(x, y, 0)) << what << " column " << x;
    }
  }
  return found;
}

// A side is visible within the exposure, and faces away from the camera at the raster time.
TEST_F(RenderRegions, SelfMarksHiddenSidesOfATurningBox) {
  constexpr int kSamples = 32;
  for (const Anchor& anchor : anchors()) {
    int found = 0;
    for (double degrees : {40.0, -75.0, 130.0}) {
      Box box{.degrees = degrees};
      lab::Picture picture =
          render(with(box.shot(), "ground_truth", {fmt::format("samples={}", kSamples)}, anchor.name));
      found += expectSelf(picture, box, anchor.window, kSamples, fmt::format("{} {}", anchor.name, degrees));
    }
    EXPECT_GT(found, 10) << anchor.name;
  }
}

// A sliding box shows the same sides throughout, although it uncovers the wall.
TEST_F(RenderRegions, SelfIsEmptyForASlidingBox) {
  for (const Anchor& anchor : anchors()) {
    lab::Picture picture = render(with(Box{.d_f = 20}.shot(), "ground_truth", {"samples=32"}, anchor.name));
    EXPECT_EQ(rms(imageOf(picture, "self")), 0) << anchor.name;
    EXPECT_GT(rms(imageOf(picture, "hidden")), 0) << anchor.name;
  }
}

// Here a post hides the side at the raster time.
TEST_F(RenderRegions, SelfMarksSidesBehindAPost) {
  constexpr int kSamples = 32;
  for (const Anchor& anchor : anchors()) {
    Box box{.d_f = 20, .left = 45, .right = 52};
    lab::Picture picture = render(with(box.shot(), "ground_truth", {fmt::format("samples={}", kSamples)}, anchor.name));
    EXPECT_GT(expectSelf(picture, box, anchor.window, kSamples, anchor.name), 5) << anchor.name;
  }
}

}  // namespace render_regions_test
}  // namespace strobe::oracle
