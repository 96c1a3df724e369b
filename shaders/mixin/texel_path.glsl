// SPDX-License-Identifier: MIT
// Needs: depth_tex, id_tex, scene; may have: PARAM_displacement, hit_tex.
// Screen paths of the surface points that the texels of a layer show, computed from the poses of the scene.
#ifndef STROBE_TEXEL_PATH_GLSL
#define STROBE_TEXEL_PATH_GLSL
#include "lib/blur.glsl"
#include "mixin/surface.glsl"

// Screen position of a texel's surface point at the time of `slice` minus its position at the raster time, px. If the
// pass does not read `hit`, instances count as rigid.
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

// True if the path of the texel's surface point may deviate from a straight line. `id`: instance + 1; 0 for the sky.
// True for the sky, because a rotation of the camera moves the sky on curved paths over the screen. False where the
// layer is empty: there the depth is 0 (the depth of the sky is +inf).
bool isCurvedAt(ivec2 at, uint id) {
  bool may_curve = id == 0u || (instanceAt(id - 1u).path & PATH_CURVED) != 0u;
  return may_curve && texelFetch(depth_tex, at, 0).x > 0.0;
}

#endif
