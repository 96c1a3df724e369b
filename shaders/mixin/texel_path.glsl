// SPDX-License-Identifier: MIT
// Needs: depth_tex, id_tex, scene, velocity_tex; may have: PARAM_displacement, hit_tex, normal_tex, params.max_stretch.
// Screen paths of the surface points that the texels of a layer show, computed from the poses of the scene, and the test if the
// surface stretches along these paths.
#ifndef STROBE_TEXEL_PATH_GLSL
#define STROBE_TEXEL_PATH_GLSL
#include "lib/blur.glsl"
#include "mixin/surface.glsl"

// Screen position of a texel's surface point at the time of `slice` minus its position at the raster time, px. Without the read
// `hit`, instances count as rigid.
vec2 pathOfTexel(uint slice, ivec2 at) {
  Ray ray = cameraRay(SLICE_RASTER, samplePosition(at));
  uint id = texelFetch(id_tex, at, 0).x;
  if (id == 0u) return pathOfSky(slice, ray.direction);
  vec3 point_ws = ray.origin + ray.direction * texelFetch(depth_tex, at, 0).x;
#if HAS_hit
  uvec4 ids = texelFetch(hit_tex, at, 0);
  Hit hit = hitOnTriangle(SLICE_RASTER, ray, id - 1u, ids.y, ids.z);
  return pathOf(slice, hit, point_ws);
#else
  return pathOfPoint(slice, id - 1u, point_ws);
#endif
}

// Properties of the motion of an instance, as PATH_* bits (shared/scene.h). `id`: instance + 1, or 0 for the sky. The sky has
// the bits PATH_CURVED and PATH_TURNS, because it follows every rotation of the camera.
uint pathKind(uint id) { return id == 0u ? PATH_CURVED | PATH_TURNS : instanceAt(id - 1u).path; }

// Screen position of a texel's surface point at time t minus its position at the raster time, px. `slice`: slice of the time t.
// `kind`: PATH_* bits of the texel's instance. If the path is straight, the result follows from the displacement, without a
// pose.
vec2 shiftAt(uint slice, float t, ivec2 at, uint kind) {
  if ((kind & PATH_CURVED) != 0u) return pathOfTexel(slice, at);
  return t * vec2(texelFetch(velocity_tex, at, 0));
}

// True if the texel is in the image and shows the instance `id` (instance + 1, or 0 for the sky).
bool isSame(ivec2 at, uint id) { return isInside(at, ivec2(frame.size)) && texelFetch(id_tex, at, 0).x == id; }

// Intersection, in world space, of the camera ray through a texel with the plane through `point_ws` with the normal
// `normal_ws`.
vec3 onPlane(ivec2 at, vec3 point_ws, vec3 normal_ws) {
  Ray ray = cameraRay(SLICE_RASTER, samplePosition(at));
  return ray.origin + ray.direction * (dot(point_ws - ray.origin, normal_ws) / dot(ray.direction, normal_ws));
}

// Offsets to the texel itself and to its four neighbours.
const ivec2 kCross[5] = ivec2[5](ivec2(0), ivec2(-1, 0), ivec2(1, 0), ivec2(0, -1), ivec2(0, 1));

// True if the surface at the pixel stretches so far that filters would leave holes between its texels. The test compares the
// pixel with each of the four neighbours, at 1 px, that shows the object `id` (instance + 1) too. The surface stretches too far
// if such a neighbour's surface point is more than `max_stretch` px away at shutter open or shutter close. If neither neighbour
// along an axis shows the object, for example because its surface is nearly edge-on, a point on the surface's plane replaces
// the neighbour. Always false for the sky, and for passes that do not read `normal`.
// One loop covers both ends of the exposure and all texels, because each inlined copy of the path takes long to compile.
bool growsAt(ivec2 pixel, uint id) {
#if HAS_normal
  vec3 normal_ws = vec3(texelFetch(normal_tex, pixel, 0));
  if (id == 0u || dot(normal_ws, normal_ws) < 0.5) return false;
  uint kind = pathKind(id);
  float stretch = any(equal(frame.shutter, vec2(0))) ? 1.0 : 0.0;
  vec2 here = vec2(0);
  for (int i = 0; i < 10; ++i) {
    bool is_open = i < 5;
    uint slice = is_open ? SLICE_SHUTTER_OPEN : SLICE_SHUTTER_CLOSE;
    float t = is_open ? frame.shutter.x : frame.shutter.y;
    if (t == 0.0) continue;
    ivec2 step = kCross[i % 5], at = pixel + step;
    bool is_beside = step != ivec2(0), same = !is_beside || isSame(at, id);
    bool alone = !same && !isSame(pixel - step, id);
    if (!same && !alone) continue;
    vec2 there;
    if (alone) {
      Ray ray = cameraRay(SLICE_RASTER, samplePosition(pixel));
      vec3 point_ws = ray.origin + ray.direction * texelFetch(depth_tex, pixel, 0).x;
      there = pathOfPoint(slice, id - 1u, onPlane(at, point_ws, normal_ws));
    } else {
      there = shiftAt(slice, t, at, kind);
    }
    if (is_beside) stretch = max(stretch, lengthOf(vec2(step) + there - here));
    else here = there;
  }
  return !(stretch <= params.max_stretch);
#else
  return false;
#endif
}

// True if the layer has a surface at the pixel and this surface moves on the screen. A depth of 0 marks pixels without a
// surface.
bool isMoving(ivec2 pixel) {
  return texelFetch(depth_tex, pixel, 0).x > 0.0 && vec2(texelFetch(velocity_tex, pixel, 0)) != vec2(0);
}

#endif
