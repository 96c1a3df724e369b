// SPDX-License-Identifier: MIT
// Layout of a figure: a grid of cells with labels, captions and legends, a title above, notes and attributions below.
// Computed once, drawn on any canvas.
#pragma once

#include "figure/panel.h"
#include "image/canvas.h"

namespace strobe::figure {

using image::Canvas;
using image::lineHeight;
using image::textWidth;

// Form of captions: wrapped lines, or one line. `one_line` shrinks a long caption, so that all frames of a film have
// the same height.
enum class Captions { wrapped, one_line };

// Pixel positions of all parts of a figure: pictures, labels, captions, legends and attributions. Constant after
// construction.
class Layout {
 public:
  // `blocks`: blocks of the figure's cells, without mistakes. The layout keeps them.
  Layout(const FigureData& figure, std::vector<Block> blocks, Captions captions = Captions::wrapped);
  Layout(const Layout&) = delete;

  int width() const { return width_; }
  int height() const { return height_; }
  // Rectangle of a cell's picture, pixels. Asserts that the cell exists.
  image::Rectangle picture(int row, int column) const;

  void draw(Canvas& canvas) const;

 private:
  struct Placed {
    const Panel* panel;
    image::Rectangle area;  // rectangle of the display image
    int rim;                // width of the border around `area`, pixels
    Colour rim_colour;
    std::string letter;
  };
  struct Line {
    double x, y;
    std::string text;
    double size;
    Colour colour;
    bool turned;
  };
  struct Key {
    image::Legend legend;
    image::Rectangle area;
  };

  int heightOf(const Block& block, int width) const;
  int keyHeight(const image::Legend& legend) const;
  std::vector<std::string> captionLines(const std::string& caption, int width) const;
  image::Rectangle belowOf(const Block& block) const;  // only the size is set
  int outerWidth(const Block& block) const;
  void measureGrid();
  void place(const Block& block, int x, int y);
  void placeInset(const Panel& inset, const image::Rectangle& picture, int& below_x, int below_y);
  void addLine(double x, double y, int width, const std::string& text, double size, const Colour& colour, bool centred);
  int addParagraph(int x, int y, int width, const std::string& text, double size, const Colour& colour);
  void placeColumnLabels(int x, int y);
  void placeRowLabel(size_t row, int x, int y);
  int placeHeading(size_t row, int x, int y, int width);
  void drawPanel(Canvas& canvas, const Placed& placed) const;
  void drawKey(Canvas& canvas, const Key& key) const;
  void drawPlate(Canvas& canvas, const image::Rectangle& within, dvec2 centre, const std::string& text, double size,
                 const Colour& colour) const;

  const FigureData figure_;
  const std::vector<Block> blocks_;
  const Captions captions_;
  double size_ = 1;  // drawn pixels per pixel of the capture's own size
  double text_ = 13;
  int gap_ = 0, rim_ = 0;
  std::vector<int> column_widths_, row_heights_, row_tops_;
  int labels_above_ = 0, labels_beside_ = 0;
  int width_ = 0, height_ = 0;
  std::vector<Placed> placed_;
  std::vector<Line> lines_;
  std::vector<Key> keys_;
};

}  // namespace strobe::figure
