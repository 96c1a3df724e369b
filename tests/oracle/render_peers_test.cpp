// SPDX-License-Identifier: MIT
// Blurs of engines and papers since 2020: each does what it is known for, and shows the weakness it is known for.
// Against closed forms, and against truth where there is none.
#include <fmt/format.h>

#include <cmath>

#include "oracle/render.h"

namespace strobe::oracle {
namespace {

constexpr int kWidth = 256, kRows = 8, kRow = 4;

class RenderPeers : public RenderTest {};

// --- Bevy: each pixel along its own displacement

// On a bar over black, taps inside the bar are as many as times at which the bar is there: within, that is the
// exposure. Without, where truth has ramps as well, it is the sharp picture, bit for bit.
TEST_F(RenderPeers, BevyBlursNothingBeyondASilhouette) {
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
      if (inside) EXPECT_NEAR(color.at(x, kRow, 0), exact, 1. / kSamples + 1e-6) << x;
      if (!inside) EXPECT_EQ(color.at(x, kRow, 0), sharp.at(x, kRow, 0)) << x;
      if (inside) softest = std::min(softest, double(color.at(x, kRow, 0)));
      else missed = std::max(missed, exact);
    }
    bool centred = anchor.name == "centre";
    EXPECT_LT(softest, centred ? .55 : .1);  // half of the ramp, or all of it
    EXPECT_GT(missed, centred ? .45 : .9);   // the half that is not there, or all of the ramp at the other end
  }
}

// What is nearer and goes fast along the pixel's own line counts, although it goes away: a ghost where truth has none.
TEST_F(RenderPeers, BevyTakesWhatGoesAwayForWhatComes) {
  lab::Shot shot = shotOf("textured_bar", kWidth, kRows,
                          {{"d_f", 20}, {"d_b", -12}, {"period_b", 8}, {"b_light", .2}, {"b_dark", .2}});
  image::Image color = colorOf(render(with(shot, "bevy", {"samples=32"}, "close")));
  // To the right of a bar that has come from the left nothing but the background of .2 is ever seen.
  EXPECT_GT(color.at(162, kRow, 0), .4);
  EXPECT_FLOAT_EQ(color.at(180, kRow, 0), .2f);
}

}  // namespace
}  // namespace strobe::oracle
