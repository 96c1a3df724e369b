// SPDX-License-Identifier: MIT
// Marks over a picture, converted from positions in the capture to positions in the figure.
#pragma once

#include <optional>

#include "base/strict.h"
#include "figure/figure_data.h"
#include "figure/taken.h"

namespace strobe::figure {

// Shape in pixels of the figure, relative to the picture's top left corner.
struct FigureShape {
  enum class Kind { arrow, line, ring, box, disc, words };
  Kind kind = Kind::line;
  dvec2 from = dvec2(0), to = dvec2(0);  // `to`: tip of an arrow, centre of a ring or text, far corner of a box
  double radius = 0, width = 1;
  Colour colour = {1, 1, 1};
  std::string text;
};

// Transform from pixels of the capture to a picture that is cropped and magnified. Positions in a picture are relative
// to the corner of its top left pixel.
class Lens {
 public:
  // `scale`: picture pixels per capture pixel. `area`: crop of the picture. `zoom`: figure pixels per picture pixel.
  Lens(dvec2 scale, const image::Rectangle& area, double zoom) : scale_(scale), area_(area), zoom_(zoom) {}

  dvec2 scale() const { return scale_; }
  double zoom() const { return zoom_; }
  // Centre and top left corner of a capture pixel, in the picture.
  dvec2 centre(dvec2 pixel) const { return (pixel + 0.5) * scale_; }
  dvec2 corner(dvec2 pixel) const { return pixel * scale_; }
  dvec2 inFigure(dvec2 in_picture) const { return (in_picture - dvec2(area_.x, area_.y)) * zoom_; }
  bool shows(dvec2 in_picture) const;

 private:
  dvec2 scale_;
  image::Rectangle area_;
  double zoom_;
};

// Output or "node.port" of a picture. If the picture lacks it, returns null and adds a problem with the nearest name.
const graph::ReadImage* findImage(const Taken& taken, const std::string& name, const Place& place, Problems& problems);

// `size`: factor for line widths. A mark outside of the lens is a mistake, except for a mark on a node of the scene,
// which is then omitted.
std::vector<FigureShape> shapesOf(const std::vector<FigureMark>& marks, const Taken& taken, const Lens& lens,
                                  double size, Problems& problems);

}  // namespace strobe::figure
