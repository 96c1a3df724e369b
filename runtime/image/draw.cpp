// SPDX-License-Identifier: MIT
#include "image/draw.h"

#include <algorithm>

#include "base/error.h"

namespace strobe::image {

Rectangle overlap(const Rectangle& a, const Rectangle& b) {
  int x0 = std::max(a.x, b.x), y0 = std::max(a.y, b.y);
  int x1 = std::min(a.x + a.width, b.x + b.width), y1 = std::min(a.y + a.height, b.y + b.height);
  return {x0, y0, std::max(x1 - x0, 0), std::max(y1 - y0, 0)};
}

// Part of a rectangle in an image.
static Rectangle inside(const Image& image, const Rectangle& area) {
  return overlap(area, {0, 0, image.width, image.height});
}

Image filled(int width, int height, const Colour& colour) {
  Image image(width, height, 3);
  fill(image, {0, 0, width, height}, colour);
  return image;
}

Image crop(const Image& image, Rectangle area) {
  Rectangle part = inside(image, area);
  if (part.width == 0 || part.height == 0)
    throw Error(fmt::format("the crop {}x{} at {},{} is outside of the image of {}x{}", area.width, area.height, area.x,
                            area.y, image.width, image.height));
  Image result(part.width, part.height, image.channels);
  for (int y = 0; y < part.height; ++y)
    std::copy_n(image.pixel(part.x, part.y + y), size_t(part.width) * image.channels, result.pixel(0, y));
  return result;
}

Image magnify(const Image& image, int factor) {
  STROBE_ASSERT(factor >= 1, "{}", factor);
  Image result(image.width * factor, image.height * factor, image.channels);
  for (int y = 0; y < result.height; ++y)
    for (int x = 0; x < result.width; ++x)
      std::copy_n(image.pixel(x / factor, y / factor), image.channels, result.pixel(x, y));
  return result;
}

Image shrunk(const Image& linear, int width, int height) {
  width = std::clamp(width, 1, linear.width);
  height = std::clamp(height, 1, linear.height);
  if (width == linear.width && height == linear.height) return linear;
  Image result(width, height, linear.channels);
  for (int y = 0; y < height; ++y) {
    int top = int(int64_t(y) * linear.height / height),
        bottom = std::max(top + 1, int(int64_t(y + 1) * linear.height / height));
    for (int x = 0; x < width; ++x) {
      int left = int(int64_t(x) * linear.width / width),
          right = std::max(left + 1, int(int64_t(x + 1) * linear.width / width));
      for (int c = 0; c < linear.channels; ++c) {
        double sum = 0;
        for (int sy = top; sy < bottom; ++sy)
          for (int sx = left; sx < right; ++sx) sum += linear.at(sx, sy, c);
        result.at(x, y, c) = float(sum / ((bottom - top) * (right - left)));
      }
    }
  }
  return result;
}

void fill(Image& onto, Rectangle area, const Colour& colour) {
  STROBE_ASSERT(onto.channels == 3, "{} channels", onto.channels);
  Rectangle part = inside(onto, area);
  for (int y = part.y; y < part.y + part.height; ++y)
    for (int x = part.x; x < part.x + part.width; ++x) std::copy_n(colour.begin(), 3, onto.pixel(x, y));
}

void paste(Image& onto, const Image& what, int x, int y) {
  STROBE_ASSERT(onto.channels == 3 && (what.channels == 1 || what.channels >= 3), "{} onto {} channels", what.channels,
                onto.channels);
  Rectangle part = inside(onto, {x, y, what.width, what.height});
  for (int py = part.y; py < part.y + part.height; ++py)
    for (int px = part.x; px < part.x + part.width; ++px)
      for (int c = 0; c < 3; ++c) onto.at(px, py, c) = what.at(px - x, py - y, what.channels == 1 ? 0 : c);
}

}  // namespace strobe::image
