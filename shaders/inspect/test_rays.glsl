// SPDX-License-Identifier: MIT
// One random ray per pixel through the scene at the raster time, and its hit, to compare the tracing backends. Many of the rays
// are difficult, because rounding decides which triangle they hit.
// In:  none; points are taken from random triangles of the scene.
// Out: `origin`: ray origin relative to the camera at the raster time, world axes, metres.
//      `direction`: rgb: ray direction, of any length; alpha: largest ray parameter t.
//      `hit`: instance + 1, geometry, primitive, ray parameter t as the bits of a float; 0 on a miss.
//      `color`: rgb: t of the hit; 0 on a miss.
//      `blocked`: 1 if any surface lies on the ray, otherwise 0.
// Method: the parameter `ray_kind` chooses one of eight kinds of rays, or `all`: the kinds in turn, one per row of pixels.
//   Kinds: `through`, between two random points; `vertex`, to a vertex; `edge`, to a point of an edge; `axis`, along an axis
//   through a vertex; `grazing`, from a surface point along an edge of its triangle; `afar`, from far away (10^4 times the
//   distance between two random points); `surface`, from a surface point in a random direction; `plane`, within an axis-aligned
//   plane.
// Fails: never; a degenerate triangle may give the direction (0, 0, 1).
#include "lib/random.glsl"
#include "mixin/trace.glsl"

const uint kKinds = 8u;

// Number of random values drawn so far, and number of the ray: together they select the next random value.
uint drawn = 0u;
uint ray_number = 0u;

uint anyUint() { return randomUint(ray_number, 0u, ++drawn); }
float anyFloat() { return float(anyUint() >> 8) / 16777216.0; }
vec3 anyVec3() {
  float x = anyFloat(), y = anyFloat();
  return vec3(x, y, anyFloat());
}

struct Corners {
  vec3 at[3];
};

// Corners of a random triangle of a random instance, world space; 0 if the instance has no triangles.
Corners anyTriangle() {
  uint instance = anyUint() % frame.instance_count;
  uint count = instanceAt(instance).geometry_count;
  Corners corners = Corners(vec3[3](vec3(0), vec3(0), vec3(0)));
  if (count == 0u) return corners;
  SceneGeometry geometry = geometryOf(instance, anyUint() % count);
  if (geometry.triangle_count == 0u) return corners;
  Triangle triangle = triangleOf(geometry, anyUint() % geometry.triangle_count);
  for (int c = 0; c < 3; ++c)
    corners.at[c] =
        worldFromObject(transformOf(SLICE_RASTER, instance), vertexPosition(SLICE_RASTER, triangle.vertex[c]));
  return corners;
}

// Random point of a triangle, evenly distributed.
vec3 anySurfacePoint(Corners corners) {
  float u = anyFloat(), v = anyFloat();
  if (u + v > 1.0) {
    u = 1.0 - u;
    v = 1.0 - v;
  }
  return corners.at[0] + u * (corners.at[1] - corners.at[0]) + v * (corners.at[2] - corners.at[0]);
}

// Random point in the box between the first corners of two random triangles.
vec3 anyPoint() { return mix(anyTriangle().at[0], anyTriangle().at[1], anyVec3()); }

// Random ray of a kind, numbered in the order of the values of `ray_kind`.
Ray anyRay(uint kind) {
  Corners corners = anyTriangle();
  vec3 edge = corners.at[1] - corners.at[0];
  uint axis = anyUint() % 3u;
  vec3 unit = vec3(0);
  unit[axis] = (anyUint() & 1u) == 0u ? 1.0 : -1.0;
  vec3 start = anyPoint(), target = anySurfacePoint(corners);
  if (kind == 0u) return Ray(start, anyPoint() - start);
  if (kind == 1u) return Ray(start, corners.at[0] - start);
  if (kind == 2u) return Ray(start, corners.at[0] + anyFloat() * edge - start);
  if (kind == 3u) return Ray(corners.at[0] - unit * dot(unit, corners.at[0] - start), unit);
  if (kind == 4u) return Ray(target, edge);
  vec3 turn = 2.0 * anyVec3() - 1.0;
  if (kind == 5u) return Ray(target + 1e4 * length(target - start) * turn, -turn);
  if (kind == 6u) return Ray(target, turn);
  start[axis] = target[axis];
  return Ray(start, target - start);
}

void run(ivec2 pixel) {
  ray_number = uint(pixel.y) * frame.size.x + uint(pixel.x);
  uint kind = PARAM_ray_kind == ray_kind_all ? uint(pixel.y) % kKinds : uint(PARAM_ray_kind - ray_kind_through);
  Ray ray = anyRay(kind);
  if (ray.direction == vec3(0)) ray.direction = vec3(0, 0, 1);
  float t_max = 3.0e38;
  Hit hit = traceNearest(SLICE_RASTER, ray, 0.0, t_max);
  bool blocked = isBlocked(SLICE_RASTER, ray, 0.0, t_max);
  imageStore(origin_img, pixel, vec4(ray.origin, 0));
  imageStore(direction_img, pixel, vec4(ray.direction, t_max));
  uvec4 name = uvec4(hit.instance + 1u, hit.geometry, hit.primitive, floatBitsToUint(hit.t));
  imageStore(color_img, pixel, vec4(vec3(isHit(hit) ? hit.t : 0.0), 1));
  imageStore(hit_img, pixel, isHit(hit) ? name : uvec4(0u));
  imageStore(blocked_img, pixel, uvec4(blocked ? 1u : 0u));
}
