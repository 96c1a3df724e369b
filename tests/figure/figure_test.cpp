// SPDX-License-Identifier: MIT
// Figures of given pictures: positions of pixels and marks, measured numbers, and the same bytes in every order and on
// every machine.
#include <gtest/gtest.h>

#include <clocale>
#include <cmath>
#include <cstdlib>

#include "figure/captions.h"
#include "figures.h"
#include "image/false_colour.h"
#include "image/flip.h"
#include "image/metrics.h"
#include "image/png.h"
#include "page/number.h"
#include "program/run.h"

namespace strobe::figure {
namespace figure_test {

using image::Image;
using image::Rectangle;
using strobe::testing::contentOf;
using strobe::testing::TemporaryFolder;

constexpr Colour kYellow = {1.0f, 0xd2 / 255.0f, 0x1e / 255.0f};

const Image& colorOf(const std::string& arm, int step = 0) {
  return findTaken("still", arm, step).picture->frame.outputs.at("color").floats;
}

Colour shownAt(const Image& linear, int x, int y) {
  return colourAt(image::toneMap(image::threeChannels(linear)), x, y);
}

// The measured text of a caption in the figure of arm "plain".
std::string captionOf(const std::string& caption) {
  FigureData figure = figureFrom(dataOf("name = 'x', shot = 'still', arm = 'plain', caption = '" + caption + "'"));
  Problems problems;
  Block block = blockOf(figure, figure.cells.at(0), findTaken, "truth", 0, problems);
  problems.throwIfAny();
  return block.caption;
}

void expectError(const std::string& lua, const std::string& expected) {
  try {
    layoutOf(lua);
    ADD_FAILURE() << "no error: " << lua;
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find(expected), std::string::npos)
        << error.what() << "\nexpected: " << expected;
  }
}

TEST(Figure, PicturesAreCopiedPixelByPixelIntoTheirCells) {
  Layout layout = layoutOf(R"(name = "x", shot = "still", arm = "plain", border = 2, letters = false,
    columns = { { label = "whole" }, { label = "part", crop = { 10, 4, 8, 6 }, zoom = 5 } })");
  Image figure = pixelsOf(layout);
  Rectangle whole = layout.picture(0, 0), part = layout.picture(0, 1);
  ASSERT_EQ(whole.width, kWidth);
  ASSERT_EQ(part.width, 40);
  ASSERT_EQ(part.height, 30);
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x)
      ASSERT_EQ(levelsApart(colourAt(figure, whole.x + x, whole.y + y), shownAt(colorOf("plain"), x, y)), 0)
          << x << " " << y;
  for (int y = 0; y < 30; ++y)
    for (int x = 0; x < 40; ++x)
      ASSERT_EQ(levelsApart(colourAt(figure, part.x + x, part.y + y), shownAt(colorOf("plain"), 10 + x / 5, 4 + y / 5)),
                0);
  EXPECT_LT(colourAt(figure, whole.x - 2, whole.y - 2)[0], 0.2f) << "the border";
  EXPECT_EQ(levelsApart(colourAt(figure, whole.x - 3, whole.y - 3), {1, 1, 1}), 0);
}

