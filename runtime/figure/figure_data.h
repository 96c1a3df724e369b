// SPDX-License-Identifier: MIT
// Figure or film, read from the result of scripts/strobe/figure.lua. The Lua code has already copied the fields of the
// figure, its rows and its columns to the cells. Positions and lengths in pixels of the capture's own size, x right, y
// down.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/error.h"
#include "base/json_fwd.h"
#include "image/draw.h"
#include "math/geometry.h"

namespace strobe::figure {

using image::Colour;

// A pixel, or the projection of a node of the scene.
struct Spot {
  dvec2 pixel = dvec2(0);
  std::string node;
};

// Rectangle, pixels. If `region` is set, the rectangle of this size with most of that region of ground truth.
struct Area {
  double x = 0, y = 0, width = 0, height = 0;
  std::string region;
};

// Mark over a picture or inset. Kinds in the order of drawing.
struct FigureMark {
  enum class Kind { box, circle, range, arrow, text };
  Kind kind = Kind::box;
  Place place;
  Colour colour = {1.0f, 0.824f, 0.118f};
  double width = 3;  // of lines, pixels of the figure
  std::string text;
  Spot at;  // tip of an arrow; centre of a circle or a text; pixel of a range
  // Arrow: position of the other end; offset of the other end from the tip. Without both, the other end is at the upper
  // left.
  std::optional<dvec2> from, by;
  double radius = 0;  // circle: pixels of the capture
  Area area;          // box
  // Range: sample range of a filter, along the displacement of the image `along` at the pixel. `anchor`: "" for the
  // shot's anchor.
  std::string anchor, along = "velocity";
  int samples = 0;
  bool displacement = false;
};

// Magnified part of a picture, drawn in a corner of the picture or below it, with its own marks.
struct Inset {
  Place place;
  Area crop;
  int zoom = 4;
  std::string at = "bottom right";
  Colour frame = {1.0f, 0.824f, 0.118f};
  std::vector<FigureMark> marks;  // in the order of drawing
};

// Part of a caption: a text, or one of the other values with its format. `style`: 'f', 'g', or 0 for the default
// format.
struct CaptionPart {
  std::string text, measure, region, option, setting, word;
  int digits = 0;
  char style = 0;
};

// One cell of a figure's grid: the image of a shot and an arm, its view, difference, crop and magnification, with
// caption, insets and marks.
struct FigureCell {
  Place place;
  int row = 0, column = 0;  // from 0
  std::string shot, arm;
  std::optional<int> step;
  std::string view = "color", kind = "auto";
  double low = 0, high = 0;
  std::optional<double> stops;
  std::string against, difference = "mean";  // arm to compare with; kind of difference
  double gain = 1;
  std::optional<Area> crop;
  int zoom = 1, shrink = 1;
  bool key = true;  // draw the legend
  std::optional<Colour> frame;
  std::vector<CaptionPart> caption;
  std::vector<Inset> insets;
  std::vector<FigureMark> marks;  // in the order of drawing
};

// Text above a row. The note is filled in as a caption of the row's first cell.
struct RowHeading {
  std::string title;
  std::vector<CaptionPart> note;

  bool empty() const { return title.empty() && note.empty(); }
};

// Description of a figure or film: title, labels of rows and columns, cells, and sizes.
struct FigureData {
  std::string name, title, note;
  Place place;
  std::vector<std::string> rows, columns;  // labels; "" for no label
  std::vector<RowHeading> headings;        // headings of the rows
  std::vector<FigureCell> cells;
  bool letters = false, attribution = true;
  double gap = 6, margin = 12, border = 0, text_size = 13;  // pixels at the capture's own size
  double width_mm = 0;                                      // width of the page; 0 for 96 pixels per inch
  int cell_width = 0;                                       // pixels of the figure; 0 for the size by zoom and shrink
  int width = 0, height = 0;                                // the capture's own size
  int drawn_width = 0, drawn_height = 0;                    // size at which it is drawn; 0 for the capture's own size
  double fps = 0;                                           // frame rate of a film; 0 for the shot's
  std::string format = "mp4";

  // Drawn pixels per pixel of the capture's own size. A shot with a size of its own is scaled by the same factor.
  dvec2 scale() const;
  // Scale of letters, lines and gaps: 1 if cells have a fixed width, otherwise as `scale`.
  double size() const { return cell_width > 0 ? 1 : scale().x; }
};

// Throws `Error` for malformed data. Such data is an internal error, not a mistake of a user.
FigureData figureFrom(const Json& data);

}  // namespace strobe::figure
