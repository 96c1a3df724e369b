// SPDX-License-Identifier: MIT
#include "image/draw.h"

#include <algorithm>

#include "base/error.h"

namespace strobe::image {

static Rectangle cutTo(const Image& image, Rectangle area) {
  int left = std::clamp(area.x, 0, image.width), right = std::clamp(area.x + area.width, left, image.width);
  int top = std::clamp(area.y, 0, image.height), bottom = std::clamp(area.y + area.height, top, image.height);
  return {left, top, right - left, bottom - top};
}

Image filled(int width, int height, const Colour& colour) {
  Image image(width, height, 3);
  fill(image, {0, 0, width, height}, colour);
  return image;
}

Image crop(const Image& image, Rectangle area) {
  Rectangle inside = cutTo(image, area);
  if (inside.width == 0 || inside.height == 0)
    throw Error(fmt::format("the crop {}x{} at {},{} is outside of the image of {}x{}", area.width, area.height, area.x,
                            area.y, image.width, image.height));
  Image result(inside.width, inside.height, image.channels);
  for (int y = 0; y < inside.height; ++y)
    std::copy_n(image.pixel(inside.x, inside.y + y), size_t(inside.width) * image.channels, result.pixel(0, y));
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
  Rectangle inside = cutTo(onto, area);
  for (int y = inside.y; y < inside.y + inside.height; ++y)
    for (int x = inside.x; x < inside.x + inside.width; ++x) std::copy_n(colour.begin(), 3, onto.pixel(x, y));
}

void paste(Image& onto, const Image& what, int x, int y) {
  STROBE_ASSERT(onto.channels == 3 && (what.channels == 1 || what.channels >= 3), "{} onto {} channels", what.channels,
                onto.channels);
  Rectangle inside = cutTo(onto, {x, y, what.width, what.height});
  for (int py = inside.y; py < inside.y + inside.height; ++py)
    for (int px = inside.x; px < inside.x + inside.width; ++px)
      for (int c = 0; c < 3; ++c) onto.at(px, py, c) = what.at(px - x, py - y, what.channels == 1 ? 0 : c);
}

}  // namespace strobe::image
