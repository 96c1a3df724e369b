// SPDX-License-Identifier: MIT
#include "oracle/closed_form.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace strobe::oracle {
namespace {

constexpr double kTwoPi = 2 * std::numbers::pi;

// Positions of the edge at the two ends of the window, the smaller one first.
std::array<double, 2> sweep(double edge, double d, Window window) {
  auto [first, last] = std::minmax({edge + d * window.open, edge + d * window.close});
  return {first, last};
}

using Times = std::vector<double>;

// Adds the time when the edge `edge + d*t` crosses x, if it does.
void addCrossing(Times& times, double edge, double d, double x) {
  if (d != 0 && std::isfinite(edge)) times.push_back((x - edge) / d);
}

// Adds the times when a cell border of a pattern crosses x; some may lie outside the window.
void addCellCrossings(Times& times, double cell, double phase, double d, double x, Window window) {
  if (cell <= 0 || d == 0) return;
  auto [first, last] = std::minmax({x - d * window.open, x - d * window.close});
  for (double k = std::floor((first - phase) / cell); k <= std::ceil((last - phase) / cell); ++k)
    times.push_back((x - phase - k * cell) / d);
}

// The ends of the window and the given times inside it, sorted.
Times cut(Times times, Window window) {
  std::erase_if(times, [&](double t) { return !(t > window.open && t < window.close); });
  times.push_back(window.open);
  times.push_back(window.close);
  std::sort(times.begin(), times.end());
  return times;
}

// The exact exposure of a step function of time that may change only at `times`.
template <class SeenAtTime>
Exposure integrateSteps(Times times, Window window, const SeenAtTime& seen_at_time) {
  times = cut(std::move(times), window);
  Exposure result;
  double length = window.close - window.open;
  bool first = true;
  double previous = 0;
  for (size_t i = 0; i + 1 < times.size(); ++i) {
    // An interval this short is one moment found twice; its middle may lie on either side.
    double share = (times[i + 1] - times[i]) / length;
    if (share < 1e-12) continue;

    Seen seen = seen_at_time((times[i] + times[i + 1]) / 2);
    result.colour += share * seen.colour;
    if (seen.surface == 0) result.coverage += share;
    double jump = first ? 0 : std::abs(seen.colour - previous);
    if (jump > 0) ++result.changes;
    result.jump = std::max(result.jump, jump);
    result.variation += jump;
    previous = seen.colour;
    first = false;
  }
  return result;
}

// Sign of the polygon's area: 1 if the corners run from +x to +y, else -1.
double orientation(const std::vector<Point>& corners) {
  double sum = 0;
  for (size_t i = 0; i < corners.size(); ++i) {
    const Point& a = corners[i];
    const Point& b = corners[(i + 1) % corners.size()];
    sum += a.x * b.y - b.x * a.y;
  }
  return sum < 0 ? -1 : 1;
}

// A side of a convex polygon: points inside have n.p >= offset.
struct Side {
  Point normal;
  double offset = 0;
};

std::vector<Side> sidesOf(const std::vector<Point>& corners) {
  double sign = orientation(corners);
  std::vector<Side> sides;
  for (size_t i = 0; i < corners.size(); ++i) {
    const Point& a = corners[i];
    const Point& b = corners[(i + 1) % corners.size()];
    Point normal{-sign * (b.y - a.y), sign * (b.x - a.x)};
    sides.push_back({normal, normal.x * a.x + normal.y * a.y});
  }
  return sides;
}

bool inside(const std::vector<Side>& sides, Point p) {
  return std::all_of(sides.begin(), sides.end(),
                     [&](const Side& s) { return s.normal.x * p.x + s.normal.y * p.y >= s.offset; });
}

Point rotated(Point p, Point centre, double angle) {
  double c = std::cos(angle), s = std::sin(angle);
  double x = p.x - centre.x, y = p.y - centre.y;
  return {centre.x + c * x - s * y, centre.y + s * x + c * y};
}

// Edges that may lie within [from, to] during the window, as (position at the raster time, d).
std::vector<std::array<double, 2>> edgesWithin(const Strips& strips, double from, double to, Window window) {
  std::vector<std::array<double, 2>> edges;
  for (const Strip& strip : strips) {
    if (std::isfinite(strip.left)) edges.push_back({strip.left, strip.d});
    if (std::isfinite(strip.right)) edges.push_back({strip.right, strip.d});
    const Pattern& pattern = strip.pattern;
    if (pattern.cell <= 0) continue;
    double first = std::min(from - strip.d * window.open, from - strip.d * window.close);
    double last = std::max(to - strip.d * window.open, to - strip.d * window.close);
    for (double k = std::floor((first - pattern.phase_x) / pattern.cell);
         k <= std::ceil((last - pattern.phase_x) / pattern.cell); ++k)
      edges.push_back({pattern.phase_x + k * pattern.cell, strip.d});
  }
  return edges;
}

// Mean colour and coverage over [from, to] at one time. `edges` holds every place where the colour may change.
Exposure meanOver(const Strips& strips, const std::vector<std::array<double, 2>>& edges, double from, double to,
                  double time) {
  std::vector<double> places{from, to};
  for (auto [edge, d] : edges)
    if (double x = edge + d * time; x > from && x < to) places.push_back(x);
  std::sort(places.begin(), places.end());

  Exposure mean;
  for (size_t i = 0; i + 1 < places.size(); ++i) {
    double share = (places[i + 1] - places[i]) / (to - from);
    Seen seen = seenAt(strips, (places[i] + places[i + 1]) / 2, time);
    mean.colour += share * seen.colour;
    if (seen.surface == 0) mean.coverage += share;
  }
  return mean;
}

}  // namespace

