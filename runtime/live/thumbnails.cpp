// SPDX-License-Identifier: MIT
#include "live/thumbnails.h"

#include <algorithm>
#include <cmath>

#include "image/draw.h"
#include "image/tone.h"

namespace strobe::live {

static const int kCell = 192;  // pixels of the longer side
static const image::Colour kEmpty = {0.09f, 0.09f, 0.1f};

image::Image thumbnail(const image::Image& linear, int width, double stops) {
  int w = std::min(width, linear.width), h = std::max(1, linear.height * w / std::max(1, linear.width));
  image::Image small(w, h, linear.channels);
  for (int y = 0; y < h; ++y)
    for (int x = 0; x < w; ++x) {
      int left = x * linear.width / w, right = std::max(left + 1, (x + 1) * linear.width / w);
      int top = y * linear.height / h, bottom = std::max(top + 1, (y + 1) * linear.height / h);
      for (int c = 0; c < linear.channels; ++c) {
        double sum = 0;
        for (int v = top; v < bottom; ++v)
          for (int u = left; u < right; ++u) sum += linear.at(u, v, c);
        small.at(x, y, c) = float(sum / ((right - left) * (bottom - top)));
      }
    }
  return image::toneMap(small, {float(stops)});
}

Thumbnails thumbnailsOf(const Sweep& sweep, double stops) {
  const auto& points = sweep.points();
  int columns = int(std::ceil(std::sqrt(double(points.size()))));
  int rows = (int(points.size()) + columns - 1) / columns;
  Thumbnails result{image::filled(columns * kCell, rows * kCell, kEmpty), {}};
  for (size_t i = 0; i < points.size(); ++i) {
    const lab::Shot& shot = points[i].shot;
    int longer = std::max(shot.width, shot.height);
    int width = std::max(1, kCell * shot.width / longer), height = std::max(1, kCell * shot.height / longer);
    int x = int(i) % columns * kCell, y = int(i) / columns * kCell;
    if (!points[i].color.empty()) {
      image::Image small = thumbnail(points[i].color, width, stops);
      width = small.width, height = small.height;
      image::paste(result.sheet, small, x, y);
    }
    auto share = [](int at, int of) { return float(at) / float(of); };
    result.places.push_back({share(x, result.sheet.width), share(y, result.sheet.height),
                             share(x + width, result.sheet.width), share(y + height, result.sheet.height)});
  }
  return result;
}

}  // namespace strobe::live
