// SPDX-License-Identifier: MIT
// A figure or a film as scripts/strobe/figure.lua leaves it: fields of the figure, of its rows and of its columns are
// those of the cells by then. Positions and lengths in pixels of the capture's own size, x right, y down.
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

// A pixel, or where a node of the scene is seen.
struct Spot {
  dvec2 pixel = dvec2(0);
  std::string node;
};

// Pixels, or where most of a region of truth lies in so many.
struct Area {
  double x = 0, y = 0, width = 0, height = 0;
  std::string region;
};

struct Mark {
  Place place;
  Colour colour = {1.0f, 0.824f, 0.118f};
  double width = 3;  // of lines, in pixels of the figure
  std::string text;
};
struct Arrow : Mark {
  Spot to;
  std::optional<dvec2> from, by;  // the other end, or its distance from the tip
};
struct Circle : Mark {
  Spot at;
  double radius = 0;
};
struct Box : Mark {
  Area area;
};
// Where a filter samples for the pixel: along the displacement of an image at the pixel.
struct Range : Mark {
  dvec2 at = dvec2(0);
  std::string anchor;  // "": the shot's
  std::string along = "velocity";
  int samples = 0;
  bool displacement = false;
};
struct Words : Mark {
  dvec2 at = dvec2(0);
};

struct Marks {
  std::vector<Arrow> arrows;
  std::vector<Box> boxes;
  std::vector<Circle> circles;
  std::vector<Range> ranges;
  std::vector<Words> texts;
};

struct Inset {
  Place place;
  Area crop;
  int zoom = 4;
  std::string at = "bottom right";
  Colour frame = {1.0f, 0.824f, 0.118f};
  Marks marks;
};

// A piece of a caption: a text, or one of what follows with how it is written (style 'f' or 'g', or 0: as it comes).
struct CaptionPart {
  std::string text, measure, region, option, setting, word;
  int digits = 0;
  char style = 0;
};

struct Cell {
  Place place;
  int row = 0, column = 0;  // from 0
  std::string shot, arm;
  std::optional<int> step;
  std::string view = "color", kind = "auto";
  double low = 0, high = 0;
  std::optional<double> stops;
  std::string against, difference = "mean";  // an arm; how the difference from it is shown
  double gain = 1;
  std::optional<Area> crop;
  int zoom = 1, shrink = 1;
  bool key = true;  // says what colours mean
  std::optional<Colour> frame;
  std::vector<CaptionPart> caption;
  std::vector<Inset> insets;
  Marks marks;
};

// What stands above a row; the note is filled in as a caption of its first cell.
struct Heading {
  std::string title;
  std::vector<CaptionPart> note;

  bool empty() const { return title.empty() && note.empty(); }
};

struct FigureData {
  std::string name, title, note;
  Place place;
  std::vector<std::string> rows, columns;  // labels, "" for none
  std::vector<Heading> headings;           // of the rows
  std::vector<Cell> cells;
  bool letters = false, attribution = true;
  double gap = 6, margin = 12, border = 0, text_size = 13;  // pixels at the capture's own size
  double width_mm = 0;                                      // of the page; 0: 96 pixels an inch
  int cell_width = 0;                                       // pixels of the figure; 0: as large as zoom and shrink say
  int width = 0, height = 0;                                // the capture's own size
  int drawn_width = 0, drawn_height = 0;                    // at which it is drawn; 0: at that
  double fps = 0;                                           // of a film; 0: its shot's
  std::string format = "mp4";

  // Pixels as drawn for one of the capture's own size; a shot may have a size of its own, which goes with it.
  dvec2 scale() const;
  // The same for letters, lines and gaps: with a width of cells they keep theirs.
  double size() const { return cell_width > 0 ? 1 : scale().x; }
};

// Throws `Error` for data that is not what it should be, which is no mistake of a user.
FigureData figureFrom(const Json& data);

}  // namespace strobe::figure
