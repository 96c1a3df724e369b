// SPDX-License-Identifier: MIT
// Exact exposures, in double precision, of pictures simple enough to be integrated by hand. They share no code with the
// renderer: every method is judged against them. Derivations: docs/derivations.md.
//
// Conventions: x right, y down, pixel i covers [i, i+1) and has its centre at i + 0.5; displacements are in pixels over
// the exposure; time is in exposures, 0 at the capture. A surface that is at y at the capture is at y + d*t at time t.
// Intervals are half open, [left, right), which decides only pixels whose centre lies exactly on an edge.
#pragma once

#include <array>
#include <limits>
#include <vector>

namespace strobe::oracle {

inline constexpr double kInfinity = std::numeric_limits<double>::infinity();

// The exposure relative to the capture, open < close.
struct Window {
  double open = -1;
  double close = 0;
};
inline constexpr Window kCloseAnchor{-1, 0};
inline constexpr Window kCentreAnchor{-0.5, 0.5};
inline constexpr Window kOpenAnchor{0, 1};

// --- One edge: the share of the exposure for which a pixel is covered ---

// By the half-plane x < edge + d*t, seen at the pixel's centre.
double halfPlaneAtCentre(double edge, double d, Window window, int pixel);

// By the bar [left, right) + d*t.
double barAtCentre(double left, double right, double d, Window window, int pixel);

// --- What one pixel sees during the exposure ---

// The exposure of one pixel. Its colour is a step function of time, so M midpoint samples of the window are off by at
// most `variation / (2M)`, and jittered samples of M equal strata by at most `variation / M`.
struct Exposure {
  double colour = 0;
  double coverage = 0;   // share of the time the front surface is seen
  int changes = 0;       // times at which the colour changes (always 0 where the mean is over a pixel's width)
  double jump = 0;       // largest of those changes
  double variation = 0;  // their sum
};

// A texture that is fixed to its surface: two values alternating along x (and along y, as a checker), `cell` wide, the
// first one in [phase, phase + cell). A cell of 0 is the constant `even`.
struct Pattern {
  double even = 0;
  double odd = 0;
  double cell = 0;
  double phase_x = 0;
  double phase_y = 0;

  double at(double x) const;
  double at(double x, double y) const;
};

// A surface of a one-dimensional picture: [left, right) at the capture, with its texture in capture coordinates.
struct Strip {
  double left = -kInfinity;
  double right = kInfinity;
  double d = 0;
  Pattern pattern;
};

// Front to back; the last one must be unbounded. Coverage is that of the first.
using Strips = std::vector<Strip>;

Exposure exposeCentre(const Strips& strips, Window window, int pixel);
Exposure exposePixel(const Strips& strips, Window window, int pixel);

// The same at one time, at any x: the step function that the two integrate.
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

// A convex polygon that translates by `d`, then a pattern behind it that translates by its own. Corners in either
// order.
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
// +y) in front of a pattern at rest. A wedge is a triangle with a corner at the centre.
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
