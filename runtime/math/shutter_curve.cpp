// SPDX-License-Identifier: MIT
#include "math/shutter_curve.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "base/numbers.h"

namespace strobe {

using Points = std::vector<ShutterCurve::Point>;

// Area under the curve between two points.
static double between(const ShutterCurve::Point& a, const ShutterCurve::Point& b) {
  return (b.time - a.time) * 0.5 * (a.weight + b.weight);
}

// ---- texts

[[noreturn]] static void refuse(const std::string& text, const std::string& why) {
  throw Error(fmt::format("--shutter-curve '{}': {}", text, why), {}, 2);
}

static std::vector<std::string> split(const std::string& text, char between) {
  std::vector<std::string> parts(1);
  for (char c : text) {
    if (c == between) parts.emplace_back();
    else parts.back() += c;
  }
  return parts;
}

static double numberIn(const std::string& text, const std::string& part) {
  if (std::optional<double> number = finiteNumber(part)) return *number;
  refuse(text, fmt::format("'{}' is not a number", part));
}

// Rounds a time to a multiple of 2^-40, so that the distance from either end is exact.
static double rounded(double time) { return std::nearbyint(std::ldexp(time, 40)) / std::ldexp(1, 40); }

// The numbers after the colon of a name; `otherwise` if the text has no colon.
static std::vector<double> argumentsOf(const std::string& text, std::vector<double> otherwise) {
  size_t colon = text.find(':');
  if (colon == std::string::npos) return otherwise;
  std::vector<double> numbers;
  for (const std::string& part : split(text.substr(colon + 1), ',')) numbers.push_back(numberIn(text, part));
  if (numbers.size() != otherwise.size())
    refuse(text, fmt::format("the number of values after ':' must be {}", otherwise.size()));
  return numbers;
}

static Points trapezoid(const std::string& text) {
  std::vector<double> shares = argumentsOf(text, {0.25, 0.25});
  if (shares[0] < 0 || shares[1] < 0 || shares[0] + shares[1] > 1)
    refuse(text, "OPENING and CLOSING must be at least 0, and their sum at most 1 (shares of the exposure)");
  double opened = rounded(shares[0]), closes = std::max(1 - rounded(shares[1]), opened);
  return {{0, 0}, {opened, 1}, {closes, 1}, {1, 0}};
}

static Points gaussian(const std::string& text) {
  constexpr int kSteps = 30;  // on each side
  const double sigma = argumentsOf(text, {1.0 / 6})[0];
  if (!(sigma >= 0.01 && sigma <= 10)) refuse(text, "SIGMA, a share of the exposure, must be from 0.01 to 10");
  const double step = std::floor(std::ldexp(std::min(0.5, 4 * sigma) / kSteps, 40)) / std::ldexp(1, 40);
  Points points = {{0, 0}, {0.5 - kSteps * step, 0}};
  for (int i = -kSteps; i <= kSteps; ++i)
    points.push_back({0.5 + i * step, std::exp(-0.5 * (i * step / sigma) * (i * step / sigma))});
  points.push_back({0.5 + kSteps * step, 0});
  points.push_back({1, 0});
  return points;
}

static Points table(const std::string& text) {
  constexpr size_t kMost = ShutterCurve::kMostKnots - 2;
  const std::vector<std::string> parts = split(text, ',');
  if (parts.size() < 2 || parts.size() > kMost) refuse(text, fmt::format("a table must have 2 to {} weights", kMost));
  const bool has_times = text.find('=') != std::string::npos;
  Points points;
  for (size_t i = 0; i < parts.size(); ++i) {
    size_t equals = parts[i].find('=');
    if (has_times && equals == std::string::npos) refuse(text, fmt::format("'{}' is not TIME=WEIGHT", parts[i]));
    double time = has_times ? numberIn(text, parts[i].substr(0, equals)) : double(i) / double(parts.size() - 1);
    points.push_back({rounded(time), numberIn(text, has_times ? parts[i].substr(equals + 1) : parts[i])});
  }
  return points;
}

static Points pointsOf(const std::string& text) {
  const std::string name = text.substr(0, text.find(':'));
  if (text == "box") return {{0, 1}, {1, 1}};
  if (text == "triangle") return {{0, 0}, {0.5, 1}, {1, 0}};
  if (name == "trapezoid") return trapezoid(text);
  if (name == "gaussian") return gaussian(text);
  if (!text.empty() && text.find_first_not_of("0123456789.,=-+eE") == std::string::npos) return table(text);
  refuse(text,
         "is not one of box, triangle, trapezoid:OPENING,CLOSING, gaussian:SIGMA, weights 0,1,1,0 or TIME=WEIGHT,..." +
             didYouMean(name, {"box", "triangle", "trapezoid", "gaussian"}));
}

ShutterCurve ShutterCurve::from(const std::string& text) {
  const Points points = pointsOf(text);
  if (points.front().time != 0 || points.back().time != 1) refuse(text, "the times must start at 0 and end at 1");
  double most = 0, weight = 0;
  for (size_t i = 0; i < points.size(); ++i) {
    if (points[i].weight < 0) refuse(text, "a weight is below 0");
    if (i > 0 && points[i].time < points[i - 1].time) refuse(text, "the times must not decrease");
    if (i > 0) weight += between(points[i - 1], points[i]);
    most = std::max(most, points[i].weight);
  }
  if (!(weight > 1e-9 * most) || most > 1e30)
    refuse(text, "the area under the curve is close to 0, or a weight is above 1e30");
  return ShutterCurve(points);
}

// ---- the curve

// Time from a knot until the weight `more` has passed.
static double lengthOf(const ShutterCurve::Knot& knot, double more) {
  if (!(more > 0)) return 0;
  double twice_mean = knot.weight + std::sqrt(std::max(knot.weight * knot.weight + 2 * knot.slope * more, 0.0));
  return twice_mean > 0 ? 2 * more / twice_mean : 0;
}

static std::vector<ShutterCurve::Knot> halfOf(const Points& points, double area) {
  std::vector<ShutterCurve::Knot> knots;
  double share = 0;
  for (size_t i = 0; i + 1 < points.size() && share < 0.5; ++i) {
    double length = points[i + 1].time - points[i].time;
    if (length <= 0) continue;
    double weight = points[i].weight / area, next = points[i + 1].weight / area;
    knots.push_back({points[i].time, share, weight, (next - weight) / length});
    share += 0.5 * length * (weight + next);
  }
  const ShutterCurve::Knot& last = knots.back();
  double to_middle = lengthOf(last, 0.5 - last.share);
  knots.push_back({last.distance + to_middle, 0.5, std::max(last.weight + last.slope * to_middle, 0.0), last.slope});
  return knots;
}

ShutterCurve::ShutterCurve(const Points& points) {
  Points back;
  for (auto at = points.rbegin(); at != points.rend(); ++at) back.push_back({1 - at->time, at->weight});
  auto lower = [](const Point& a, const Point& b) { return a.weight < b.weight; };
  const double most = std::max_element(points.begin(), points.end(), lower)->weight;
  double forward_sum = 0, back_sum = 0;
  bool is_box = true;
  for (size_t i = 1; i < points.size(); ++i) {
    forward_sum += between(points[i - 1], points[i]);
    back_sum += between(back[i - 1], back[i]);
    is_box =
        is_box && (points[i].time == points[i - 1].time || (points[i].weight == most && points[i - 1].weight == most));
  }
  const double area = 0.5 * (forward_sum + back_sum);
  if (!is_box) knots_ = {halfOf(points, area), halfOf(back, area)};
}

double ShutterCurve::distanceOf(int end, double share) const {
  const std::vector<Knot>& knots = knotsFrom(end);
  auto passed = [](double value, const Knot& knot) { return value < knot.share; };
  const Knot& knot = *(std::upper_bound(knots.begin() + 1, knots.end(), share, passed) - 1);
  return knot.distance + lengthOf(knot, share - knot.share);
}

double ShutterCurve::timeOf(double share) const {
  if (isBox()) return share;
  double rest = 1 - share;
  if (share < rest) return distanceOf(0, share);
  if (share > rest) return 1 - distanceOf(1, rest);
  return 0.5 * (distanceOf(0, 0.5) + (1 - distanceOf(1, 0.5)));
}

double ShutterCurve::shareBefore(double time) const {
  if (isBox()) return time;
  const double middle = knots_[0].back().distance;
  const int end = time <= middle ? 0 : 1;
  const double distance = end == 0 ? time : 1 - time;
  const std::vector<Knot>& knots = knotsFrom(end);
  auto passed = [](double value, const Knot& knot) { return value < knot.distance; };
  const Knot& knot = *(std::upper_bound(knots.begin() + 1, knots.end(), distance, passed) - 1);
  double more = distance - knot.distance;
  double share = std::min(knot.share + more * (knot.weight + 0.5 * knot.slope * more), 0.5);
  return end == 0 ? share : 1 - share;
}

}  // namespace strobe
