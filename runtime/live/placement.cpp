// SPDX-License-Identifier: MIT
#include "live/placement.h"

#include <algorithm>
#include <cmath>

namespace strobe::live {

static const double kLeast = 0.25, kMost = 256;  // limits of the zoom

static double fittedScale(const WindowArea& area, int width, int height) {
  double scale = std::max(1e-3, std::min(area.width / width, area.height / height));
  return scale >= 2 ? std::floor(scale) : scale;
}

// Rounds to whole window pixels, so that enlarged pixels have sharp borders.
static dvec2 rounded(const dvec2& at) { return {std::round(at.x), std::round(at.y)}; }

PicturePlacement placed(const WindowArea& area, int width, int height, const Magnification& magnification) {
  PicturePlacement result;
  result.scale = fittedScale(area, width, height) * magnification.zoom;
  dvec2 middle(area.x + area.width / 2, area.y + area.height / 2);
  result.origin = rounded(middle - magnification.centre * dvec2(width, height) * result.scale);
  return result;
}

Magnification magnified(const Magnification& from, double factor, const dvec2& window, const WindowArea& area,
                        int width, int height) {
  Magnification result = from;
  result.zoom = std::clamp(from.zoom * factor, kLeast, kMost);
  dvec2 middle(area.x + area.width / 2, area.y + area.height / 2);
  double before = fittedScale(area, width, height) * from.zoom, after = fittedScale(area, width, height) * result.zoom;
  result.centre += (window - middle) * (1 / before - 1 / after) / dvec2(width, height);
  return result;
}

Magnification dragged(const Magnification& from, const dvec2& by_window, const WindowArea& area, int width,
                      int height) {
  Magnification result = from;
  double scale = fittedScale(area, width, height) * from.zoom;
  result.centre = glm::clamp(from.centre - by_window / scale / dvec2(width, height), dvec2(-0.5), dvec2(1.5));
  return result;
}

}  // namespace strobe::live
