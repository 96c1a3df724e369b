// SPDX-License-Identifier: MIT
#include "page/sheet.h"

#include <algorithm>
#include <cmath>

namespace strobe::page {

using image::Colour;
using image::Image;

namespace {

constexpr int kGap = 10, kMargin = 28;
constexpr float kLineHeight = 1.3f, kLeastText = 11;
constexpr Colour kPaper = {1, 1, 1}, kStrong = {0.1f, 0.1f, 0.12f}, kSoft = {0.38f, 0.38f, 0.42f},
                 kEmpty = {0.94f, 0.94f, 0.95f};

Colour colourOf(Ink ink) { return ink == Ink::strong ? kStrong : kSoft; }

int heightOf(float size_px) { return int(size_px * kLineHeight); }

// Without its last character: UTF-8.
void cutLast(std::string& text) {
  while (text.size() > 1 && (text.back() & 0xc0) == 0x80) text.pop_back();
  text.pop_back();
}

void drawFitted(Image& onto, int x, int y, std::string text, float size_px, int width, Colour colour) {
  while (size_px > kLeastText && image::textWidth(text, size_px) > width) size_px -= 1;
  if (image::textWidth(text, size_px) > width) {
    while (!text.empty() && image::textWidth(text + "…", size_px) > width) cutLast(text);
    text += "…";
  }
  image::drawText(onto, x, y, text, size_px, colour);
}

image::Rectangle scaled(const image::Rectangle& area, double scale) {
  return {int(area.x * scale), int(area.y * scale), std::max(3, int(std::ceil(area.width * scale))),
          std::max(3, int(std::ceil(area.height * scale)))};
}

// A title and lines in the middle of a grey cell.
Image noteOf(const std::vector<std::string>& texts, int width, int height) {
  Image cell = image::filled(width, height, kEmpty);
  int y = height / 2 - 66;
  drawFitted(cell, 20, y, texts.front(), 24, width - 40, kStrong);
  y += 8;
  for (size_t i = 1; i < texts.size(); ++i) drawFitted(cell, 20, y += 24, texts[i], 16, width - 40, kSoft);
  return cell;
}

Image cellOf(const SheetCell& cell) {
  Image picture = image::magnify(cell.picture, std::max(1, kSheetColumn / cell.picture.width));
  if (!cell.texts.empty()) return noteOf(cell.texts, picture.width, picture.height);
  double scale = double(picture.width) / (cell.source_width ? cell.source_width : cell.picture.width);
  for (const SheetFrame& frame : cell.frames)
    image::outline(picture, scaled(frame.area, scale), frame.colour, frame.thickness);
  return picture;
}

// A growing picture with a pen that moves down.
class Pen {
 public:
  explicit Pen(int width) : width_(width), pixels_(image::filled(width, 1, kPaper)) { draw(SheetGap{kMargin}); }

  void draw(const SheetGap& gap) { need(y_ += gap.height_px); }

  void draw(const SheetLine& line) {
    need(y_ + heightOf(line.size_px));
    drawFitted(pixels_, kMargin, y_, line.text, line.size_px, width_ - 2 * kMargin, colourOf(line.ink));
    y_ += heightOf(line.size_px);
  }

  void draw(const SheetLabels& labels) {
    need(y_ + heightOf(labels.size_px));
    for (size_t i = 0; i < labels.texts.size(); ++i)
      drawFitted(pixels_, left(i), y_, labels.texts[i], labels.size_px, kSheetColumn, colourOf(labels.ink));
    y_ += heightOf(labels.size_px);
  }

  void draw(const SheetRow& row) {
    int height = 0;
    for (size_t i = 0; i < row.cells.size(); ++i) {
      Image cell = cellOf(row.cells[i]);
      need(y_ + cell.height);
      image::paste(pixels_, cell, left(i), y_);
      height = std::max(height, cell.height);
    }
    y_ += height + kGap;
  }

  Image finished() {
    need(y_ + kMargin);
    return image::crop(pixels_, {0, 0, width_, y_ + kMargin});
  }

 private:
  static int left(size_t column) { return kMargin + int(column) * (kSheetColumn + kGap); }

  void need(int height) {
    if (height <= pixels_.height) return;
    Image larger = image::filled(width_, height + 1000, kPaper);
    std::copy(pixels_.values.begin(), pixels_.values.end(), larger.values.begin());
    pixels_ = std::move(larger);
  }

  int width_, y_ = 0;
  Image pixels_;
};

size_t columnsOf(const Sheet& sheet) {
  size_t most = 1;
  for (const Sheet::Part& part : sheet.parts)
    if (const auto* row = std::get_if<SheetRow>(&part)) most = std::max(most, row->cells.size());
  return most;
}

}  // namespace

Image imageOf(const Sheet& sheet) {
  Pen pen(2 * kMargin + int(columnsOf(sheet)) * (kSheetColumn + kGap) - kGap);
  for (const Sheet::Part& part : sheet.parts) std::visit([&](const auto& one) { pen.draw(one); }, part);
  return pen.finished();
}

}  // namespace strobe::page
