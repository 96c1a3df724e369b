// SPDX-License-Identifier: MIT
#include "image/draw.h"

#include <algorithm>
#include <cmath>

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

Rectangle scaledCrop(const Rectangle& crop, double scale_x, double scale_y, const Image& picture) {
  auto scaled = [](int value, double scale, int most) { return std::clamp(int(std::lround(value * scale)), 1, most); };
  int width = scaled(crop.width, scale_x, picture.width), height = scaled(crop.height, scale_y, picture.height);
  return {std::clamp(int(crop.x * scale_x), 0, picture.width - width),
          std::clamp(int(crop.y * scale_y), 0, picture.height - height), width, height};
}

namespace {

// Summed-area table of a map.
class AreaSums {
 public:
  template <class Value>
  AreaSums(const Image& map, const Value& value_of)
      : row_(size_t(map.width) + 1), sums_(row_ * (size_t(map.height) + 1), 0) {
    for (int y = 0; y < map.height; ++y)
      for (int x = 0; x < map.width; ++x)
        at(x + 1, y + 1) = value_of(map.at(x, y, 0)) + at(x, y + 1) + at(x + 1, y) - at(x, y);
  }

  double over(const Rectangle& area) {
    int right = area.x + area.width, bottom = area.y + area.height;
    return at(right, bottom) - at(area.x, bottom) - at(right, area.y) + at(area.x, area.y);
  }

 private:
  double& at(int x, int y) { return sums_[size_t(y) * row_ + size_t(x)]; }

  const size_t row_;
  std::vector<double> sums_;
};

// Calls `visit` with each window of this size in the map, row by row.
template <class Visit>
void forWindows(const Image& map, int width, int height, const Visit& visit) {
  for (int y = 0; y + height <= map.height; ++y)
    for (int x = 0; x + width <= map.width; ++x) visit(Rectangle{x, y, width, height});
}

}  // namespace

Rectangle densestCrop(const Image& mask, int width, int height) {
  AreaSums sums(mask, [](float value) { return value >= 0.5f ? 1.0 : 0.0; });
  Rectangle best{(mask.width - width) / 2, (mask.height - height) / 2, width, height};
  double most = 0, least = 0;
  const int qx = width / 4, qy = height / 4;
  forWindows(mask, width, height, [&](const Rectangle& window) {
    double all = sums.over(window);
    // Among equal windows, choose the window with the most mask pixels in its middle.
    double middle = sums.over({window.x + qx, window.y + qy, width - 2 * qx, height - 2 * qy});
    if (all < most || (all == most && middle <= least)) return;
    most = all, least = middle, best = window;
  });
  return best;
}

Rectangle worstWindow(const Image& map, int width, int height) {
  width = std::clamp(width, 1, map.width), height = std::clamp(height, 1, map.height);
  AreaSums sums(map, [](float value) { return double(value); });
  Rectangle worst{0, 0, width, height};
  double most = -1;
  forWindows(map, width, height, [&](const Rectangle& window) {
    if (double all = sums.over(window); all > most + 1e-9) most = all, worst = window;
  });
  return worst;
}

}  // namespace strobe::image
