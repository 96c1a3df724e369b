// SPDX-License-Identifier: MIT
#include "scene/shapes.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include "math/constants.h"

namespace strobe::scene {

namespace {

// Adds a grid of (nu + 1) x (nv + 1) points. Empty triangles at coinciding neighbours (a pole) are left out. Seen from
// outside, u runs to the right and v downwards.
struct GridWriter {
  Shape& shape;

  template <class PointAt>
  void write(int nu, int nv, PointAt point_at) {
    uint32_t base = uint32_t(shape.points.size());
    for (int v = 0; v <= nv; ++v)
      for (int u = 0; u <= nu; ++u) shape.points.push_back(point_at(u, v));
    auto index = [&](int u, int v) { return base + uint32_t(v * (nu + 1) + u); };
    for (int v = 0; v < nv; ++v) {
      for (int u = 0; u < nu; ++u) {
        triangle(index(u, v), index(u, v + 1), index(u + 1, v + 1));
        triangle(index(u, v), index(u + 1, v + 1), index(u + 1, v));
      }
    }
  }

  void triangle(uint32_t a, uint32_t b, uint32_t c) {
    const auto& p = shape.points;
    if (p[a].position == p[b].position || p[b].position == p[c].position || p[c].position == p[a].position) return;
    shape.indices.insert(shape.indices.end(), {a, b, c});
  }
};

// Cosine and sine of step `i` of `n` around the circle; the last step equals the first to the bit.
dvec2 onCircle(int i, int n) {
  double angle = 2 * kPi * (i % n) / n;
  return {std::cos(angle), std::sin(angle)};
}

dvec3 unitOr(const dvec3& v, const dvec3& otherwise) {
  double length = glm::length(v);
  return length > 0 ? v / length : otherwise;
}

// Catmull-Rom curve through the points (ends repeated), `steps` per span.
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

double signedPower(double x, double e) {
  double magnitude = std::abs(x) < 1e-12 ? 0 : std::pow(std::abs(x), e);
  return std::copysign(magnitude, x);
}

}  // namespace

Shape quad(dvec2 size, ivec2 segments, double tile) {
  Shape shape;
  dvec2 repeats = tile > 0 ? size / tile : dvec2(1);
  GridWriter{shape}.write(segments.x, segments.y, [&](int u, int v) {
    dvec2 at(double(u) / segments.x, double(v) / segments.y);
    return Shape::Point{{(at.x - 0.5) * size.x, (0.5 - at.y) * size.y, 0}, {0, 0, 1}, at * repeats};
  });
  return shape;
}

// Offsets along one side of a face. The rounded ends have equal angles up to 45 degrees, where the next face begins.
static std::vector<double> sideOffsets(double half, double radius, int segments) {
  if (radius <= 0) return {-half, half};
  std::vector<double> offsets;
  int steps = std::max(1, (segments + 1) / 2);
  for (int i = steps; i >= 0; --i) offsets.push_back(-(half - radius) - radius * std::tan(kPi / 4 * i / steps));
  for (int i = 0; i <= steps; ++i) offsets.push_back((half - radius) + radius * std::tan(kPi / 4 * i / steps));
  offsets.front() = -half;
  offsets.back() = half;
  return offsets;
}

Shape box(dvec3 size, double radius, int segments, double tile) {
  Shape shape;
  dvec3 half = size * 0.5;
  radius = std::min({radius, half.x, half.y, half.z});
  // Right and up directions of each face. The normal is right x up.
  const dvec3 sides[6][2] = {{{0, 0, -1}, {0, 1, 0}}, {{0, 0, 1}, {0, 1, 0}}, {{1, 0, 0}, {0, 0, -1}},
                             {{1, 0, 0}, {0, 0, 1}},  {{1, 0, 0}, {0, 1, 0}}, {{-1, 0, 0}, {0, 1, 0}}};
  for (const auto& side : sides) {
    dvec3 right = side[0], up = side[1], out = glm::cross(right, up);
    double half_u = glm::dot(glm::abs(right), half), half_v = glm::dot(glm::abs(up), half);
    std::vector<double> us = sideOffsets(half_u, radius, segments), vs = sideOffsets(half_v, radius, segments);
    GridWriter{shape}.write(int(us.size()) - 1, int(vs.size()) - 1, [&](int u, int v) {
      dvec3 on_face = out * half + right * us[u] - up * vs[v];
      dvec3 inner = glm::clamp(on_face, -(half - radius), half - radius);
      dvec3 normal = unitOr(on_face - inner, out);
      dvec2 uv(us[u] + half_u, vs[v] + half_v);
      uv = tile > 0 ? uv / tile : uv / dvec2(2 * half_u, 2 * half_v);
      return Shape::Point{radius > 0 ? inner + radius * normal : on_face, normal, uv};
    });
  }
  return shape;
}

Shape superellipsoid(dvec3 size, double north, double east, int segments) {
  Shape shape;
  dvec3 half = size * 0.5;
  int rings = std::max(2, segments / 2);
  GridWriter{shape}.write(segments, rings, [&](int u, int v) {
    double latitude = kPi * v / rings;
    double s = v == 0 || v == rings ? 0 : std::sin(latitude), c = v == 0 ? 1 : v == rings ? -1 : std::cos(latitude);
    dvec2 a = onCircle(u, segments);
    dvec3 position(signedPower(s, north) * signedPower(a.x, east), signedPower(c, north),
                   -signedPower(s, north) * signedPower(a.y, east));
    dvec3 normal(signedPower(s, 2 - north) * signedPower(a.x, 2 - east), signedPower(c, 2 - north),
                 -signedPower(s, 2 - north) * signedPower(a.y, 2 - east));
    dvec2 uv(double(u) / segments, double(v) / rings);
    return Shape::Point{position * half, unitOr(normal / half, {0, c, 0}), uv};
  });
  return shape;
}

Shape sphere(double radius, int segments) { return superellipsoid(dvec3(2 * radius), 1, 1, segments); }

Shape torus(double radius, double tube_radius, int segments, int tube_segments) {
  Shape shape;
  GridWriter{shape}.write(segments, tube_segments, [&](int u, int v) {
    dvec2 around = onCircle(u, segments), ring = onCircle(v, tube_segments);
    dvec3 out(around.x, 0, -around.y);
    dvec3 normal = out * ring.x + dvec3(0, -ring.y, 0);
    return Shape::Point{out * radius + normal * tube_radius, normal,
                        dvec2(double(u) / segments, double(v) / tube_segments)};
  });
  return shape;
}

// Outward normal of span i of the profile, as (radius, height). A span of length 0 has the normal of the previous span.
static dvec2 spanNormal(const std::vector<dvec2>& profile, size_t i) {
  dvec2 along = profile[i + 1] - profile[i];
  double length = glm::length(along);
  if (length > 0) return dvec2(along.y, -along.x) / length;
  return i > 0 ? spanNormal(profile, i - 1) : dvec2(1, 0);
}

Shape lathe(const std::vector<dvec2>& given, int segments, int smooth, double crease_deg) {
  std::vector<dvec2> profile = refined(given, smooth);
  for (dvec2& point : profile) point.x = std::max(point.x, 0.0);
  std::vector<double> lengths(profile.size(), 0.0);
  for (size_t i = 1; i < profile.size(); ++i) lengths[i] = lengths[i - 1] + glm::distance(profile[i], profile[i - 1]);

  Shape shape;
  double sharp = std::cos(glm::radians(crease_deg));
  auto cornerNormal = [&](size_t span, size_t neighbour) {
    if (neighbour >= profile.size() - 1) return spanNormal(profile, span);  // also for the span before the first
    dvec2 a = spanNormal(profile, span), b = spanNormal(profile, neighbour);
    return glm::dot(a, b) > sharp ? glm::normalize(a + b) : a;
  };
  for (size_t span = 0; span + 1 < profile.size(); ++span) {
    dvec2 low_normal = cornerNormal(span, span - 1), high_normal = cornerNormal(span, span + 1);
    if (profile[span].x == 0 && span == 0) low_normal = profile[1].y == profile[0].y ? low_normal : dvec2(0, -1);
    GridWriter{shape}.write(segments, 1, [&](int u, int v) {
      size_t at = v == 0 ? span + 1 : span;
      dvec2 normal = v == 0 ? high_normal : low_normal, around = onCircle(u, segments), point = profile[at];
      return Shape::Point{{point.x * around.x, point.y, -point.x * around.y},
                          {normal.x * around.x, normal.y, -normal.x * around.y},
                          {double(u) / segments, 1 - lengths[at] / lengths.back()}};
    });
  }
  return shape;
}

Shape cylinder(double radius, double top_radius, double height, int segments, double bevel) {
  double half = height * 0.5;
  std::vector<dvec2> profile = {{0, -half}};
  auto rim = [&](double r, double y, double from_deg) {
    double b = std::min({bevel, r, half});
    if (b <= 0) return profile.push_back({r, y});
    for (int i = 0; i <= 4; ++i) {
      double angle = glm::radians(from_deg + 90.0 * i / 4);
      profile.push_back({r - b + b * std::cos(angle), y - std::copysign(b, y) + b * std::sin(angle)});
    }
  };
  if (radius > 0) rim(radius, -half, -90);
  if (top_radius > 0) rim(top_radius, half, 0);
  profile.push_back({0, half});
  return lathe(profile, segments);
}

Shape tube(const std::vector<dvec3>& given, const std::vector<double>& given_radii, int segments, int smooth,
           double flatten, dvec3 up) {
  std::vector<dvec3> path = refined(given, smooth);
  std::vector<double> radii = refined(given_radii, smooth);
  size_t n = path.size();
  auto radius = [&](size_t i) { return std::max(1e-6, radii[std::min(i, radii.size() - 1)]); };
  auto direction = [&](size_t i) {
    return unitOr(path[std::min(i + 1, n - 1)] - path[i > 0 ? i - 1 : 0], dvec3(0, 1, 0));
  };

  // Rings in a frame that moves along the path without twist. The thin direction starts as `up`.
  dvec3 thin = up - direction(0) * glm::dot(up, direction(0));
  if (glm::length(thin) < 1e-6) thin = glm::cross(direction(0), dvec3(1, 0, 0.1));
  thin = glm::normalize(thin);
  std::vector<dvec3> thins(n);
  for (size_t i = 0; i < n; ++i) {
    thin = unitOr(thin - direction(i) * glm::dot(thin, direction(i)), thin);
    thins[i] = thin;
  }
  Shape shape;
  auto ring = [&](int u, size_t i) {
    dvec2 around = onCircle(u, segments);
    dvec3 wide = glm::cross(thins[i], direction(i));
    return Shape::Point{path[i] + radius(i) * (wide * around.x + thins[i] * around.y * flatten),
                        glm::normalize(wide * around.x * flatten + thins[i] * around.y),
                        dvec2(double(u) / segments, 1 - double(i) / double(n - 1))};
  };
  GridWriter{shape}.write(segments, int(n) - 1, [&](int u, int v) { return ring(u, n - 1 - size_t(v)); });
  auto cap = [&](size_t i, double side) {
    GridWriter{shape}.write(segments, 1, [&](int u, int v) {
      Shape::Point point = ring(u, i);
      point.normal = direction(i) * side;
      if ((v == 0) == (side > 0)) point.position = path[i];
      return point;
    });
  };
  cap(n - 1, 1);
  cap(0, -1);
  return shape;
}

// Replaces normals by the area-weighted mean of the triangles around each position. Points at one position share it.
static void smoothNormals(Shape& shape) {
  std::map<std::tuple<double, double, double>, dvec3> sums;
  auto key = [](const dvec3& p) { return std::make_tuple(p.x + 0.0, p.y + 0.0, p.z + 0.0); };
  for (size_t i = 0; i + 2 < shape.indices.size(); i += 3) {
    dvec3 corner[3];
    for (int k = 0; k < 3; ++k) corner[k] = shape.points[shape.indices[i + k]].position;
    dvec3 weighted = glm::cross(corner[1] - corner[0], corner[2] - corner[0]);
    for (const dvec3& p : corner) sums[key(p)] += weighted;
  }
  for (Shape::Point& point : shape.points) point.normal = unitOr(sums[key(point.position)], point.normal);
}

// Shell of a front and a back sheet over the same grid, joined along the rim. `front` and `back` take (u, v) in 0..1.
template <class Front, class Back>
static Shape shell(ivec2 segments, Front front, Back back) {
  Shape shape;
  auto at = [&](int u, int v) { return dvec2(double(u) / segments.x, double(v) / segments.y); };
  GridWriter{shape}.write(segments.x, segments.y, [&](int u, int v) {
    return Shape::Point{front(at(u, v)), {0, 0, 1}, at(u, v)};
  });
  GridWriter{shape}.write(segments.x, segments.y, [&](int u, int v) {
    dvec2 uv = at(segments.x - u, v);
    return Shape::Point{back(uv), {0, 0, -1}, {1 - uv.x, uv.y}};
  });
  auto rim = [&](int count, auto uv_of) {
    GridWriter{shape}.write(count, 1, [&](int i, int v) {
      dvec2 uv = uv_of(i);
      return Shape::Point{v == 0 ? back(uv) : front(uv), {0, 0, 1}, uv};
    });
  };
  rim(segments.x, [&](int i) { return at(i, 0); });
  rim(segments.x, [&](int i) { return at(segments.x - i, segments.y); });
  rim(segments.y, [&](int i) { return at(0, segments.y - i); });
  rim(segments.y, [&](int i) { return at(segments.x, i); });
  smoothNormals(shape);
  return shape;
}

Shape cushion(dvec3 size, double pinch, int quilt, double quilt_depth, int segments) {
  auto surface = [&](dvec2 uv, double side) {
    dvec2 a = uv * 2.0 - 1.0;
    dvec2 bow(1 - pinch * (1 - a.y * a.y), 1 - pinch * (1 - a.x * a.x));
    dvec2 full = glm::max(dvec2(0), 1.0 - a * a);
    double height = std::pow(full.x * full.y, 0.4);
    if (quilt > 0) {
      dvec2 cell = glm::abs(dvec2(std::sin(kPi * quilt * uv.x), std::sin(kPi * quilt * uv.y)));
      height *= 1 - quilt_depth * (1 - std::sqrt(std::min(cell.x, cell.y)));
    }
    return dvec3(a.x * bow.x * size.x * 0.5, -a.y * bow.y * size.y * 0.5, side * height * size.z * 0.5);
  };
  return shell(
      ivec2(segments), [&](dvec2 uv) { return surface(uv, 1); }, [&](dvec2 uv) { return surface(uv, -1); });
}

Shape cloth(dvec3 size, double folds, double flare, double thickness, ivec2 segments) {
  auto surface = [&](dvec2 uv) {
    double depth = size.z * 0.5 * (1 - flare + flare * uv.y);
    double wave = std::sin(2 * kPi * folds * uv.x + 0.9 * std::sin(3 * uv.x + 1.3 * uv.y));
    return dvec3((uv.x - 0.5) * size.x, (0.5 - uv.y) * size.y, depth * wave);
  };
  return shell(segments, surface, [&](dvec2 uv) { return surface(uv) - dvec3(0, 0, thickness); });
}

Shape triangles(const std::vector<dvec3>& positions, const std::vector<dvec3>& normals, const std::vector<dvec2>& uvs,
                const std::vector<uint32_t>& indices) {
  Shape shape;
  for (size_t i = 0; i + 2 < indices.size(); i += 3) {
    uint32_t corner[3] = {indices[i], indices[i + 1], indices[i + 2]};
    dvec3 a = positions[corner[0]], b = positions[corner[1]], c = positions[corner[2]];
    dvec3 facet = unitOr(glm::cross(b - a, c - a), {0, 0, 1});
    for (uint32_t k : corner) {
      shape.indices.push_back(uint32_t(shape.points.size()));
      shape.points.push_back(
          {positions[k], normals.empty() ? facet : unitOr(normals[k], facet), uvs.empty() ? dvec2(0) : uvs[k]});
    }
  }
  return shape;
}

Shape transformed(Shape shape, const dmat4& matrix) {
  dmat3 linear(matrix);
  dmat3 for_normals = glm::determinant(linear) == 0 ? dmat3(1) : glm::transpose(glm::inverse(linear));
  for (Shape::Point& point : shape.points) {
    point.position = dvec3(matrix * dvec4(point.position, 1));
    point.normal = unitOr(for_normals * point.normal, point.normal);
  }
  if (glm::determinant(linear) < 0)
    for (size_t i = 0; i + 2 < shape.indices.size(); i += 3) std::swap(shape.indices[i + 1], shape.indices[i + 2]);
  return shape;
}

dvec3 originFor(const Bounds& bounds) {
  if (bounds.empty()) return dvec3(0);
  dvec3 extent = bounds.high - bounds.low, middle = bounds.middle();
  double largest = std::max({extent.x, extent.y, extent.z});
  if (!(largest > 0) || !std::isfinite(largest)) return glm::all(glm::equal(middle, middle)) ? middle : dvec3(0);
  double grid = std::exp2(std::ceil(std::log2(largest)) - 8);
  return glm::round(middle / grid) * grid;
}

Mesh meshOf(const std::string& name, const std::vector<MeshPart>& parts) {
  Mesh mesh;
  mesh.name = name;
  Bounds bounds;
  for (const MeshPart& part : parts)
    for (const Shape::Point& point : part.shape.points) bounds.add(point.position);
  mesh.origin = originFor(bounds);
  for (const MeshPart& part : parts) {
    Geometry geometry;
    geometry.material = part.material;
    geometry.indices = part.shape.indices;
    for (const Shape::Point& point : part.shape.points) {
      Vertex vertex;
      vertex.position = vec3(point.position - mesh.origin);
      vertex.normal = vec3(point.normal);
      vertex.uv0 = vec2(point.uv);
      geometry.vertices.push_back(vertex);
    }
    mesh.geometries.push_back(std::move(geometry));
  }
  return mesh;
}

}  // namespace strobe::scene
