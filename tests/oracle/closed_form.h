// SPDX-License-Identifier: MIT
// Exact exposures, in double precision, of pictures simple enough to integrate by hand. Tests compare every method with
// them; they share no code with the renderer. Derivations: docs/derivations.md.
//
// Conventions: x right, y down; pixel i covers [i, i+1) and has its centre at i + 0.5; displacements are in pixels over
// the exposure; time is in exposures, 0 at the raster time. A surface at position y at the raster time is at y + d*t at
// time t. Intervals are half open, [left, right); this matters only to pixels whose centre lies exactly on an edge.
#pragma once

#include <array>
#include <limits>
#include <vector>

namespace strobe::oracle {

inline constexpr double kInfinity = std::numeric_limits<double>::infinity();

// Times of shutter opening and closing relative to the raster time, open < close.
struct Window {
  double open = -1;
  double close = 0;
};
inline constexpr Window kCloseAnchor{-1, 0};
inline constexpr Window kCentreAnchor{-0.5, 0.5};
inline constexpr Window kOpenAnchor{0, 1};

// --- One edge: share of the exposure while a pixel is covered ---

// Coverage of the pixel's centre by the half-plane x < edge + d*t.
double halfPlaneAtCentre(double edge, double d, Window window, int pixel);

// Coverage of the pixel's centre by the bar [left, right) + d*t.
double barAtCentre(double left, double right, double d, Window window, int pixel);

// --- Colour of one pixel during the exposure ---

// The exposure of one pixel. Its colour is a step function of time, so M midpoint samples of the window are off by at
// most `variation / (2M)`, and jittered samples of M equal strata by at most `variation / M`.
struct Exposure {
  double colour = 0;
  double coverage = 0;   // share of the time when the front surface is visible
  int changes = 0;       // number of colour changes (0 if the mean is over a pixel's width)
  double jump = 0;       // largest change
  double variation = 0;  // sum of all changes
};

// A texture fixed to its surface: two values alternate along x (and along y, as a checker). Cells are `cell` wide; the
// first value fills [phase, phase + cell). A cell of 0 is the constant `even`.
struct Pattern {
  double even = 0;
  double odd = 0;
  double cell = 0;
  double phase_x = 0;
  double phase_y = 0;

  double at(double x) const;
  double at(double x, double y) const;
};

// A surface of a one-dimensional picture: [left, right) at the raster time. Texture coordinates are positions at the
// raster time.
struct Strip {
  double left = -kInfinity;
  double right = kInfinity;
  double d = 0;
  Pattern pattern;
};

// Front to back; the last strip must be unbounded. `Exposure::coverage` is the coverage by the first strip.
using Strips = std::vector<Strip>;

Exposure exposeCentre(const Strips& strips, Window window, int pixel);
Exposure exposePixel(const Strips& strips, Window window, int pixel);

// Surface and colour at any x at one time: the step function that the two functions above integrate.
struct Seen {
  int surface = 0;
  double colour = 0;
};
Seen seenAt(const Strips& strips, double x, double time);

// --- Two dimensions, at pixel centres ---

struct Point {
  double x = 0;
  double y = 0;
};

// A convex polygon that translates by `d` before a background pattern that translates by `background_d`. Corners in
// either order.
struct MovingPolygon {
  std::vector<Point> corners;
  Point d;
  Pattern pattern;
  Point background_d;
  Pattern background;
};
Exposure exposeCentre(const MovingPolygon& picture, Window window, int x, int y);
Seen seenAt(const MovingPolygon& picture, Point at, double time);

// A convex polygon of one colour that turns about `centre` by `angle` radians over the exposure (positive: from +x to
// +y) before a static pattern. A wedge is a triangle with a corner at the centre.
struct RotatingPolygon {
  std::vector<Point> corners;
  Point centre;
  double angle = 0;
  double colour = 1;
  Pattern background;
};
Exposure exposeCentre(const RotatingPolygon& picture, Window window, int x, int y);
Seen seenAt(const RotatingPolygon& picture, Point at, double time);

}  // namespace strobe::oracle
