// SPDX-License-Identifier: MIT
// A contact sheet as a value, one picture made of many: lines of text, and rows of pictures in columns of the same
// width with labels above them. `imageOf` lays it out and draws it on white.
#pragma once

#include <string>
#include <variant>
#include <vector>

#include "image/draw.h"

namespace strobe::page {

enum class Ink { strong, soft };

// Across the sheet. Text that is too long gets smaller first, then is cut.
struct SheetLine {
  std::string text;
  float size_px = 17;
  Ink ink = Ink::strong;
};

// A line of which each column has its own text.
struct SheetLabels {
  std::vector<std::string> texts;
  float size_px = 17;
  Ink ink = Ink::strong;
};

// A frame in a picture, in pixels of the one that `SheetCell::source_width` is of.
struct SheetFrame {
  image::Rectangle area;
  image::Colour colour;
  int thickness = 2;
};

// A display image (sRGB-encoded values), grown by a whole factor to the width of the column; or, of the same size, text
// in its place.
struct SheetCell {
  image::Image picture;
  std::vector<SheetFrame> frames;
  int source_width = 0;            // 0: as wide as `picture`
  std::vector<std::string> texts;  // the first is a title; where there are any, they stand in place of the picture
};

struct SheetRow {
  std::vector<SheetCell> cells;
};

struct SheetGap {
  int height_px = 0;
};

struct Sheet {
  using Part = std::variant<SheetLine, SheetLabels, SheetRow, SheetGap>;
  std::vector<Part> parts;
};

inline constexpr int kSheetColumn = 480;  // px: pictures should not be wider

// As wide as its longest row needs.
image::Image imageOf(const Sheet& sheet);

}  // namespace strobe::page
