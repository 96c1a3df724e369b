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

// How an instance goes over the picture; the sky as the camera does.
uint pathKind(uint id) { return id == 0u ? PATH_CURVED | PATH_TURNS : scene_instances[id - 1u].path; }

// Of a texel of what is not curved its displacement says all.
vec2 shiftAt(uint slice, float t, ivec2 at, uint kind) {
  if ((kind & PATH_CURVED) != 0u) return pathOfTexel(slice, at);
  return t * vec2(texelFetch(velocity_tex, at, 0));
}

bool isSame(ivec2 at, uint id) { return isInside(at, ivec2(frame.size)) && texelFetch(id_tex, at, 0).x == id; }

// Where the ray through a texel meets the plane of a surface.
vec3 onPlane(ivec2 at, vec3 point_ws, vec3 normal_ws) {
  Ray ray = cameraRay(SLICE_CAPTURE, samplePosition(at));
  return ray.origin + ray.direction * (dot(point_ws - ray.origin, normal_ws) / dot(ray.direction, normal_ws));
}

// Length at `slice`, which is at the time t, px, of the longest way to the texels beside, of the same object. Where there
// is none along an axis, the object is turned away: the surface's plane says where they would be.
float growthAt(uint slice, float t, ivec2 pixel, uint id, vec3 normal_ws) {
  if (t == 0.0) return 1.0;
  uint kind = pathKind(id);
  vec2 here = shiftAt(slice, t, pixel, kind);
  float growth = 0.0;
  for (int axis = 0; axis < 2; ++axis) {
    ivec2 step = axis == 0 ? ivec2(1, 0) : ivec2(0, 1);
    bool alone = !isSame(pixel + step, id) && !isSame(pixel - step, id);
    for (int side = -1; side <= 1; side += 2) {
      ivec2 at = pixel + side * step;
      if (!alone && !isSame(at, id)) continue;
      vec2 there;
      if (alone) {
        Ray ray = cameraRay(SLICE_CAPTURE, samplePosition(pixel));
        vec3 point_ws = ray.origin + ray.direction * texelFetch(depth_tex, pixel, 0).x;
        there = pathOfPoint(slice, id - 1u, onPlane(at, point_ws, normal_ws));
      } else {
        there = shiftAt(slice, t, at, kind);
      }
      growth = max(growth, lengthOf(vec2(side * step) + there - here));
    }
  }
  return growth;
}

bool growsAt(ivec2 pixel, uint id) {
#if HAS_normal
  vec3 normal_ws = vec3(texelFetch(normal_tex, pixel, 0));
  if (id == 0u || dot(normal_ws, normal_ws) < 0.5) return false;
  float growth = max(growthAt(SLICE_OPEN, frame.shutter.x, pixel, id, normal_ws),
                     growthAt(SLICE_CLOSE, frame.shutter.y, pixel, id, normal_ws));
  return !(growth <= params.most_growth);
#else
  return false;
#endif
}

// How far the path of what a texel shows is from the line between its ends, in its middle.
vec2 bendAt(ivec2 pixel) {
  vec2 bend = pathOfTexel(SLICE_SAMPLE, pixel);
  if (frame.shutter.x != 0.0) bend -= 0.5 * pathOfTexel(SLICE_OPEN, pixel);
  if (frame.shutter.y != 0.0) bend -= 0.5 * pathOfTexel(SLICE_CLOSE, pixel);
  return bend;
}

void run(ivec2 pixel) {
  uint id = texelFetch(id_tex, pixel, 0).x, kind = pathKind(id);
  vec2 bend = vec2(0);
  bool grows = false;
  if (texelFetch(depth_tex, pixel, 0).x > 0.0 && vec2(texelFetch(velocity_tex, pixel, 0)) != vec2(0)) {
    if ((kind & PATH_CURVED) != 0u) bend = bendAt(pixel);
    if ((kind & PATH_TURNS) != 0u) grows = growsAt(pixel, id);
  }
  bool bent = !(lengthOf(bend) <= params.most_bend) || grows;
  imageStore(bend_img, pixel, vec4(storedVelocity(bend), 0, 0));
  imageStore(bent_img, pixel, vec4(bent ? 1 : 0));
}
