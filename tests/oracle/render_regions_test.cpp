// SPDX-License-Identifier: MIT
// The region `self` of truth against a box seen in plan: which of its four sides a column's line of sight meets.
#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <optional>

#include "oracle/render.h"

namespace strobe::oracle {
namespace render_regions_test {

// Seen from above, x to the right and z towards the camera, whose lines of sight are parallel to z.
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

  // The normal of side `i` at t: towards the camera where z is positive.
  static double facing(int i, double angle) { return std::cos(angle + i * std::numbers::pi / 2); }

  struct Seen {
    int side;
    double along;   // of the side, from its middle, pixels
    double margin;  // to the nearest end of a side, pixels of the picture
  };

  // The side that the column of centre `x` sees at t; a convex shape shows every side that faces the camera.
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

// Columns of `self`, of which every row is alike.
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

// Its right side is seen before the capture, and faces away from the camera at it.
TEST_F(RenderRegions, SelfIsWhereAHiddenSideWasSeen) {
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

// What only slides shows the sides that it shows at the capture, though it uncovers the wall.
TEST_F(RenderRegions, SelfIsNothingOfABoxThatSlides) {
  for (const Anchor& anchor : anchors()) {
    lab::Picture picture = render(with(Box{.d_f = 20}.shot(), "ground_truth", {"samples=32"}, anchor.name));
    EXPECT_EQ(rms(imageOf(picture, "self")), 0) << anchor.name;
    EXPECT_GT(rms(imageOf(picture, "hidden")), 0) << anchor.name;
  }
}

// It was hidden by something else.
TEST_F(RenderRegions, SelfIsAlsoWhatAPostHid) {
  constexpr int kSamples = 32;
  for (const Anchor& anchor : anchors()) {
    Box box{.d_f = 20, .left = 45, .right = 52};
    lab::Picture picture = render(with(box.shot(), "ground_truth", {fmt::format("samples={}", kSamples)}, anchor.name));
    EXPECT_GT(expectSelf(picture, box, anchor.window, kSamples, anchor.name), 5) << anchor.name;
  }
}

}  // namespace render_regions_test
}  // namespace strobe::oracle
