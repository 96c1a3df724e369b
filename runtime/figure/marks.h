// SPDX-License-Identifier: MIT
// What is drawn over a picture, from where a figure places it in the capture to where it is in the figure.
#pragma once

#include <optional>

#include "base/strict.h"
#include "figure/figure_data.h"
#include "figure/taken.h"

namespace strobe::figure {

// In pixels of the figure from the picture's top left corner.
struct Shape {
  enum class Kind { arrow, line, ring, box, disc, words };
  Kind kind = Kind::line;
  dvec2 from = dvec2(0), to = dvec2(0);  // an arrow's tip, a ring's or a text's centre, a box' far corner: `to`
  double radius = 0, width = 1;
  Colour colour = {1, 1, 1};
  std::string text;
};

// Where pixels of the capture are in a picture that is cut out and magnified. Positions in a picture count from the
// corner of its top left pixel.
class Lens {
 public:
  // `scale`: pixels of the picture for one of the capture; `area`: what is cut out of the picture; `zoom`: pixels of
  // the figure for one of the picture.
  Lens(dvec2 scale, const image::Rectangle& area, double zoom) : scale_(scale), area_(area), zoom_(zoom) {}

  dvec2 scale() const { return scale_; }
  double zoom() const { return zoom_; }
  // The centre of a pixel of the capture; its top left corner.
  dvec2 centre(dvec2 pixel) const { return (pixel + 0.5) * scale_; }
  dvec2 corner(dvec2 pixel) const { return pixel * scale_; }
  dvec2 inFigure(dvec2 in_picture) const { return (in_picture - dvec2(area_.x, area_.y)) * zoom_; }
  bool shows(dvec2 in_picture) const;

 private:
  dvec2 scale_;
  image::Rectangle area_;
  double zoom_;
};

// An output or a "node.port"; null, and a line in `problems` with the nearest name, where the picture has none.
const graph::ReadImage* findImage(const Taken& taken, const std::string& name, const Place& place, Problems& problems);

// `size`: what widths of lines are multiplied by. A mark outside of what the lens shows is a mistake, but for one on a
// node of the scene, which is then left out.
std::vector<Shape> shapesOf(const Marks& marks, const Taken& taken, const Lens& lens, double size, Problems& problems);

}  // namespace strobe::figure
