// SPDX-License-Identifier: MIT
// Where a layer's straight displacements say too little: how far paths are from straight lines, at the middle of the exposure
// from the middle between their ends, and by how much more of the picture a surface covers at the ends than at the capture.
// In a loop whose one time is the middle.
// In:  depth (view depth, m, sky +inf, 0 where the layer has nothing), id (instance + 1, 0 = sky), velocity (px over the
//      exposure), hit (geometry and primitive; absent: surfaces are rigid), normal (unit, world; absent: growth is not
//      looked at).
// Out: bend (how far, px), bent (1 where it is more than `most_bend` px, or a pixel grows to more than `most_growth`
//      px).
#include "lib/blur.glsl"
#include "mixin/stored.glsl"
#include "mixin/surface.glsl"

// Screen path of what a texel shows, px, from the capture to the pose of `slice`.
vec2 pathOfTexel(uint slice, ivec2 at) {
  Ray ray = cameraRay(SLICE_CAPTURE, samplePosition(at));
  uint id = texelFetch(id_tex, at, 0).x;
  if (id == 0u) return pathOfSky(slice, ray.direction);
  vec3 point_ws = ray.origin + ray.direction * texelFetch(depth_tex, at, 0).x;
#if HAS_hit
  uvec4 seen = texelFetch(hit_tex, at, 0);
  return pathOf(slice, hitOnTriangle(SLICE_CAPTURE, ray, id - 1u, seen.y, seen.z), point_ws);
#else
  return pathOfPoint(slice, id - 1u, point_ws);
#endif
}

bool isSame(ivec2 at, uint id) { return isInside(at, ivec2(frame.size)) && texelFetch(id_tex, at, 0).x == id; }

// Where the ray through a texel meets the plane of a surface.
vec3 onPlane(ivec2 at, vec3 point_ws, vec3 normal_ws) {
  Ray ray = cameraRay(SLICE_CAPTURE, samplePosition(at));
  return ray.origin + ray.direction * (dot(point_ws - ray.origin, normal_ws) / dot(ray.direction, normal_ws));
}

// Length at `slice`, px, of the longest way to the texels beside, of the same object. Where there is none along an axis, the
// object is turned away: the surface's plane says where they would be.
float growthAt(uint slice, ivec2 pixel, uint id, vec3 point_ws, vec3 normal_ws) {
  vec2 here = pathOfTexel(slice, pixel);
  float growth = 0.0;
  for (int axis = 0; axis < 2; ++axis) {
    ivec2 step = axis == 0 ? ivec2(1, 0) : ivec2(0, 1);
    bool alone = !isSame(pixel + step, id) && !isSame(pixel - step, id);
    for (int side = -1; side <= 1; side += 2) {
      ivec2 at = pixel + side * step;
      if (!alone && !isSame(at, id)) continue;
      vec2 there = alone ? pathOfPoint(slice, id - 1u, onPlane(at, point_ws, normal_ws)) : pathOfTexel(slice, at);
      growth = max(growth, lengthOf(vec2(side * step) + there - here));
    }
  }
  return growth;
}

bool growsAt(ivec2 pixel) {
#if HAS_normal
  uint id = texelFetch(id_tex, pixel, 0).x;
  vec3 normal_ws = vec3(texelFetch(normal_tex, pixel, 0));
  if (id == 0u || dot(normal_ws, normal_ws) < 0.5) return false;
  Ray ray = cameraRay(SLICE_CAPTURE, samplePosition(pixel));
  vec3 point_ws = ray.origin + ray.direction * texelFetch(depth_tex, pixel, 0).x;
  float growth = max(growthAt(SLICE_OPEN, pixel, id, point_ws, normal_ws),
                     growthAt(SLICE_CLOSE, pixel, id, point_ws, normal_ws));
  return !(growth <= params.most_growth);
#else
  return false;
#endif
}

void run(ivec2 pixel) {
  vec2 d = vec2(texelFetch(velocity_tex, pixel, 0)), bend = vec2(0);
  bool grows = false;
  if (texelFetch(depth_tex, pixel, 0).x > 0.0 && d != vec2(0)) {
    bend = pathOfTexel(SLICE_SAMPLE, pixel) - 0.5 * (pathOfTexel(SLICE_OPEN, pixel) + pathOfTexel(SLICE_CLOSE, pixel));
    grows = growsAt(pixel);
  }
  bool bent = !(lengthOf(bend) <= params.most_bend) || grows;
  imageStore(bend_img, pixel, vec4(storedVelocity(bend), 0, 0));
  imageStore(bent_img, pixel, vec4(bent ? 1 : 0));
}
