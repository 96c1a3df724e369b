// SPDX-License-Identifier: MIT
// What figures are drawn on: the same calls give pixels, or a page of a PDF file with text as text and lines as lines.
// The result depends on nothing but the calls and the font file (image::fontFile): no date, locale or font settings.
// Lengths and positions in pixels of the figure, x right, y down; colours are display values (sRGB-encoded).
#pragma once

#include <memory>
#include <string>

#include "image/draw.h"
#include "math/geometry.h"

typedef struct _cairo cairo_t;
typedef struct _cairo_surface cairo_surface_t;

namespace strobe::figure {

using image::Colour;

// A line of text in DejaVu Sans: its width, and the height that it takes. Throws `Error` without the font.
double textWidth(const std::string& text, double size_px);
double lineHeight(double size_px);

class Canvas {
 public:
  enum class Kind { pixels, page };
  // White; a page has so many points (1/72 inch) per pixel and a title. Throws `Error` for more than 32767 pixels a
  // side.
  Canvas(Kind kind, int width, int height, double points_per_px = 0.75, const std::string& title = "");

  int width() const { return width_; }
  int height() const { return height_; }

  // A display image of 1 or 3 channels with its top left corner at (x, y), pixel by pixel.
  void picture(const image::Image& display, int x, int y);

  void fill(const image::Rectangle& area, const Colour& colour, double alpha = 1);
  // Just inside of `area`.
  void frame(const image::Rectangle& area, int thickness, const Colour& colour);

  // These have a thin dark border, so that they are seen on any picture. An arrow has its tip at `to`.
  void line(dvec2 from, dvec2 to, double width, const Colour& colour);
  void arrow(dvec2 from, dvec2 to, double width, const Colour& colour);
  void ring(dvec2 centre, double radius, double width, const Colour& colour);
  void disc(dvec2 centre, double radius, const Colour& colour);

  // The top left corner of the line's box is at (x, y); turned, the line runs upwards and its box starts at the bottom
  // left. `size_px` is the size of the letters.
  void text(double x, double y, const std::string& text, double size_px, const Colour& colour);
  void turnedText(double x, double y, const std::string& text, double size_px, const Colour& colour);

  // Until `unclip`, nothing is drawn outside of `area`.
  void clip(const image::Rectangle& area);
  void unclip();

  // The end of drawing; a canvas is good for nothing afterwards. Pixels as a display image, the page as a PDF file.
  image::Image pixels();
  std::string page();

 private:
  struct Destroy {
    void operator()(cairo_t* cairo) const;
    void operator()(cairo_surface_t* surface) const;
  };
  void outlined(double width, const Colour& colour);
  void ink(const Colour& colour, double alpha = 1);
  void check() const;

  Kind kind_;
  int width_, height_;
  std::unique_ptr<std::string> bytes_;  // of the page so far
  std::unique_ptr<cairo_surface_t, Destroy> surface_;
  std::unique_ptr<cairo_t, Destroy> cairo_;
};

}  // namespace strobe::figure
