// SPDX-License-Identifier: MIT
#include "live/thumbnails.h"

#include <algorithm>
#include <cmath>

#include "image/draw.h"
#include "image/tone.h"
#include "live/sweep.h"

namespace strobe::live {

static const int kCell = 192;  // longer side of a thumbnail, pixels
static const image::Colour kEmpty = {0.09f, 0.09f, 0.1f};

// Width and height of a thumbnail; the longer side is as long as a cell's.
static std::array<int, 2> sizeOf(int width, int height) {
  int longer = std::max({width, height, 1});
  return {std::max(1, kCell * width / longer), std::max(1, kCell * height / longer)};
}

image::Image reduced(const image::Image& linear) {
  if (std::max(linear.width, linear.height) <= kCell) return linear;
  auto [width, height] = sizeOf(linear.width, linear.height);
  return image::shrunk(linear, width, height);
}

// Crop with the largest error of all points, its pixels as squares; the whole picture until every point has an error.
static image::Image thumbnailOf(const SweepPoint& point, const SweepPoint* worst) {
  if (!worst || point.color.empty()) return point.thumbnail;
  const image::Rectangle area = image::scaledCrop(worst->worst, double(point.color.width) / worst->color.width,
                                                  double(point.color.height) / worst->color.height, point.color);
  const image::Image small = reduced(image::crop(point.color, area));
  return image::magnify(small, std::max(1, kCell / std::max(small.width, small.height)));
}

Thumbnails thumbnailsOf(const Sweep& sweep, double stops) {
  const auto& points = sweep.points();
  const SweepPoint* worst = sweep.worst();
  int columns = int(std::ceil(std::sqrt(double(points.size()))));
  int rows = (int(points.size()) + columns - 1) / columns;
  Thumbnails result{image::filled(columns * kCell, rows * kCell, kEmpty), {}};
  for (size_t i = 0; i < points.size(); ++i) {
    auto [width, height] = sizeOf(points[i].shot.width, points[i].shot.height);
    int x = int(i) % columns * kCell, y = int(i) / columns * kCell;
    const image::Image small = thumbnailOf(points[i], worst);
    if (!small.empty()) {
      width = small.width, height = small.height;
      image::paste(result.sheet, image::toneMap(small, {float(stops)}), x, y);
    }
    auto share = [](int at, int of) { return float(at) / float(of); };
    result.places.push_back({share(x, result.sheet.width), share(y, result.sheet.height),
                             share(x + width, result.sheet.width), share(y + height, result.sheet.height)});
  }
  return result;
}

}  // namespace strobe::live
