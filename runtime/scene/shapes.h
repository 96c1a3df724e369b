// SPDX-License-Identifier: MIT
// Parametric shapes, in double: triangles wound anticlockwise seen from outside, unit normals, texture coordinates with
// v downwards. All are centred on the origin unless said; the closed ones enclose a volume without gaps or overlaps.
#pragma once

#include <algorithm>
#include <optional>

#include "math/bounds.h"
#include "scene/scene.h"

namespace strobe::scene {

struct Shape {
  struct Point {
    dvec3 position;
    dvec3 normal;
    dvec2 uv;
  };
  std::vector<Point> points;
  std::vector<uint32_t> indices;
};

// A rectangle in the xy plane that faces +z; `tile` metres per repeat of the texture, 0 for one repeat over all of it.
Shape quad(dvec2 size, ivec2 segments = ivec2(1), double tile = 0);

// A box, its edges rounded with `radius` in `segments` steps per quarter where that is not 0. Each face carries the
// whole texture (or one repeat per `tile` metres). Closed.
Shape box(dvec3 size, double radius = 0, int segments = 3, double tile = 0);

// Closed; the poles are on y.
Shape sphere(double radius, int segments = 32);
Shape torus(double radius, double tube_radius, int segments = 48, int tube_segments = 16);

// |x/a|^(2/east) ... of Barr 1981: exponents of 1 give an ellipsoid, near 0 a box, 2 an octahedron. Closed.
Shape superellipsoid(dvec3 size, double north, double east, int segments = 32);

// The surface swept by `profile` (radius, height) around y. Outside is to the right of the direction of the profile
// as it goes up, so profiles run from the bottom upwards (and back down inside a vessel). Corners sharper than
// `crease_deg` stay sharp. `smooth` > 1 first refines the profile with that many steps per span (Catmull-Rom).
// Closed when it starts and ends on the axis.
Shape lathe(const std::vector<dvec2>& profile, int segments = 48, int smooth = 1, double crease_deg = 40);

// A cylinder or cone along y with flat ends, its rims rounded by `bevel`. Closed.
Shape cylinder(double radius, double top_radius, double height, int segments = 48, double bevel = 0);

// A tube along `path` with one radius per point; `flatten` < 1 squeezes it towards `up` (a leaf). Ends are capped.
// `smooth` refines as in `lathe`. Closed.
Shape tube(const std::vector<dvec3>& path, const std::vector<double>& radii, int segments = 12, int smooth = 1,
           double flatten = 1, dvec3 up = dvec3(0, 1, 0));

// A pillow lying in the xy plane: `size` with its greatest thickness as z, sides drawn in by `pinch`, and seams of
// `quilt` x `quilt` cells sunk by `quilt_depth` of the thickness. Closed.
Shape cushion(dvec3 size, double pinch = 0.06, int quilt = 0, double quilt_depth = 0.15, int segments = 32);

// Hanging cloth in the xy plane: `folds` waves of depth size.z, fuller towards the hem by `flare`. Closed.
Shape cloth(dvec3 size, double folds, double flare = 0.3, double thickness = 0.004, ivec2 segments = ivec2(96, 12));

// Literal triangles; without normals they are faceted, without uvs 0.
Shape triangles(const std::vector<dvec3>& positions, const std::vector<dvec3>& normals, const std::vector<dvec2>& uvs,
                const std::vector<uint32_t>& indices);

// Points moved by `matrix` and normals by its inverse transpose; a mirroring matrix turns the winding.
Shape transformed(Shape shape, const dmat4& matrix);

// The mesh of several parts, with positions relative to its `origin`: the middle of its bounds, on a grid fine enough
// to be near and coarse enough that subtracting it is exact in single precision but for the last bits.
struct Part {
  Shape shape;
  int material = 0;
};
Mesh meshOf(const std::string& name, const std::vector<Part>& parts);

// The middle of the bounds on that grid; 0 of empty ones.
dvec3 originFor(const Bounds& bounds);

// Catmull-Rom through the points (ends repeated), `steps` per span.
template <class Vector>
std::vector<Vector> refined(const std::vector<Vector>& points, int steps) {
  if (steps <= 1 || points.size() < 3) return points;
  std::vector<Vector> result;
  auto at = [&](long i) { return points[std::clamp<long>(i, 0, long(points.size()) - 1)]; };
  for (long i = 0; i + 1 < long(points.size()); ++i) {
    for (int k = 0; k < steps; ++k) {
      double t = double(k) / steps;
      Vector a = at(i - 1), b = at(i), c = at(i + 1), d = at(i + 2);
      result.push_back(0.5 * (2.0 * b + (c - a) * t + (2.0 * a - 5.0 * b + 4.0 * c - d) * (t * t) +
                              (3.0 * b - a - 3.0 * c + d) * (t * t * t)));
    }
  }
  result.push_back(points.back());
  return result;
}

}  // namespace strobe::scene