TEST(Figure, InsetFramesMarkTheirSource) {
  Layout layout = layoutOf(R"(name = "x", shot = "still", arm = "plain", zoom = 4,
    insets = { { crop = { 8, 4, 10, 6 }, zoom = 8, frame = "yellow", at = "below" } },
    boxes = { { area = { 30, 10, 5, 5 }, color = "#0000ff", width = 1 } })");
  Image figure = pixelsOf(layout);
  Rectangle picture = layout.picture(0, 0);
  auto at = [&](int x, int y) { return colourAt(figure, picture.x + x, picture.y + y); };
  for (auto [x, y] : {std::pair{32, 16}, {71, 16}, {32, 39}, {71, 39}, {50, 17}})
    EXPECT_EQ(levelsApart(at(x, y), kYellow), 0) << x << " " << y;
  EXPECT_GT(levelsApart(at(31, 15), kYellow), 5) << "outside";
  EXPECT_GT(levelsApart(at(40, 24), kYellow), 5) << "inside";
  EXPECT_EQ(levelsApart(at(120, 40), {0, 0, 1}), 0);
  EXPECT_EQ(levelsApart(at(139, 59), {0, 0, 1}), 0);
  // The inset below the picture: its coloured frame, then its pixels.
  int top = picture.y + picture.height + 6;
  EXPECT_EQ(levelsApart(colourAt(figure, picture.x, top), kYellow), 0);
  EXPECT_EQ(levelsApart(colourAt(figure, picture.x + 2, top + 2), shownAt(colorOf("plain"), 8, 4)), 0);
  EXPECT_EQ(levelsApart(colourAt(figure, picture.x + 2 + 79, top + 2 + 47), shownAt(colorOf("plain"), 17, 9)), 0);
}

// Bounding box of the pixels that differ between two drawings.
Rectangle changed(const Image& a, const Image& b, const Rectangle& within) {
  Rectangle box = {within.width, within.height, 0, 0};
  int right = -1, bottom = -1;
  for (int y = 0; y < within.height; ++y)
    for (int x = 0; x < within.width; ++x) {
      if (levelsApart(colourAt(a, within.x + x, within.y + y), colourAt(b, within.x + x, within.y + y)) < 40) continue;
      box.x = std::min(box.x, x), box.y = std::min(box.y, y), right = std::max(right, x), bottom = std::max(bottom, y);
    }
  box.width = right - box.x + 1, box.height = bottom - box.y + 1;
  return box;
}

TEST(Figure, ArrowsPointAtPixelsAndAtNodes) {
  const std::string cell = R"(name = "x", shot = "still", arm = "plain", zoom = 8, )";
  Layout bare = layoutOf(cell);
  Image without = pixelsOf(bare);
  Rectangle picture = bare.picture(0, 0);
  // The tip is in the middle of the pixel: 8 * (20 + 1/2), 8 * (12 + 1/2); the tail 10 pixels above.
  Rectangle box =
      changed(pixelsOf(layoutOf(cell + "arrows = { { to = { 20, 12 }, by = { 0, -10 } } }")), without, picture);
  EXPECT_NEAR(box.x + box.width / 2.0, 164, 1.1);
  EXPECT_NEAR(box.y + box.height, 100, 2.5) << "including the border of the tip";
  EXPECT_NEAR(box.y, 20, 2.5);
  // The ball is at ndc (1/2, 1/2): three quarters of the width from the left, a quarter of the height from the top.
  box = changed(pixelsOf(layoutOf(cell + "arrows = { { on = 'ball', by = { -10, 0 } } }")), without, picture);
  EXPECT_NEAR(box.x + box.width, 0.75 * 512, 2.5);
  EXPECT_NEAR(box.y + box.height / 2.0, 0.25 * 288, 1.1);
  box = changed(pixelsOf(layoutOf(cell + "circles = { { on = 'ball', radius = 4, width = 2 } }")), without, picture);
  EXPECT_NEAR(box.x + box.width / 2.0, 0.75 * 512, 1.1);
  EXPECT_NEAR(box.width, 64 + 2 + 2, 3);
  // Marks at points behind the camera are not drawn.
  Image behind = pixelsOf(layoutOf(cell + "circles = { { on = 'behind', radius = 4 } }"));
  EXPECT_EQ(behind.values, without.values);
}

