// SPDX-License-Identifier: MIT
#include "stability/box_filter.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace strobe::stability {

// Appends the times within the window when the coordinate `start` + `speed` * t crosses a pixel border.
static void addCrossings(std::vector<double>& times, double start, double speed, const ExposureInterval& window) {
  if (speed == 0) return;
  double a = start + speed * window.from, b = start + speed * window.to;
  for (double border = std::ceil(std::min(a, b)); border <= std::max(a, b); ++border)
    times.push_back((border - start) / speed);
}

Mean meanAlong(const image::Image& picture, int x, int y, double dx, double dy, const ExposureInterval& window) {
  double start_x = x + 0.5, start_y = y + 0.5;
  std::vector<double> times = {window.from, window.to};
  addCrossings(times, start_x, -dx, window);
  addCrossings(times, start_y, -dy, window);
  std::sort(times.begin(), times.end());

  Mean mean;
  std::array<double, 3> last{};
  bool has_last = false;
  for (size_t i = 1; i < times.size(); ++i) {
    double from = times[i - 1], to = times[i];
    if (!(to > from)) continue;
    double middle = (from + to) / 2;
    int px = int(std::floor(start_x - dx * middle)), py = int(std::floor(start_y - dy * middle));
    mean.inside = mean.inside && px >= 0 && py >= 0 && px < picture.width && py < picture.height;
    px = std::clamp(px, 0, picture.width - 1);
    py = std::clamp(py, 0, picture.height - 1);
    for (int c = 0; c < 3; ++c) {
      double value = picture.at(px, py, std::min(c, picture.channels - 1));
      mean.color[size_t(c)] += value * (to - from) / (window.to - window.from);
      if (has_last) mean.variation[size_t(c)] += std::abs(value - last[size_t(c)]);
      last[size_t(c)] = value;
    }
    has_last = true;
  }
  return mean;
}

}  // namespace strobe::stability
