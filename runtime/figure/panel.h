// SPDX-License-Identifier: MIT
// One cell of a figure without its place in the layout: cropped and magnified picture, marks, insets, legend, caption.
#pragma once

#include "figure/marks.h"
#include "lab/views.h"

namespace strobe::figure {

// Display image of a cell or inset, cropped and magnified, with the shapes of its marks and an optional frame.
struct Panel {
  image::Image display;
  std::vector<FigureShape> shapes;
  std::optional<Colour> frame;
  std::string at;  // place of an inset: a corner, or "below"
};

// Content of one cell of a figure: the main picture, its insets, legend, caption and attribution.
struct Block {
  int row = 0, column = 0;
  Panel main;
  std::vector<Panel> insets;
  image::Legend legend;
  std::string caption;
  std::string above;        // note above the row, if this is the row's first cell
  std::string attribution;  // of the scene
};

// Block of a cell. `step`: step of a cell that does not set one. Mistakes (missing image, node or region, crop outside
// of the picture) are added to `problems`; the block is then incomplete.
Block blockOf(const FigureData& figure, const FigureCell& cell, const FindTaken& find, const std::string& truth_arm,
              int step, Problems& problems);

}  // namespace strobe::figure