TEST(Figure, RangeSpansTheFiltersSamples) {
  const std::string cell = R"(name = "x", shot = "still", arm = "plain", zoom = 8, )";
  Layout bare = layoutOf(cell);
  Image without = pixelsOf(bare);
  Rectangle picture = bare.picture(0, 0);
  // The pixel (20, 12) moves by 12 px to the right. The caps' borders reach a few pixels further.
  auto ends = [&](const std::string& more) {
    Rectangle box =
        changed(pixelsOf(layoutOf(cell + "ranges = { { at = { 20, 12 }" + more + " } }")), without, picture);
    return std::pair(box.x + 3.0, box.x + box.width - 3.0);
  };
  auto [left, right] = ends(", anchor = 'end'");
  EXPECT_NEAR(right, 8 * 32.5, 2) << "earlier, the surface now at x = 32 covered the pixel";
  EXPECT_NEAR(left, 8 * 20.5 - 4, 4) << "the pixel at the end";
  std::tie(left, right) = ends(", anchor = 'start'");
  EXPECT_NEAR(left, 8 * 8.5, 2);
  EXPECT_NEAR(right, 8 * 20.5 + 4, 4);
  std::tie(left, right) = ends("");
  EXPECT_NEAR(left, 8 * 14.5, 2) << "the shot's anchor: centre";
  EXPECT_NEAR(right, 8 * 26.5, 2);
  // Along a velocity image of half the size: (0, 16) at the pixel's texel (10, 6).
  Rectangle box =
      changed(pixelsOf(layoutOf(cell + "ranges = { { at = { 20, 12 }, along = 'half.speed', anchor = 'end' } }")),
              without, picture);
  EXPECT_NEAR(box.y + box.height, 8 * 28.5 + 3, 2);
  EXPECT_LT(box.width, 24);
}

TEST(Figure, DifferencesHaveAScaleBar) {
  FigureData figure = figureFrom(dataOf(R"(name = "x", shot = "still", arm = "plain", columns = {
    { against = "truth", gain = 4 }, { against = "truth", difference = "channels", gain = 2 },
    { against = "truth", difference = "flip" } })"));
  std::vector<Block> blocks;
  Problems problems;
  for (const FigureCell& cell : figure.cells) blocks.push_back(blockOf(figure, cell, findTaken, "truth", 0, problems));
  problems.throwIfAny();
  EXPECT_EQ(blocks[0].legend.kind, image::Legend::Kind::bar);
  EXPECT_EQ(blocks[0].legend.high, 0.25);
  EXPECT_EQ(levelsApart(colourAt(blocks[0].main.display, 40, 5), image::magma(4 * 0.0625f / 3)), 0);
  EXPECT_EQ(levelsApart(colourAt(blocks[0].main.display, 10, 5), image::magma(0)), 0);
  EXPECT_EQ(blocks[1].legend.text, "|difference from truth| × 2");
  EXPECT_EQ(levelsApart(colourAt(blocks[1].main.display, 40, 5), {0, 0, 0.125f}), 0);
  EXPECT_EQ(blocks[2].legend.text, "FLIP");
  Image flip = image::ldrFlip(colorOf("plain"), colorOf("truth"));
  EXPECT_EQ(levelsApart(colourAt(blocks[2].main.display, 40, 5), image::magma(flip.at(40, 5, 0))), 0);
}

