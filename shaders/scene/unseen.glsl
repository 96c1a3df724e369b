// SPDX-License-Identifier: MIT
// What an end of the exposure sees that neither the capture nor rays from it have found: what faces the camera only then,
// is outside of the picture at the capture, or behind more than one surface. Node time: that end, in a loop whose one time is
// the middle of the exposure.
// In:  hit (of that end); depth, id of what raster saw at the capture; revealed_depth, revealed_id, revealed_valid.
// Out: unseen (1: neither has it), velocity (px over the exposure, of what that end sees), bend (px in the middle of the
//      exposure: how far its path is from the line between its ends).
#include "lib/blur.glsl"
#include "mixin/stored.glsl"
#include "mixin/surface.glsl"

// Is a surface of this id and depth among the four texels around a place? In that layer or the one behind.
bool isHeld(vec2 position_px, uint id, float depth) {
  ivec2 size = ivec2(frame.size), first = ivec2(floor(position_px - 0.5));
  for (int k = 0; k < 4; ++k) {
    ivec2 at = first + ivec2(k & 1, k >> 1);
    if (!isInside(at, size)) continue;
    if (texelFetch(id_tex, at, 0).x == id && relativeGap(texelFetch(depth_tex, at, 0).x, depth) <= params.same_depth)
      return true;
    bool behind = texelFetch(revealed_valid_tex, at, 0).x > 0.5 && texelFetch(revealed_id_tex, at, 0).x == id;
    if (behind && relativeGap(texelFetch(revealed_depth_tex, at, 0).x, depth) <= params.same_depth) return true;
  }
  return false;
}

// How far a path is from the line between its ends in the middle of the exposure, px; `path` is from the capture.
vec2 bendOf(vec2 to_open, vec2 to_middle, vec2 to_close) { return to_middle - 0.5 * (to_open + to_close); }

void run(ivec2 pixel) {
  uvec4 seen = texelFetch(hit_tex, pixel, 0);
  Ray ray = cameraRay(TIME_SLICE, samplePosition(pixel));
  bool held;
  vec2 velocity, bend;
  if (seen.x == 0u) {
    velocity = displacementOfSky(ray.direction);
    held = isHeld(vec2(pixel) + 0.5 - pathOfSky(TIME_SLICE, ray.direction), 0u, uintBitsToFloat(0x7f800000u));
    bend = bendOf(pathOfSky(SLICE_OPEN, ray.direction), pathOfSky(SLICE_SAMPLE, ray.direction),
                  pathOfSky(SLICE_CLOSE, ray.direction));
  } else {
    Hit hit = hitOnTriangle(TIME_SLICE, ray, seen.x - 1u, seen.y, seen.z);
    vec3 capture_ws = positionOf(SLICE_CAPTURE, hit);
    vec3 capture_vs = viewFromWorld(SLICE_CAPTURE, capture_ws);
    velocity = displacementOf(hit, capture_ws);
    bool in_front = scene_cameras[SLICE_CAPTURE].orthographic != 0u || capture_vs.z > scene_cameras[SLICE_CAPTURE].near;
    held = in_front && isHeld(pixelFromView(SLICE_CAPTURE, capture_vs) - frame.subpixel, seen.x, capture_vs.z);
    bend = bendOf(pathOf(SLICE_OPEN, hit, capture_ws), pathOf(SLICE_SAMPLE, hit, capture_ws),
                  pathOf(SLICE_CLOSE, hit, capture_ws));
  }
  imageStore(unseen_img, pixel, vec4(held ? 0 : 1));
  imageStore(velocity_img, pixel, vec4(storedVelocity(velocity), 0, 0));
  imageStore(bend_img, pixel, vec4(storedVelocity(bend), 0, 0));
}
