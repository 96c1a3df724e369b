// SPDX-License-Identifier: MIT
// Passes that run over lists of pixels, and buffers: against the masks, and against the same passes without lists.
#include <fmt/format.h>

#include <array>

#include "common/home.h"
#include "common/source.h"
#include "oracle/render.h"
#include "shader/backends.h"

namespace strobe::oracle {
namespace render_lists_test {

class RenderLists : public RenderTest {
 protected:
  static lab::Picture listed(lab::Shot shot, const std::vector<std::string>& settings,
                             std::vector<std::string> taps = {}) {
    const Path project = sourceFolder() / "tests/oracle/project";
    lab::Workbench own(Home({project, home().shipped()}, home().data(), home().program()), bench());
    shot.taps = std::move(taps);
    return own.render(with(shot, "lists", settings, "end"));
  }
};

// Sides that are not multiples of 8, so the border cuts off squares of 8x8 pixels.
lab::Shot crowd() { return shotOf("crowd", 90, 51); }

TEST_F(RenderLists, ExactlyTheMaskedPixelsRunOnce) {
  const lab::Picture picture = listed(crowd(), {});
  const image::Image &mask = imageOf(picture, "mask"), &copied = imageOf(picture, "copied");
  const image::UintImage& times = picture.frame.outputs.at("times").uints;
  int masked = 0;
  for (int y = 0; y < mask.height; ++y)
    for (int x = 0; x < mask.width; ++x) {
      const bool is = mask.at(x, y, 0) > .5f;
      masked += is;
      ASSERT_EQ(times.at(x, y, 0), is ? 1u : 0u) << x << ", " << y;
      ASSERT_EQ(copied.at(x, y, 0), is ? colorOf(picture).at(x, y, 0) : 0.f) << x << ", " << y;
    }
  EXPECT_GT(masked, 200);
  EXPECT_LT(masked, mask.width * mask.height - 200);
}

TEST_F(RenderLists, WithoutAListEveryPixelRuns) {
  const lab::Picture picture = listed(crowd(), {"over=picture"});
  for (uint32_t times : picture.frame.outputs.at("times").uints.values) ASSERT_EQ(times, 1u);
}

// Squares of 8x8 pixels row by row; in each square, blocks of 4x2 pixels, two side by side.
TEST_F(RenderLists, ListsAreOrderedBySquares) {
  const lab::Picture picture = listed(crowd(), {}, {"moving_list.list"});
  const image::Image& mask = imageOf(picture, "mask");
  const std::vector<uint32_t>& entries = picture.frame.taps.at("moving_list.list").uints.values;
  size_t at = 0;
  for (int top = 0; top < mask.height; top += 8)
    for (int left = 0; left < mask.width; left += 8)
      for (int block_y = 0; block_y < 8; block_y += 2)
        for (int block_x = 0; block_x < 8; block_x += 4)
          for (int i = 0; i < 8; ++i) {
            const int x = left + block_x + i % 4, y = top + block_y + i / 4;
            if (x >= mask.width || y >= mask.height || mask.at(x, y, 0) <= .5f) continue;
            ASSERT_EQ(entries.at(at++), uint32_t(x) | uint32_t(y) << 16);
          }
  for (; at < entries.size(); ++at) ASSERT_EQ(entries.at(at), 0u) << "after the end of the list";
}

TEST_F(RenderLists, BuffersCountAtomically) {
  const lab::Picture picture = listed(crowd(), {});
  std::array<int, 16> expected{};
  const image::Image &mask = imageOf(picture, "mask"), &color = colorOf(picture);
  for (int y = 0; y < mask.height; ++y)
    for (int x = 0; x < mask.width; ++x)
      if (mask.at(x, y, 0) > .5f) ++expected.at(size_t(std::clamp(int(color.at(x, y, 0) * 16.f), 0, 15)));
  for (int i = 0; i < 16; ++i) EXPECT_EQ(imageOf(picture, "bins").at(i, 0, 0), float(expected.at(size_t(i)))) << i;
}

// Without motion no pixel is masked, and the list dispatches no workgroup.
TEST_F(RenderLists, AnEmptyListRunsNothing) {
  const lab::Picture picture = listed(shotOf("bar", 64, 16, {{"d_f", 0}}), {});
  for (uint32_t times : picture.frame.outputs.at("times").uints.values) ASSERT_EQ(times, 0u);
}

// The list has more entries than an image may have columns.
TEST_F(RenderLists, AWidePictureHasALongList) {
  const lab::Picture picture = listed(shotOf("bar", 2200, 8, {{"d_f", 20}}), {"limit=0.02"});
  const std::vector<uint32_t>& times = picture.frame.outputs.at("times").uints.values;
  const std::vector<float>& mask = imageOf(picture, "mask").values;
  ASSERT_EQ(times.size(), mask.size());
  for (size_t i = 0; i < times.size(); ++i) ASSERT_EQ(times[i], mask[i] > .5f ? 1u : 0u) << i;
  EXPECT_GT(std::count(times.begin(), times.end(), 1u), 0);
}

}  // namespace render_lists_test
}  // namespace strobe::oracle
