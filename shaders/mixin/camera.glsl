// SPDX-License-Identifier: MIT
// Needs: scene.
// Rays through pixels, and projection of points. Pixel coordinates: x right, y down, the first pixel's centre at (0.5, 0.5).
#ifndef STROBE_CAMERA_GLSL
#define STROBE_CAMERA_GLSL
#include "lib/hit.glsl"

// Normalised device coordinates, in [-1, 1] (x right, y up), of a pixel coordinate.
vec2 ndcOf(vec2 position_px) {
  vec2 unit = position_px / vec2(frame.size);
  return vec2(2.0 * unit.x - 1.0, 1.0 - 2.0 * unit.y);
}

// Ray through a pixel coordinate. The parameter t of the ray is the view depth, metres.
Ray cameraRay(uint slice, vec2 position_px) {
  SceneCamera camera = scene_cameras[slice];
  vec2 offset = ndcOf(position_px) * camera.half_extent;
  vec3 sideways = camera.right * offset.x + camera.up * offset.y;
  if (camera.orthographic != 0u) return Ray(camera.position + sideways, camera.forward);
  return Ray(camera.position, camera.forward + sideways);
}

// True if a moving surface may be visible at the pixel at the time of the slice. Conservative: also true for some other pixels.
bool isReachedAt(uint slice, ivec2 pixel) {
  ivec4 area = scene_cameras[slice].moving;
  return all(greaterThanEqual(pixel, area.xy)) && all(lessThan(pixel, area.zw));
}

// Sample position of a pixel in this frame, pixel coordinate.
vec2 samplePosition(ivec2 pixel) { return vec2(pixel) + 0.5 + frame.subpixel; }

// The functions below compute with `precise`. Without it, a device may contract a product and a difference to one rounding at
// one end of a path and not at the other. Static points would then move by some millionths of a pixel.

// Position in view space of a world position: x right, y up, z the view depth (positive in front).
vec3 viewFromWorld(uint slice, vec3 position_ws) {
  SceneCamera camera = scene_cameras[slice];
  vec3 offset = position_ws - camera.position;
  precise vec3 position_vs = vec3(dot(offset, camera.right), dot(offset, camera.up), dot(offset, camera.forward));
  return position_vs;
}

// Pixel coordinate of a point in view space.
vec2 pixelFromView(uint slice, vec3 position_vs) {
  SceneCamera camera = scene_cameras[slice];
  float scale = camera.orthographic != 0u ? 1.0 : position_vs.z;
  precise vec2 ndc = position_vs.xy / (scale * camera.half_extent);
  precise vec2 position_px = vec2(0.5 + 0.5 * ndc.x, 0.5 - 0.5 * ndc.y) * vec2(frame.size);
  return position_px;
}

// True if this invocation has extrapolated a path from the near plane.
bool met_near_plane = false;

// Screen offset of a point from the raster time to the time of `slice`, px. `raster_vs`, `other_vs`: positions of the point in
// view space at these two times. If the point passes behind the near plane on the way, the path up to that plane is
// extrapolated to its full length. The projection therefore never divides by a depth <= 0.
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

vec2 pathFromRasterTime(vec3 raster_vs, uint slice, vec3 other_vs) {
  return pathFromRasterTime(raster_vs, slice, other_vs, scene_cameras[slice].near * 1.001);
}

#endif
