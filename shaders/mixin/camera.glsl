// SPDX-License-Identifier: MIT
// Needs: scene.
// Pixels to rays and points to pixels. Pixel coordinates: x right, y down, the first pixel's centre at (0.5, 0.5).
#ifndef STROBE_CAMERA_GLSL
#define STROBE_CAMERA_GLSL
#include "lib/hit.glsl"

// Position in [-1, 1] (x right, y up) of a pixel coordinate.
vec2 ndcOf(vec2 position_px) {
  vec2 unit = position_px / vec2(frame.size);
  return vec2(2.0 * unit.x - 1.0, 1.0 - 2.0 * unit.y);
}

// The ray through a pixel coordinate; its parameter is the view depth in metres.
Ray cameraRay(uint slice, vec2 position_px) {
  SceneCamera camera = scene_cameras[slice];
  vec2 offset = ndcOf(position_px) * camera.half_extent;
  vec3 sideways = camera.right * offset.x + camera.up * offset.y;
  if (camera.orthographic != 0u) return Ray(camera.position + sideways, camera.forward);
  return Ray(camera.position, camera.forward + sideways);
}

// Can anything that moves be seen in a pixel at that time?
bool isReachedAt(uint slice, ivec2 pixel) {
  ivec4 area = scene_cameras[slice].moving;
  return all(greaterThanEqual(pixel, area.xy)) && all(lessThan(pixel, area.zw));
}

// The sample position of a pixel of this frame.
vec2 samplePosition(ivec2 pixel) { return vec2(pixel) + 0.5 + frame.subpixel; }

// From here on `precise`: a device that contracts a product and a difference to one rounding may do so at one end of a path
// and not at the other, and then what stands still moves by some millionths of a pixel.

// View space: x right, y up, z the view depth (positive in front).
vec3 viewFromWorld(uint slice, vec3 position_ws) {
  SceneCamera camera = scene_cameras[slice];
  vec3 offset = position_ws - camera.position;
  precise vec3 position_vs = vec3(dot(offset, camera.right), dot(offset, camera.up), dot(offset, camera.forward));
  return position_vs;
}

vec2 pixelFromView(uint slice, vec3 position_vs) {
  SceneCamera camera = scene_cameras[slice];
  float scale = camera.orthographic != 0u ? 1.0 : position_vs.z;
  precise vec2 ndc = position_vs.xy / (scale * camera.half_extent);
  precise vec2 position_px = vec2(0.5 + 0.5 * ndc.x, 0.5 - 0.5 * ndc.y) * vec2(frame.size);
  return position_px;
}

// Has this invocation extrapolated a path from the near plane?
bool met_near_plane = false;

// Screen displacement, px, from a point at the capture to the same point at another slice. Where it passes behind the
// near plane on the way, the path up to there is extrapolated to its full length: the divide never sees depths <= 0.
vec2 pathFromCapture(vec3 capture_vs, uint slice, vec3 other_vs, float near) {
  vec2 start = pixelFromView(SLICE_CAPTURE, capture_vs);
  bool in_front = scene_cameras[slice].orthographic != 0u || other_vs.z >= near || capture_vs.z <= near;
  if (in_front) {
    if (scene_cameras[slice].orthographic == 0u) other_vs.z = max(other_vs.z, near);
    precise vec2 path = pixelFromView(slice, other_vs) - start;
    return path;
  }
  met_near_plane = true;
  float s = (capture_vs.z - near) / (capture_vs.z - other_vs.z);
  return (pixelFromView(slice, mix(capture_vs, other_vs, s)) - start) / s;
}

vec2 pathFromCapture(vec3 capture_vs, uint slice, vec3 other_vs) {
  return pathFromCapture(capture_vs, slice, other_vs, scene_cameras[slice].near * 1.001);
}

#endif
