// SPDX-License-Identifier: MIT
// Parametric shapes in double precision: triangles wound anticlockwise seen from outside, unit normals, texture
// coordinates with v downwards. Shapes are centred on the origin unless stated. Closed shapes enclose a volume without
// gaps or overlaps.
#pragma once

#include "math/bounds.h"
#include "scene/scene.h"

namespace strobe::scene {

// Indexed triangle mesh in double precision; each point has a position, a normal and texture coordinates.
struct Shape {
  struct Point {
    dvec3 position;
    dvec3 normal;
    dvec2 uv;
  };
  std::vector<Point> points;
  std::vector<uint32_t> indices;
};

// Rectangle in the xy plane that faces +z. The texture repeats every `tile` metres; 0: once over the rectangle.
Shape quad(dvec2 size, ivec2 segments = ivec2(1), double tile = 0);

// Box. If `radius` is not 0, its edges are rounded in `segments` steps per quarter circle. Each face has the whole
// texture, or one repeat per `tile` metres. Closed.
Shape box(dvec3 size, double radius = 0, int segments = 3, double tile = 0);

// Closed; the poles are on y.
Shape sphere(double radius, int segments = 32);
Shape torus(double radius, double tube_radius, int segments = 48, int tube_segments = 16);

// Superellipsoid |x/a|^(2/east) ... of Barr 1981. Exponents of 1 give an ellipsoid, near 0 a box, 2 an octahedron.
// Closed.
Shape superellipsoid(dvec3 size, double north, double east, int segments = 32);

// Surface of revolution of `profile` (radius, height) around y. Outside is on the right of a profile that goes up, so
// profiles run from the bottom upwards (and back down inside a vessel). Corners sharper than `crease_deg` stay sharp.
// `smooth` > 1 first refines the profile with that many steps per span (Catmull-Rom). Closed if the profile starts and
// ends on the axis.
Shape lathe(const std::vector<dvec2>& profile, int segments = 48, int smooth = 1, double crease_deg = 40);

// Cylinder or cone along y with flat ends. Its rims are rounded by `bevel`. Closed.
Shape cylinder(double radius, double top_radius, double height, int segments = 48, double bevel = 0);

// Tube along `path` with one radius per point. `flatten` < 1 squeezes the tube towards `up` (a leaf). Ends are capped.
// `smooth` refines as in `lathe`. Closed.
Shape tube(const std::vector<dvec3>& path, const std::vector<double>& radii, int segments = 12, int smooth = 1,
           double flatten = 1, dvec3 up = dvec3(0, 1, 0));

// Pillow in the xy plane. The z of `size` is its greatest thickness. The sides are drawn in by `pinch`, and seams of
// `quilt` x `quilt` cells are sunk by `quilt_depth` of the thickness. Closed.
Shape cushion(dvec3 size, double pinch = 0.06, int quilt = 0, double quilt_depth = 0.15, int segments = 32);

// Hanging cloth in the xy plane: `folds` waves of depth size.z, wider towards the hem by `flare`. Closed.
Shape cloth(dvec3 size, double folds, double flare = 0.3, double thickness = 0.004, ivec2 segments = ivec2(96, 12));

// Shape of given triangles. Without normals the shape is faceted; without uvs, uv is 0.
Shape triangles(const std::vector<dvec3>& positions, const std::vector<dvec3>& normals, const std::vector<dvec2>& uvs,
                const std::vector<uint32_t>& indices);

// Points are transformed by `matrix`, and normals by its inverse transpose. A mirroring matrix reverses the winding.
Shape transformed(Shape shape, const dmat4& matrix);

// Part of a mesh: a shape with the index of its material.
struct MeshPart {
  Shape shape;
  int material = 0;
};

// Mesh of several parts, with positions relative to its `origin`. The origin is the middle of the bounds, rounded to a
// grid. The grid is fine enough for an origin near the middle, and coarse enough that the subtraction is exact in
// single precision except for the last bits.
Mesh meshOf(const std::string& name, const std::vector<MeshPart>& parts);

// Middle of the bounds on that grid; 0 for empty bounds.
dvec3 originFor(const Bounds& bounds);

}  // namespace strobe::scene
