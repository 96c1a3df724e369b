// SPDX-License-Identifier: MIT
#include "image/crops.h"

#include <algorithm>
#include <cmath>

namespace strobe::image {

Rectangle scaledCrop(const Rectangle& crop, double scale_x, double scale_y, const Image& picture) {
  auto scaled = [](int value, double scale, int most) { return std::clamp(int(std::lround(value * scale)), 1, most); };
  int width = scaled(crop.width, scale_x, picture.width), height = scaled(crop.height, scale_y, picture.height);
  return {std::clamp(int(crop.x * scale_x), 0, picture.width - width),
          std::clamp(int(crop.y * scale_y), 0, picture.height - height), width, height};
}

Rectangle densestCrop(const Image& mask, int width, int height) {
  int w = mask.width, h = mask.height;
  std::vector<int64_t> sums(size_t(w + 1) * size_t(h + 1), 0);
  auto sum = [&](int x, int y) -> int64_t& { return sums[size_t(y) * size_t(w + 1) + size_t(x)]; };
  for (int y = 0; y < h; ++y)
    for (int x = 0; x < w; ++x)
      sum(x + 1, y + 1) = (mask.at(x, y, 0) >= 0.5f) + sum(x, y + 1) + sum(x + 1, y) - sum(x, y);
  Rectangle best{(w - width) / 2, (h - height) / 2, width, height};
  int64_t most = 0;
  double least = 0;
  for (int y = 0; y + height <= h; ++y)
    for (int x = 0; x + width <= w; ++x) {
      int64_t inside = sum(x + width, y + height) - sum(x, y + height) - sum(x + width, y) + sum(x, y);
      // Among equal windows, choose the window with the most mask pixels in its middle.
      int qx = width / 4, qy = height / 4;
      double middle = double(sum(x + width - qx, y + height - qy) - sum(x + qx, y + height - qy) -
                             sum(x + width - qx, y + qy) + sum(x + qx, y + qy));
      if (inside < most || (inside == most && middle <= least)) continue;
      most = inside, least = middle, best = {x, y, width, height};
    }
  return best;
}

Rectangle worstWindow(const Image& map, int width, int height) {
  width = std::clamp(width, 1, map.width), height = std::clamp(height, 1, map.height);
  std::vector<double> sums(size_t(map.width + 1) * size_t(map.height + 1), 0);
  auto sum = [&](int x, int y) -> double& { return sums[size_t(y) * size_t(map.width + 1) + size_t(x)]; };
  for (int y = 0; y < map.height; ++y)
    for (int x = 0; x < map.width; ++x)
      sum(x + 1, y + 1) = double(map.at(x, y, 0)) + sum(x, y + 1) + sum(x + 1, y) - sum(x, y);
  Rectangle worst{0, 0, width, height};
  double most = -1;
  for (int y = 0; y + height <= map.height; ++y)
    for (int x = 0; x + width <= map.width; ++x) {
      double inside = sum(x + width, y + height) - sum(x, y + height) - sum(x + width, y) + sum(x, y);
      if (inside > most + 1e-9) most = inside, worst = {x, y, width, height};
    }
  return worst;
}

}  // namespace strobe::image