TEST(Figure, CaptionsAreMeasured) {
  const Image &color = colorOf("plain"), &truth = colorOf("truth");
  Image inner = findTaken("still", "truth", 0).picture->frame.outputs.at("inner").floats;
  // The images differ by 1/16 in one of three channels at 43/64 of the pixels.
  double rmse = std::sqrt(43.0 / 64 / 3) / 16;
  EXPECT_EQ(captionOf("RMSE {rmse}"), "RMSE " + page::shownError(rmse));
  EXPECT_EQ(captionOf("{rmse inner %.3f} inside"), fmt::format("{:.3f} inside", std::sqrt(0.9 / 3) / 16));
  EXPECT_EQ(captionOf("{rmse inner}"), page::shownError(image::rootMeanSquaredError(color, truth, inner)));
  EXPECT_EQ(captionOf("{flip}, {flip inner %.2g}"),
            fmt::format("{}, {:.2g}", page::shownError(image::meanOf(image::ldrFlip(color, truth))),
                        image::meanOf(image::ldrFlip(color, truth), inner)));
  EXPECT_EQ(captionOf("{psnr}"), fmt::format("{:.2f} dB", image::psnr(color, truth)));
  EXPECT_EQ(captionOf("{ssim inner}"), fmt::format("{:.4f}", *image::ssim(color, truth, inner)));
  EXPECT_EQ(captionOf("{smape} {relmse} {mse}"),
            fmt::format("{} {} {}", page::shownError(image::smape(color, truth)),
                        page::shownError(image::relativeMse(color, truth)), page::shownError(rmse * rmse)));
  EXPECT_EQ(
      captionOf("exposure {exposure}, {set.samples} samples, tile {set.half.tile}, {scene.pixels} px, {arm} {step}"),
      "exposure 0.5, 16 samples, tile 2, 40 px, plain 0");
}

// PDF files contain text with a font, pictures and lines, and always have the same date.
TEST(Figure, PageHasTextAndPictures) {
  TemporaryFolder folder;
  Json data = dataOf(R"(name = "x", shot = "still", arm = "plain", title = "Title", width_mm = 85,
                        arrows = { { to = { 9, 9 } } })");
  std::vector<Path> files = writeFigure(data, findTaken, "truth", folder.path());
  ASSERT_EQ(files.size(), 2u);
  EXPECT_EQ(files[0], folder.path() / "x.png");
  std::string page = contentOf(files[1]);
  EXPECT_TRUE(page.starts_with("%PDF-1.4"));
  for (const char* part : {"/BaseFont", "DejaVuSans", "/ToUnicode", "/Subtype /Image", "20000101000000Z"})
    EXPECT_NE(page.find(part), std::string::npos) << part;
  size_t box = page.find("/MediaBox [ 0 0 ");
  ASSERT_NE(box, std::string::npos);
  EXPECT_NEAR(std::atof(page.c_str() + box + 16), 85 / 25.4 * 72, 0.01);
}

TEST(Figure, BytesDoNotDependOnOrderOrLocale) {
  TemporaryFolder folder;
  const std::string all =
      R"(name = "x", shot = "still", title = "Ranges – of all", note = "A note.", letters = true, caption = "{rmse} {arm}",
    columns = { { arm = "plain" }, { arm = "truth" } },
    rows = { { label = "colour", arrows = { { on = "ball", text = "ball", color = "green" } },
               insets = { { crop = { 8, 4, 10, 6 }, zoom = 2, at = "bottom left" } } },
             { label = "depth", view = "depth" }, { label = "speed", view = "velocity", shrink = 2 },
             { label = "arrows", view = "half.speed", kind = "arrows", zoom = 2 },
             { label = "off", against = "truth", gain = 2, ranges = { { at = { 20, 12 }, samples = 4, displacement = true } } } })";
  Json data = dataOf(all);
  std::vector<Path> first = writeFigure(data, findTaken, "truth", folder.path() / "first");
  writeFigure(dataOf(R"(name = "other", shot = "still", arm = "truth", title = "Änderung")"), findTaken, "truth",
              folder.path());
  const char* zone = std::getenv("TZ");
  std::string zone_before = zone ? zone : "";
  ::setenv("TZ", "Asia/Kathmandu", 1);
  ::tzset();
  std::string locale = std::setlocale(LC_ALL, nullptr);
  bool changed = false;  // true if the machine has one of these locales
  for (const char* name : {"C.utf8", "ar_EG", "de_DE", "de_DE.utf8"})
    changed = std::setlocale(LC_ALL, name) != nullptr || changed;
  EXPECT_TRUE(changed);
  std::vector<Path> second = writeFigure(data, findTaken, "truth", folder.path() / "second");
  std::setlocale(LC_ALL, locale.c_str());
  if (zone) ::setenv("TZ", zone_before.c_str(), 1);
  else ::unsetenv("TZ");
  ::tzset();
  for (size_t i = 0; i < 2; ++i) EXPECT_TRUE(contentOf(first[i]) == contentOf(second[i])) << first[i];
  // The page is a picture of the same figure.
  Image pixels = image::readPng(first[0]);
  EXPECT_GT(pixels.width, 2 * kWidth);
}