double halfPlaneAtCentre(double edge, double d, Window window, int pixel) {
  double centre = pixel + 0.5;
  auto [first, last] = sweep(edge, d, window);
  if (last == first) return centre < edge ? 1 : 0;
  return std::clamp((last - centre) / (last - first), 0.0, 1.0);
}

double barAtCentre(double left, double right, double d, Window window, int pixel) {
  return halfPlaneAtCentre(right, d, window, pixel) - halfPlaneAtCentre(left, d, window, pixel);
}

double Pattern::at(double x) const {
  if (cell <= 0) return even;
  return static_cast<long long>(std::floor((x - phase_x) / cell)) % 2 == 0 ? even : odd;
}

double Pattern::at(double x, double y) const {
  if (cell <= 0) return even;
  auto column = static_cast<long long>(std::floor((x - phase_x) / cell));
  auto row = static_cast<long long>(std::floor((y - phase_y) / cell));
  return (column + row) % 2 == 0 ? even : odd;
}

Seen seenAt(const Strips& strips, double x, double time) {
  for (size_t i = 0; i < strips.size(); ++i) {
    double at_raster_time = x - strips[i].d * time;
    if (at_raster_time >= strips[i].left && at_raster_time < strips[i].right)
      return {static_cast<int>(i), strips[i].pattern.at(at_raster_time)};
  }
  return {-1, 0};
}

Exposure exposeCentre(const Strips& strips, Window window, int pixel) {
  double centre = pixel + 0.5;
  Times times;
  for (const Strip& strip : strips) {
    addCrossing(times, strip.left, strip.d, centre);
    addCrossing(times, strip.right, strip.d, centre);
    addCellCrossings(times, strip.pattern.cell, strip.pattern.phase_x, strip.d, centre, window);
  }
  return integrateSteps(std::move(times), window, [&](double t) { return seenAt(strips, centre, t); });
}

Exposure exposePixel(const Strips& strips, Window window, int pixel) {
  // The times when an edge enters or leaves the pixel, or two edges meet. Between two such times the mean over the
  // pixel's width is linear in time, so its value in the middle is its mean.
  auto edges = edgesWithin(strips, pixel, pixel + 1, window);
  Times times;
  for (size_t i = 0; i < edges.size(); ++i) {
    addCrossing(times, edges[i][0], edges[i][1], pixel);
    addCrossing(times, edges[i][0], edges[i][1], pixel + 1);
    for (size_t j = 0; j < i; ++j) addCrossing(times, edges[i][0] - edges[j][0], edges[i][1] - edges[j][1], 0);
  }
  times = cut(std::move(times), window);

  Exposure result;
  for (size_t i = 0; i + 1 < times.size(); ++i) {
    double share = (times[i + 1] - times[i]) / (window.close - window.open);
    Exposure mean = meanOver(strips, edges, pixel, pixel + 1, (times[i] + times[i + 1]) / 2);
    result.colour += share * mean.colour;
    result.coverage += share * mean.coverage;
  }
  return result;
}

Seen seenAt(const MovingPolygon& picture, Point at, double time) {
  Point own{at.x - picture.d.x * time, at.y - picture.d.y * time};
  if (inside(sidesOf(picture.corners), own)) return {0, picture.pattern.at(own.x, own.y)};
  return {1, picture.background.at(at.x - picture.background_d.x * time, at.y - picture.background_d.y * time)};
}

Exposure exposeCentre(const MovingPolygon& picture, Window window, int x, int y) {
  Point centre{x + 0.5, y + 0.5};
  Times times;
  for (const Side& side : sidesOf(picture.corners)) {
    double at = side.normal.x * centre.x + side.normal.y * centre.y;
    addCrossing(times, side.offset, side.normal.x * picture.d.x + side.normal.y * picture.d.y, at);
  }
  for (auto [pattern, d] : {std::pair{&picture.pattern, picture.d}, {&picture.background, picture.background_d}}) {
    addCellCrossings(times, pattern->cell, pattern->phase_x, d.x, centre.x, window);
    addCellCrossings(times, pattern->cell, pattern->phase_y, d.y, centre.y, window);
  }
  return integrateSteps(std::move(times), window, [&](double t) { return seenAt(picture, centre, t); });
}

Seen seenAt(const RotatingPolygon& picture, Point at, double time) {
  Point own = rotated(at, picture.centre, -picture.angle * time);
  if (inside(sidesOf(picture.corners), own)) return {0, picture.colour};
  return {1, picture.background.at(at.x, at.y)};
}

Exposure exposeCentre(const RotatingPolygon& picture, Window window, int x, int y) {
  Point centre{x + 0.5, y + 0.5};
  Point arm{centre.x - picture.centre.x, centre.y - picture.centre.y};
  double radius = std::hypot(arm.x, arm.y);
  double phi = std::atan2(arm.y, arm.x);
  Times times;
  // In the polygon's frame the pixel's centre runs on a circle. It crosses a side when radius * cos(phi - angle*t -
  // psi), its distance along the side's normal, equals the side's distance.
  for (const Side& side : sidesOf(picture.corners)) {
    double length = std::hypot(side.normal.x, side.normal.y);
    double psi = std::atan2(side.normal.y, side.normal.x);
    double distance = (side.offset - side.normal.x * picture.centre.x - side.normal.y * picture.centre.y) / length;
    if (picture.angle == 0 || std::abs(distance) >= radius) continue;
    double half = std::acos(distance / radius);
    double turns = std::ceil(std::abs(picture.angle) / kTwoPi) + 2;
    for (double n = -turns; n <= turns; ++n)
      for (double sign : {-1.0, 1.0}) times.push_back((phi - psi + sign * half + kTwoPi * n) / picture.angle);
  }
  return integrateSteps(std::move(times), window, [&](double t) { return seenAt(picture, centre, t); });
}

}  // namespace strobe::oracle
