// SPDX-License-Identifier: MIT
// Needs: scene.
// Rays through pixels, and projection of points to pixels, for the camera at any slice (the scene posed at one time,
// shared/scene.h). In pixel coordinates, x points right, y points down, and the first pixel's centre is at (0.5, 0.5).
#ifndef STROBE_CAMERA_GLSL
#define STROBE_CAMERA_GLSL
#include "lib/hit.glsl"

// Normalised device coordinates of a position in pixel coordinates: x right, y up, [-1, 1] over the image.
vec2 ndcOf(vec2 position_px) {
  vec2 unit = position_px / vec2(frame.size);
  return vec2(2.0 * unit.x - 1.0, 1.0 - 2.0 * unit.y);
}

// Ray of the camera at `slice` through a position in pixel coordinates; world space. The direction is not of unit length: it is
// scaled so that the ray's parameter t is the view depth, metres.
Ray cameraRay(uint slice, vec2 position_px) {
  SceneCamera camera = scene_cameras[slice];
  vec2 offset = ndcOf(position_px) * camera.half_extent;
  vec3 sideways = camera.right * offset.x + camera.up * offset.y;
  if (camera.orthographic != 0u) return Ray(camera.position + sideways, camera.forward);
  return Ray(camera.position, camera.forward + sideways);
}

// True if a moving surface may be visible at the pixel at the time of `slice`. Conservative: also true at some pixels that show
// only static surfaces.
bool isReachedAt(uint slice, ivec2 pixel) {
  ivec4 area = scene_cameras[slice].moving;
  return all(greaterThanEqual(pixel, area.xy)) && all(lessThan(pixel, area.zw));
}

// Position of the pixel that this frame samples: the pixel's centre plus `frame.subpixel`, in pixel coordinates.
vec2 samplePosition(ivec2 pixel) { return vec2(pixel) + 0.5 + frame.subpixel; }

// The functions below declare their results `precise`. Otherwise a compiler may fuse a product and a sum, which rounds once
// instead of twice, at one end of a path but not at the other. Static points would then move by some millionths of a pixel.

// Position of a world position in the view space of the camera at `slice`: x right, y up, z the view depth (positive in front
// of the camera), metres.
vec3 viewFromWorld(uint slice, vec3 position_ws) {
  SceneCamera camera = scene_cameras[slice];
  vec3 offset = position_ws - camera.position;
  precise vec3 position_vs = vec3(dot(offset, camera.right), dot(offset, camera.up), dot(offset, camera.forward));
  return position_vs;
}

// Pixel coordinates of a point in view space. The point may project outside of the image. With a perspective camera, the depth
// position_vs.z must not be 0.
vec2 pixelFromView(uint slice, vec3 position_vs) {
  SceneCamera camera = scene_cameras[slice];
  float scale = camera.orthographic != 0u ? 1.0 : position_vs.z;
  precise vec2 ndc = position_vs.xy / (scale * camera.half_extent);
  precise vec2 position_px = vec2(0.5 + 0.5 * ndc.x, 0.5 - 0.5 * ndc.y) * vec2(frame.size);
  return position_px;
}

// Set to true by `pathFromRasterTime` if a path of this invocation crosses the near plane and was therefore extrapolated.
bool met_near_plane = false;

// Screen position of a point at the time of `slice` minus its screen position at the raster time, px. `raster_vs`, `other_vs`:
// view-space positions of the point at the raster time and at the time of `slice`; `raster_vs` must be in front of the camera.
// `near`: view depth of the near plane, metres. A perspective projection cannot place a point that passes behind the near
// plane. The part of the path up to that plane is then extended linearly to the whole path, so that no depth <= 0 is a
// divisor.
vec2 pathFromRasterTime(vec3 raster_vs, uint slice, vec3 other_vs, float near) {
  vec2 start = pixelFromView(SLICE_RASTER, raster_vs);
  bool in_front = scene_cameras[slice].orthographic != 0u || other_vs.z >= near || raster_vs.z <= near;
  if (in_front) {
    if (scene_cameras[slice].orthographic == 0u) other_vs.z = max(other_vs.z, near);
    precise vec2 path = pixelFromView(slice, other_vs) - start;
    return path;
  }
  met_near_plane = true;
  float s = (raster_vs.z - near) / (raster_vs.z - other_vs.z);
  return (pixelFromView(slice, mix(raster_vs, other_vs, s)) - start) / s;
}

// Screen offset of a point of the scene, as in the function above. The near plane is at the camera's near distance at
// `slice`, enlarged by a thousandth.
vec2 pathFromRasterTime(vec3 raster_vs, uint slice, vec3 other_vs) {
  return pathFromRasterTime(raster_vs, slice, other_vs, scene_cameras[slice].near * 1.001);
}

#endif
