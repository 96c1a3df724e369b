// SPDX-License-Identifier: MIT
// Canvas for figures, legends and arrows. The same calls draw pixels, or a page of a PDF file with text as text and
// lines as lines. The result depends only on the calls and the font file, not on date, locale or font settings.
// Positions and lengths in pixels of the canvas, x right, y down; colours are display values (sRGB-encoded) of 8 bits.
#pragma once

#include <memory>
#include <string>

#include "base/files.h"
#include "image/draw.h"
#include "math/geometry.h"

typedef struct _cairo cairo_t;                  // NOLINT(bugprone-reserved-identifier): of cairo
typedef struct _cairo_surface cairo_surface_t;  // NOLINT(bugprone-reserved-identifier)

namespace strobe::image {

// File of DejaVu Sans, the font of all drawn text. Throws `Error` with the package to install if the file is missing.
Path fontFile();

// Width and height of a line of text in DejaVu Sans, pixels. Throws `Error` without the font.
double textWidth(const std::string& text, double size_px);
double lineHeight(double size_px);

// Drawing surface for images, lines, arrows and text; the output is an image or one page of a PDF file.
class Canvas {
 public:
  enum class Kind { pixels, page };
  // White canvas. A page has `points_per_px` points (1/72 inch) per pixel, and a title. Throws `Error` if a side has
  // more than 32767 pixels.
  Canvas(Kind kind, int width, int height, double points_per_px = 0.75, const std::string& title = "");
  // Canvas of pixels that begins with a display image.
  explicit Canvas(const Image& display);

  int width() const { return width_; }
  int height() const { return height_; }

  // Draws a display image of 1 or 3 channels with its top left corner at (x, y), pixel by pixel. `round`: draws only
  // the disc in the middle, for an image with an odd number of pixels a side.
  void picture(const Image& display, int x, int y, bool round = false);

  // `radius`: of the corners.
  void fill(const Rectangle& area, const Colour& colour, double alpha = 1, double radius = 0);
  // Draws a frame along the inner border of `area`.
  void frame(const Rectangle& area, int thickness, const Colour& colour);

  // These shapes have a thin dark border, so that they are visible on any picture. The tip of an arrow is at `to`.
  void line(dvec2 from, dvec2 to, double width, const Colour& colour);
  void arrow(dvec2 from, dvec2 to, double width, const Colour& colour);
  void ring(dvec2 centre, double radius, double width, const Colour& colour);
  void disc(dvec2 centre, double radius, const Colour& colour);

  // Draws a line of text with the top left corner of its box at (x, y). Turned text runs upwards, with the bottom left
  // corner of its box at (x, y). `size_px`: size of the letters.
  void text(double x, double y, const std::string& text, double size_px, const Colour& colour);
  void turnedText(double x, double y, const std::string& text, double size_px, const Colour& colour);

  // Limits drawing to `area` until `unclip`.
  void clip(const Rectangle& area);
  void unclip();

  // Ends drawing; the canvas cannot be used afterwards. `pixels` returns a display image, `page` returns a PDF file.
  Image pixels();
  std::string page();

 private:
  struct Destroy {
    void operator()(cairo_t* cairo) const;
    void operator()(cairo_surface_t* surface) const;
  };
  void circle(dvec2 centre, double radius);  // adds a path
  void outlined(double width, const Colour& colour);
  void ink(const Colour& colour, double alpha = 1);
  void check() const;

  Kind kind_;
  int width_, height_;
  std::unique_ptr<std::string> bytes_;  // PDF file so far
  std::unique_ptr<cairo_surface_t, Destroy> surface_;
  std::unique_ptr<cairo_t, Destroy> cairo_;
};

}  // namespace strobe::image
