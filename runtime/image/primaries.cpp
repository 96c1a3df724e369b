// SPDX-License-Identifier: MIT
#include "image/primaries.h"

#include <fmt/format.h>

#include <cmath>
#include <glm/matrix.hpp>

namespace strobe::image {

using glm::dmat3;
using glm::dvec2;
using glm::dvec3;

static dvec3 xyzOf(dvec2 chromaticity) {
  return {chromaticity.x / chromaticity.y, 1, (1 - chromaticity.x - chromaticity.y) / chromaticity.y};
}

// Matrix from linear RGB to XYZ. RGB (1, 1, 1) is white of luminance 1.
static dmat3 xyzFrom(const Primaries& primaries) {
  dmat3 columns(xyzOf(primaries.red), xyzOf(primaries.green), xyzOf(primaries.blue));
  dvec3 luminance = glm::inverse(columns) * xyzOf(primaries.white);
  return dmat3(columns[0] * luminance.r, columns[1] * luminance.g, columns[2] * luminance.b);
}

// Matrix from XYZ to the cone responses of Bradford (Lam 1985).
static const dmat3 kBradford =
    glm::transpose(dmat3(0.8951, 0.2664, -0.1614, -0.7502, 1.7135, 0.0367, 0.0389, -0.0685, 1.0296));

static dmat3 adaptation(dvec2 from_white, dvec2 to_white) {
  dvec3 scale = (kBradford * xyzOf(to_white)) / (kBradford * xyzOf(from_white));
  return glm::inverse(kBradford) * dmat3(scale.x, 0, 0, 0, scale.y, 0, 0, 0, scale.z) * kBradford;
}

bool Primaries::areRec709() const {
  const Primaries rec709;
  auto near = [](dvec2 a, dvec2 b) { return std::abs(a.x - b.x) <= 5e-4 && std::abs(a.y - b.y) <= 5e-4; };
  return near(red, rec709.red) && near(green, rec709.green) && near(blue, rec709.blue) && near(white, rec709.white);
}

bool Primaries::areValid() const {
  auto cross = [](dvec2 a, dvec2 b) { return a.x * b.y - a.y * b.x; };
  double area = cross(green - red, blue - red);
  double shares[] = {cross(green - white, blue - white) / area, cross(blue - white, red - white) / area,
                     cross(red - white, green - white) / area};
  for (double y : {red.y, green.y, blue.y, white.y})
    if (!(std::abs(y) > 1e-6)) return false;
  for (double share : shares)
    if (!(share > 1e-6)) return false;
  return true;
}

std::string Primaries::text() const {
  return fmt::format("red {:.4g} {:.4g}, green {:.4g} {:.4g}, blue {:.4g} {:.4g}, white {:.4g} {:.4g}", red.x, red.y,
                     green.x, green.y, blue.x, blue.y, white.x, white.y);
}

dmat3 rec709From(const Primaries& primaries) {
  const Primaries rec709;
  return glm::inverse(xyzFrom(rec709)) * adaptation(primaries.white, rec709.white) * xyzFrom(primaries);
}

std::string convertStated(Image& linear, const Primaries& primaries) {
  if (!primaries.areValid())
    return fmt::format("its primaries are not used, because their triangle does not contain white: {}",
                       primaries.text());
  const dmat3 conversion = rec709From(primaries);
  for (size_t i = 0; i + 2 < linear.values.size(); i += 3) {
    dvec3 rgb = conversion * dvec3(linear.values[i], linear.values[i + 1], linear.values[i + 2]);
    for (int c = 0; c < 3; ++c) linear.values[i + size_t(c)] = float(rgb[c]);
  }
  return fmt::format("its colours are converted to Rec. 709 from its primaries: {}", primaries.text());
}

}  // namespace strobe::image
