// SPDX-License-Identifier: MIT
#include "image/legend.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "image/false_colour.h"

namespace strobe::image {

namespace {

constexpr Colour kInk = {0.96f, 0.96f, 0.97f};
constexpr Colour kSoftInk = {0.72f, 0.73f, 0.76f};
constexpr Colour kBorder = {0.03f, 0.03f, 0.04f};

// True if the font is installed. Legends without the font have no text.
bool hasFont() {
  static const bool has = [] {
    try {
      return textWidth("0", 12) > 0;
    } catch (const Error&) {
      return false;
    }
  }();
  return has;
}

int widthOf(const std::string& text, float size) { return hasFont() ? textWidth(text, size) : 0; }

void write(Image& onto, int x, int y, const std::string& text, float size, const Colour& colour) {
  if (hasFont() && !text.empty()) drawText(onto, x, y, text, size, colour);
}

// Distance to a rectangle with rounded corners, negative inside.
float distanceToPlate(vec2 p, const Rectangle& area, float round) {
  vec2 half(area.width * 0.5f - round, area.height * 0.5f - round);
  vec2 centre(area.x + area.width * 0.5f, area.y + area.height * 0.5f);
  vec2 q = glm::abs(p - centre) - half;
  return glm::length(glm::max(q, vec2(0))) + std::min(std::max(q.x, q.y), 0.0f) - round;
}

void drawPlate(Image& onto, const Rectangle& area) {
  float round = std::min(6.0f, std::min(area.width, area.height) * 0.25f);
  for (int y = area.y; y < area.y + area.height; ++y)
    for (int x = area.x; x < area.x + area.width; ++x)
      blend(onto, x, y, kBorder,
            0.72f * std::clamp(0.5f - distanceToPlate({x + 0.5f, y + 0.5f}, area, round), 0.0f, 1.0f));
}

int padOf(float text) { return int(std::lround(text * 0.55f)); }

// Draws a plate for content of this size in the lower right corner. Returns the rectangle of the content.
Rectangle cornerPlate(Image& onto, int width, int height, float text) {
  int pad = padOf(text);
  Rectangle plate = {onto.width - width - 3 * pad, onto.height - height - 3 * pad, width + 2 * pad, height + 2 * pad};
  drawPlate(onto, plate);
  return {plate.x + pad, plate.y + pad, width, height};
}

float distanceToSegment(vec2 p, vec2 a, vec2 b) {
  vec2 ab = b - a;
  float length2 = glm::dot(ab, ab);
  float t = length2 > 0 ? std::clamp(glm::dot(p - a, ab) / length2, 0.0f, 1.0f) : 0.0f;
  return glm::length(p - a - t * ab);
}

// Signed distance to a triangle, negative inside. Exact along its sides but not at its corners, which is sufficient for
// antialiasing.
float distanceToTriangle(vec2 p, vec2 a, vec2 b, vec2 c) {
  auto side = [&p](vec2 from, vec2 to) {
    vec2 along = glm::normalize(to - from);
    return (p.y - from.y) * along.x - (p.x - from.x) * along.y;
  };
  return std::max({side(a, b), side(b, c), side(c, a)});
}

}  // namespace

float legendTextSize(const Image& onto) {
  if (onto.width < 200 || onto.height < 120) return 0;
  return std::clamp(std::min(onto.height / 34.0f, onto.width / 56.0f), 10.0f, 30.0f);
}

double niceCeiling(double value) {
  if (!(value > 0) || !std::isfinite(value)) return 1;
  double power = std::pow(10.0, std::floor(std::log10(value)));
  for (double factor : {1.0, 2.0, 5.0})
    if (value <= factor * power * (1 + 1e-9)) return factor * power;
  return 10 * power;
}

void drawBar(Image& onto, const std::function<Colour(float)>& colourAt, const std::string& left,
             const std::string& middle, const std::string& right) {
  float text = legendTextSize(onto);
  if (text == 0) return;
  int words = widthOf(left, text) + widthOf(middle, text) + widthOf(right, text) + int(2.5f * text);
  int width = std::max(onto.width / 4, words), bar = int(text), line = int(text * 1.25f);
  Rectangle area = cornerPlate(onto, width, bar + line, text);
  for (int x = 0; x < width; ++x) fill(onto, {area.x + x, area.y, 1, bar}, colourAt((x + 0.5f) / width));
  int y = area.y + bar + int(text * 0.2f);
  write(onto, area.x, y, left, text, kInk);
  write(onto, area.x + (width - widthOf(middle, text)) / 2, y, middle, text, kSoftInk);
  write(onto, area.x + width - widthOf(right, text), y, right, text, kInk);
}

Wheel wheelOf(const Image& onto) {
  float text = legendTextSize(onto);
  if (text == 0) return {};
  int radius = int(text * 2.4f), pad = padOf(text);
  return {onto.width - 2 * pad - radius, onto.height - 2 * pad - radius - int(text * 1.35f), radius};
}

void drawWheel(Image& onto, double full_px) {
  Wheel wheel = wheelOf(onto);
  if (wheel.radius == 0) return;
  float text = legendTextSize(onto);
  int r = wheel.radius, pad = padOf(text), below = int(text * 1.35f);
  drawPlate(onto, {wheel.x - r - pad, wheel.y - r - pad, 2 * (r + pad), 2 * (r + pad) + below});
  Image vectors(2 * r + 1, 2 * r + 1, 2);
  for (int y = -r; y <= r; ++y)
    for (int x = -r; x <= r; ++x) {
      vectors.at(x + r, y + r, 0) = float(x * full_px / r);
      vectors.at(x + r, y + r, 1) = float(y * full_px / r);
    }
  Image colours = velocityColours(vectors, float(full_px));
  for (int y = -r; y <= r; ++y)
    for (int x = -r; x <= r; ++x) {
      const float* colour = colours.pixel(x + r, y + r);
      blend(onto, wheel.x + x, wheel.y + y, {colour[0], colour[1], colour[2]},
            r + 0.5f - std::hypot(float(x), float(y)));
    }
  std::string label = fmt::format("{:g} px", full_px);
  write(onto, wheel.x - widthOf(label, text) / 2, wheel.y + r + int(text * 0.35f), label, text, kInk);
}

void drawCaption(Image& onto, const std::string& words) {
  float text = legendTextSize(onto);
  if (text == 0 || !hasFont()) return;
  Rectangle area = cornerPlate(onto, widthOf(words, text), int(text), text);
  write(onto, area.x, area.y, words, text, kInk);
}

void drawArrow(Image& onto, vec2 from, vec2 to, float thickness, const Colour& colour) {
  float length = glm::length(to - from);
  if (!(length > 0) || !std::isfinite(length)) return;
  vec2 along = (to - from) / length, across(-along.y, along.x);
  float head = std::min(thickness * 3.6f, length);
  vec2 neck = to - along * head, a = neck + across * head * 0.5f, b = neck - across * head * 0.5f;
  float border = std::max(1.0f, thickness * 0.55f), reach = std::max(head, thickness) + border + 1;
  int left = int(std::max(0.0f, std::min(from.x, to.x) - reach)),
      top = int(std::max(0.0f, std::min(from.y, to.y) - reach));
  int right = int(std::min(float(onto.width), std::max(from.x, to.x) + reach));
  int bottom = int(std::min(float(onto.height), std::max(from.y, to.y) + reach));
  for (int y = top; y < bottom; ++y)
    for (int x = left; x < right; ++x) {
      vec2 p(x + 0.5f, y + 0.5f);
      float distance = std::min(distanceToSegment(p, from, neck) - thickness * 0.5f, distanceToTriangle(p, a, to, b));
      blend(onto, x, y, kBorder, 0.8f * std::clamp(border + 0.5f - distance, 0.0f, 1.0f));
      blend(onto, x, y, colour, std::clamp(0.5f - distance, 0.0f, 1.0f));
    }
}

}  // namespace strobe::image