// A figure drawn at twice the size is twice as large in all parts.
TEST(Figure, ScalesWithTheCapture) {
  Json data = dataOf(
      R"(name = "x", shot = "still", arm = "plain", crop = { 16, 8, 16, 8 }, boxes = { { area = { 20, 10, 4, 4 }, width = 2 } })");
  Layout layout(layoutOf(figureFrom(data), findTaken, "truth"));
  data["size"] = {32, 18};  // the file's own
  data["drawn"] = {64, 36};
  data["cells"][0]["crop"] = {8, 4, 8, 4};
  data["cells"][0]["boxes"][0]["area"] = {10, 5, 2, 2};
  Layout twice(layoutOf(figureFrom(data), findTaken, "truth"));
  Rectangle one = layout.picture(0, 0), two = twice.picture(0, 0);
  EXPECT_EQ(one.width, two.width) << "the crop has the same pixels";
  EXPECT_EQ(two.x, 2 * one.x) << "margins twice as wide";
  Image figure = pixelsOf(twice);
  EXPECT_EQ(levelsApart(colourAt(figure, two.x + 4, two.y + 2), kYellow), 0);
  EXPECT_EQ(levelsApart(colourAt(figure, two.x + 7, two.y + 5), kYellow), 0);
}

// `cell_width` sets the width of cells for any capture size; marks and crops keep their places.
TEST(Figure, CellWidthDoesNotDependOnTheCapture) {
  Json data = dataOf(R"(name = "x", shot = "still", arm = "plain", cell_width = 100, border = 1, rows = {
    { boxes = { { area = { 20, 10, 4, 4 }, color = "#0000ff", width = 1 } } }, { crop = { 8, 4, 24, 12 } } })");
  Layout layout(layoutOf(figureFrom(data), findTaken, "truth"));
  EXPECT_EQ(layout.picture(0, 0).width, kWidth) << "twice the width would exceed cell_width";
  EXPECT_EQ(layout.picture(1, 0).width, 4 * 24);
  Image figure = pixelsOf(layout);
  Rectangle whole = layout.picture(0, 0), crop = layout.picture(1, 0);
  EXPECT_EQ(levelsApart(colourAt(figure, whole.x + 20, whole.y + 10), {0, 0, 1}), 0);
  EXPECT_EQ(levelsApart(colourAt(figure, crop.x + 4 * 5, crop.y + 4 * 2), shownAt(colorOf("plain"), 13, 6)), 0);
  data["cell_width"] = 32;
  data["size"] = {32, 18}, data["drawn"] = {64, 36};
  data["cells"][0]["boxes"][0]["area"] = {10, 5, 2, 2}, data["cells"][1]["crop"] = {4, 2, 12, 6};
  Layout half(layoutOf(figureFrom(data), findTaken, "truth"));
  EXPECT_EQ(half.picture(0, 0).width, 32);
  EXPECT_EQ(half.picture(0, 0).x, crop.x) << "margins keep their width";
  EXPECT_EQ(half.picture(1, 0).width, 24);
  figure = pixelsOf(half);
  EXPECT_EQ(levelsApart(colourAt(figure, half.picture(0, 0).x + 10, half.picture(0, 0).y + 5), {0, 0, 1}), 0);
}

