// SPDX-License-Identifier: MIT
// One cell of a figure before it has a place among the others: its picture cut out and magnified, what is drawn over
// it, its insets, what its colours mean, its caption.
#pragma once

#include "figure/marks.h"
#include "lab/views.h"

namespace strobe::figure {

struct Panel {
  image::Image display;
  std::vector<Shape> shapes;
  std::optional<Colour> frame;
  std::string at;  // of an inset: a corner, or below
};

struct Block {
  int row = 0, column = 0;
  Panel main;
  std::vector<Panel> insets;
  lab::Legend legend;
  std::string caption;
  std::string above;        // the note above its row, where it is the first in it
  std::string attribution;  // of the scene
  double fps = 0;           // of the shot
};

// The cell, at `step` unless it names one. Mistakes (no such image, node or region, a crop outside) are added to
// `problems`, and the block is then not whole.
Block blockOf(const FigureData& figure, const Cell& cell, const FindTaken& find, const std::string& truth_arm, int step,
              Problems& problems);

}  // namespace strobe::figure
