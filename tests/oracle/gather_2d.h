// SPDX-License-Identifier: MIT
// Guertin's gather in the plane, in double precision, from the images it reads. It covers the second direction and the
// weights of directions, which a row lacks. Conventions as in closed_form.h.
#pragma once

#include "image/image.h"
#include "oracle/closed_form.h"

namespace strobe::oracle {

struct Vec2d {
  double x = 0, y = 0;
};

// Direction of every other sample of a pixel: a unit vector or 0. `own` is the pixel's displacement and `radius` its
// spread; `other` chooses the side if `own` has no component across `dominant`.
Vec2d secondDirection(Vec2d dominant, Vec2d own, Vec2d other, double radius, double gamma);

struct Plane {
  const image::Image* color;  // only the first channel is read
  const image::Image* depth;
  const image::Image* velocity;  // px over the exposure
  const image::Image* dominant;  // per tile
  const image::Image* second;    // per tile
  const image::Image* variance;  // per tile; may be null
  int tile = 32;
};

struct PlaneGuertin {
  int samples = 16;
  double jitter = 0;
  Window window = kCentreAnchor;
  double kappa = 40, gamma = 1.5, eta = 0.95, depth_extent = 0.01;
};
double guertinAt(const Plane& plane, int x, int y, const PlaneGuertin& options);

}  // namespace strobe::oracle
