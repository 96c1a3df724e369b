// SPDX-License-Identifier: MIT
#include "page/svg.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/utf8.h"
#include "math/constants.h"
#include "page/markup.h"

namespace strobe::page {

namespace {

// Shape of a mark: corners (0: circle), radius in pixels, rotation in degrees.
struct MarkShape {
  int corners;
  double radius, turn;
};
constexpr MarkShape kShapes[kStyles] = {{0, 4.2, 0},   {4, 5, 45}, {3, 5.4, 0}, {4, 5.2, 0},
                                        {3, 5.4, 180}, {5, 5, 0},  {6, 5, 0},   {3, 5.4, 90}};

std::string titled(const std::string& tip) { return tip.empty() ? "" : "<title>" + escaped(tip) + "</title>"; }

std::string classed(const std::string& classes) { return classes.empty() ? "" : fmt::format(" class=\"{}\"", classes); }

std::string cornersOf(const MarkShape& shape, double x, double y) {
  std::string points;
  for (int i = 0; i < shape.corners; ++i) {
    double angle = (shape.turn + 360.0 * i / shape.corners) * kPi / 180;
    points += fmt::format("{}{:.1f},{:.1f}", i ? " " : "", x + shape.radius * std::sin(angle),
                          y - shape.radius * std::cos(angle));
  }
  return points;
}

}  // namespace

std::string classOf(int style) {
  if (style == kReferenceStyle) return "reference";
  if (style == kUncertaintyStyle) return "uncertainty";
  if (style == kFrontStyle) return "front";
  return fmt::format("s{}", style % kStyles);
}

double estimatedWidth(const std::string& text) { return 7.2 * double(displayWidth(text)); }

Svg::Svg(int width, int height, const std::string& about)
    : text_(fmt::format("<svg class=\"chart\" viewBox=\"0 0 {} {}\" role=\"img\" aria-label=\"{}\">\n", width, height,
                        escaped(about))) {}

void Svg::open(const std::string& classes) { text_ += "<g" + classed(classes) + ">"; }

void Svg::close() { text_ += "</g>\n"; }

void Svg::path(const std::string& classes, const std::string& d, const std::string& tip) {
  if (d.empty()) return;
  std::string start = fmt::format("<path{} d=\"{}\"", classed(classes), d);
  text_ += tip.empty() ? start + "/>" : start + ">" + titled(tip) + "</path>";
}

void Svg::rectangle(const std::string& classes, double x, double y, double width, double height,
                    const std::string& tip) {
  text_ += fmt::format("<rect{} x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\">{}</rect>",
                       classed(classes), x, y, width, height, titled(tip));
}

void Svg::text(const std::string& classes, double x, double y, const std::string& text, Anchor anchor) {
  static const char* const kAnchors[] = {"", " text-anchor=\"middle\"", " text-anchor=\"end\""};
  text_ += fmt::format("<text{} x=\"{:.1f}\" y=\"{:.1f}\"{}>{}</text>", classed(classes), x, y, kAnchors[int(anchor)],
                       escaped(text));
}

void Svg::upwardText(const std::string& classes, double x, double y, const std::string& text) {
  text_ += fmt::format("<text{} transform=\"translate({:.1f} {:.1f}) rotate(-90)\" text-anchor=\"middle\">{}</text>",
                       classed(classes), x, y, escaped(text));
}

void Svg::mark(int style, double x, double y, bool hollow, const std::string& tip) {
  if (style < 0) return;
  const MarkShape& shape = kShapes[(style + style / kStyles) % kStyles];
  std::string classes = classed(hollow ? "hollow" : "");
  if (shape.corners == 0)
    text_ += fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{}\"{}>{}</circle>", x, y, shape.radius, classes,
                         titled(tip));
  else text_ += fmt::format("<polygon points=\"{}\"{}>{}</polygon>", cornersOf(shape, x, y), classes, titled(tip));
}

}  // namespace strobe::page