// Truth's inner blur spans x 20 to 29, y 0 to 17: a window of its width has one place, and the middle row has the most
// pixels.
TEST(Figure, CropHasTheMostPixelsOfARegion) {
  Layout layout = layoutOf(R"(name = "x", shot = "still", arm = "plain", zoom = 2, rows = {
    { crop = { "inner", 10, 18 } }, { boxes = { { area = { "inner", 10, 18 }, color = "#0000ff", width = 1 } } } })");
  Image figure = pixelsOf(layout);
  Rectangle crop = layout.picture(0, 0), whole = layout.picture(1, 0);
  EXPECT_EQ(crop.width, 20);
  EXPECT_EQ(levelsApart(colourAt(figure, crop.x, crop.y), shownAt(colorOf("plain"), 20, 0)), 0);
  EXPECT_EQ(levelsApart(colourAt(figure, whole.x + 40, whole.y + 20), {0, 0, 1}), 0);
  EXPECT_EQ(levelsApart(colourAt(figure, whole.x + 59, whole.y + 35), {0, 0, 1}), 0);
  expectError("name = 'x', shot = 'still', arm = 'plain', crop = { 'hidden', 4, 4 }", "has no output 'hidden'");
}

// A heading moves its row and all rows below, and repeats the column labels.
TEST(Figure, RowsMayHaveHeadings) {
  auto figure = [](const std::string& heading) {
    return layoutOf(R"(name = "x", shot = "still", columns = { { arm = "plain" }, { arm = "truth" } },
      rows = { { }, { )" +
                    heading + "} }");
  };
  Layout bare = figure(""), headed = figure("title = 'Another', note = 'off by {rmse}, at {exposure}'");
  EXPECT_EQ(headed.picture(0, 1).y, bare.picture(0, 1).y);
  EXPECT_GT(headed.picture(1, 0).y, bare.picture(1, 0).y + 3 * 13) << "title, note, labels";
  EXPECT_EQ(headed.height() - bare.height(), headed.picture(1, 0).y - bare.picture(1, 0).y);
  FigureData data =
      figureFrom(dataOf(R"(name = "x", shot = "still", arm = "plain", rows = { { note = "at {exposure}" } })"));
  Problems problems;
  EXPECT_EQ(blockOf(data, data.cells.at(0), findTaken, "truth", 0, problems).above, "at 0.5");
}

TEST(Figure, MistakesAreReportedTogetherAtTheirLines) {
  const std::string cell = "name = 'x', shot = 'still', arm = 'plain',\n";
  expectError(cell + "view = 'dept'",
              "the picture of shot 'still' drawn by 'plain' has no 'dept'; did you mean 'depth'?");
  expectError(cell + "crop = { 60, 0, 8, 8 }", "the crop 8x8 at 60,0 lies outside the picture of 64x36");
  expectError(cell + "insets = {\n { crop = { 0, 30, 8, 8 } } }", "x.lua:14: the crop 8x8 at 0,30 lies outside");
  expectError(cell + "arrows = {\n { to = { 1, 1 } },\n { on = 'bal' } }",
              "x.lua:15: the scene of shot 'still' has no node 'bal'; did you mean 'ball'?");
  expectError(cell + "crop = { 0, 0, 8, 8 },\narrows = { { to = { 9, 1 } } }",
              "an arrow is placed outside the visible part of its cell");
  expectError(cell + "ranges = { { at = { 4, 4 }, along = 'depth' } }",
              "a range follows 'depth', which has no displacements");
  expectError(cell + "caption = '{rmse hidden}'", "has no output 'hidden'");
  expectError(cell + "caption = '{set.sample}'", "the picture of 'plain' has no 'set.sample'");
  try {
    layoutOf(cell + "view = 'x',\narrows = { { on = 'y' } },\ncaption = '{rmse outer}'");
    ADD_FAILURE();
  } catch (const Error& error) {
    for (const char* part : {"no 'x'", "no output 'outer'"})
      EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
  }
}

}  // namespace figure_test
}  // namespace strobe::figure
