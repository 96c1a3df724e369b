// SPDX-License-Identifier: MIT
#include "image/legend.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "image/canvas.h"
#include "image/false_colour.h"

namespace strobe::image {

namespace {

using LegendKind = Legend::Kind;

constexpr Colour kInk = {0.96f, 0.96f, 0.97f}, kSoftInk = {0.72f, 0.73f, 0.76f}, kPlate = {0.03f, 0.03f, 0.04f};

// Height of a line of text, px. 0 for a picture that is too small for a legend.
double lineIn(const Image& picture) {
  if (picture.width < 200 || picture.height < 120) return 0;
  return std::clamp(std::min(picture.height / 34.0, picture.width / 56.0), 10.0, 30.0);
}

double letters(double line) { return line / lineHeight(1); }

int borderOf(double line) { return int(std::lround(0.55 * line)); }

// Width and height of the bar or wheel of a legend.
std::array<int, 2> colouredSize(const Legend& legend, const Image& picture, double line) {
  if (legend.kind == LegendKind::wheel) return {2 * int(2.4 * line), 2 * int(2.4 * line)};
  double words = 0;
  for (const std::string& text : textsOf(legend)) words += std::ceil(textWidth(text, letters(line)));
  if (legend.kind == LegendKind::words) return {int(words), 0};
  return {std::max(picture.width / 4, int(words) + int(2.5 * line)), int(line)};
}

}  // namespace

double niceCeiling(double value) {
  if (!(value > 0) || !std::isfinite(value)) return 1;
  double power = std::pow(10.0, std::floor(std::log10(value)));
  for (double factor : {1.0, 2.0, 5.0})
    if (value <= factor * power * (1 + 1e-9)) return factor * power;
  return 10 * power;
}

Image barOf(const Legend& legend, int width, int height) {
  Image bar(width, height, 3);
  for (int x = 0; x < width; ++x) {
    float t = (float(x) + 0.5f) / float(width);
    fill(bar, {x, 0, 1, height}, magma(legend.kind == LegendKind::depth ? 1 - 0.9f * t : t));
  }
  return bar;
}

Image wheelOf(int radius) {
  Image vectors(2 * radius + 1, 2 * radius + 1, 2);
  for (int y = -radius; y <= radius; ++y)
    for (int x = -radius; x <= radius; ++x) {
      float* vector = vectors.pixel(x + radius, y + radius);
      vector[0] = float(x), vector[1] = float(y);
    }
  return velocityColours(vectors, float(radius));
}

std::array<std::string, 3> textsOf(const Legend& legend) {
  auto number = [](double value, const char* unit = "") { return fmt::format("{:.3g}{}", value, unit); };
  if (legend.kind == LegendKind::words) return {legend.text, "", ""};
  if (legend.kind == LegendKind::wheel) return {"", fmt::format("{:g} px", legend.high), ""};
  if (legend.kind == LegendKind::bar) return {number(legend.low), legend.text, number(legend.high)};
  return {number(legend.low, " m"), number(std::sqrt(legend.low * legend.high), " m"), number(legend.high, " m")};
}

Rectangle placeOf(const Legend& legend, const Image& picture) {
  const double line = lineIn(picture);
  if (line == 0 || legend.kind == LegendKind::none) return {};
  auto [width, height] = colouredSize(legend, picture, line);
  height += int(legend.kind == LegendKind::words ? line : legend.kind == LegendKind::wheel ? 1.35 * line : 1.25 * line);
  return {picture.width - width - 2 * borderOf(line), picture.height - height - 2 * borderOf(line), width, height};
}

Rectangle drawLegend(Image& onto, const Legend& legend) {
  const Rectangle place = placeOf(legend, onto);
  if (place.width == 0) return {};
  const double line = lineIn(onto), size = letters(line);
  const int border = borderOf(line), height = colouredSize(legend, onto, line)[1];
  const Rectangle plate = {place.x - border, place.y - border, place.width + 2 * border, place.height + 2 * border};
  Canvas canvas(onto);
  canvas.fill(plate, kPlate, 0.72, std::min(6.0, std::min(plate.width, plate.height) / 4.0));
  if (legend.kind == LegendKind::wheel) canvas.picture(wheelOf(place.width / 2), place.x, place.y, true);
  else if (height > 0) canvas.picture(barOf(legend, place.width, height), place.x, place.y);
  double y = place.y + height, at = 0;
  if (height > 0) y += int((legend.kind == LegendKind::wheel ? 0.35 : 0.2) * line);
  for (const std::string& text : textsOf(legend)) {
    double x = place.x + at * (place.width - std::ceil(textWidth(text, size)));
    canvas.text(x, y, text, size, at == 0.5 && legend.kind != LegendKind::wheel ? kSoftInk : kInk);
    at += 0.5;
  }
  onto = canvas.pixels();
  return plate;
}

Image pictureOf(const Legend& legend) {
  Image canvas(728, 442, 3);  // text on a canvas of this size is 13 px high
  const Rectangle plate = drawLegend(canvas, legend);
  return plate.width > 0 ? crop(canvas, plate) : Image();
}

}  // namespace strobe::image
