// SPDX-License-Identifier: MIT
// Moving surfaces that are visible at one end of the exposure (shutter open or shutter close), but are in neither layer of the
// raster time. At the raster time they face away, lie outside the image, or lie behind more than one surface.
// In:  `hit`: surface visible at that end: instance + 1, geometry, primitive; 0 for the sky and, for a static camera, for
//        static surfaces
//      `depth`, `revealed_depth`: view depth of the raster layer and the revealed layer, metres; +inf for the sky
//      `id`, `revealed_id`: instance + 1 of both layers; 0 for the sky
//      `revealed_valid`: above 1/2 where the revealed layer has a surface
// Out: `disoccluded`: 1 if neither layer has the surface that the pixel shows at that end
//      `velocity`: displacement of this surface, px over the exposure
//      `path_deviation`: path deviation of this surface in the middle of the exposure, px
// Method: the pass runs at the time of that end, in a loop with a single time, the middle of the exposure. Project the hit
//   point to its position at the raster time. Search the four texels around that position in both layers for the id of the
//   point and its depth (within the share `same_depth`). Skip points that do not move on the screen: only their own pixel shows
//   them, and if no layer has the point, the samples of that pixel are unresolved anyway.
// Fails: misses a surface that appears and disappears again between the ends of the exposure.
#include "lib/blur.glsl"
#include "mixin/quantised.glsl"
#include "mixin/surface.glsl"

// True if one of the four texels around a position shows a surface with this id and depth, in the raster or the revealed layer.
bool hasSurface(vec2 position_px, uint id, float depth) {
  ivec2 size = ivec2(frame.size), first = ivec2(floor(position_px - 0.5));
  for (int k = 0; k < 4; ++k) {
    ivec2 at = first + ivec2(k & 1, k >> 1);
    if (!isInside(at, size)) continue;
    if (texelFetch(id_tex, at, 0).x == id && relativeGap(texelFetch(depth_tex, at, 0).x, depth) <= params.same_depth)
      return true;
    bool background = texelFetch(revealed_valid_tex, at, 0).x > 0.5 && texelFetch(revealed_id_tex, at, 0).x == id;
    if (background && relativeGap(texelFetch(revealed_depth_tex, at, 0).x, depth) <= params.same_depth) return true;
  }
  return false;
}

// Path deviation in the middle of the exposure, px. The arguments are offsets of the surface from its position at the raster
// time, at shutter open, in the middle and at shutter close, px.
vec2 deviationOf(vec2 to_open, vec2 to_middle, vec2 to_close) { return to_middle - 0.5 * (to_open + to_close); }

// True if `id` (instance + 1) is a static instance that is nearer at the pixel (`depth_there`) than `depth`; view depths,
// metres.
bool isHiding(ivec2 pixel, uint id, float depth_there, float depth) {
  return id != 0u && instanceAt(id - 1u).moves == 0u && depth_there < depth;
}

// True if a static surface hides a surface at the view depth `depth` at the pixel, for a static camera. The input `hit` omits
// static surfaces, so the layers provide them.
bool isHidden(ivec2 pixel, float depth) {
  if (frame.camera_rests == 0u) return false;
  if (isHiding(pixel, texelFetch(id_tex, pixel, 0).x, texelFetch(depth_tex, pixel, 0).x, depth)) return true;
  return texelFetch(revealed_valid_tex, pixel, 0).x > 0.5 &&
         isHiding(pixel, texelFetch(revealed_id_tex, pixel, 0).x, texelFetch(revealed_depth_tex, pixel, 0).x, depth);
}

// Result for the surface that a pixel shows at the tested end of the exposure: shutter open or shutter close, the time of the
// pass.
struct Disoccluded {
  bool is_so;  // the surface is in neither layer
  vec2 velocity, path_deviation;
};

// Result for a pixel that shows the sky at the tested end of the exposure. The sky moves with the rotation of the camera.
// `ray`: ray through the pixel at that time.
Disoccluded disoccludedSky(ivec2 pixel, Ray ray) {
  vec2 velocity = displacementOfSky(ray.direction);
  if (velocity == vec2(0)) return Disoccluded(false, vec2(0), vec2(0));
  bool has_surface = hasSurface(vec2(pixel) + 0.5 - pathOfSky(TIME_SLICE, ray.direction), 0u, uintBitsToFloat(0x7f800000u));
  vec2 path_deviation = deviationOf(pathOfSky(SLICE_SHUTTER_OPEN, ray.direction), pathOfSky(SLICE_SAMPLE, ray.direction),
                     pathOfSky(SLICE_SHUTTER_CLOSE, ray.direction));
  return Disoccluded(!has_surface, velocity, path_deviation);
}

// Result for a pixel that shows the surface `hit` at the tested end of the exposure. A surface that does not move on the screen
// or that a static surface hides is not disoccluded.
Disoccluded disoccludedSurface(ivec2 pixel, Hit hit) {
  if ((instanceAt(hit.instance).path & PATH_MAY_APPEAR) == 0u) return Disoccluded(false, vec2(0), vec2(0));
  vec3 raster_ws = positionOf(SLICE_RASTER, hit);
  vec2 velocity = displacementOf(hit, raster_ws);
  if (velocity == vec2(0) || isHidden(pixel, hit.t)) return Disoccluded(false, vec2(0), vec2(0));
  vec3 raster_vs = viewFromWorld(SLICE_RASTER, raster_ws);
  bool in_front = scene_cameras[SLICE_RASTER].orthographic != 0u || raster_vs.z > scene_cameras[SLICE_RASTER].near;
  bool has_surface =
      in_front && hasSurface(pixelFromView(SLICE_RASTER, raster_vs) - frame.subpixel, hit.instance + 1u, raster_vs.z);
  vec2 path_deviation = deviationOf(pathOf(SLICE_SHUTTER_OPEN, hit, raster_ws), pathOf(SLICE_SAMPLE, hit, raster_ws),
                     pathOf(SLICE_SHUTTER_CLOSE, hit, raster_ws));
  return Disoccluded(!has_surface, velocity, path_deviation);
}

void run(ivec2 pixel) {
  uvec4 ids = texelFetch(hit_tex, pixel, 0);
  if (ids.x == 0u && frame.camera_rests != 0u) return;
  Ray ray = cameraRay(TIME_SLICE, samplePosition(pixel));
  Disoccluded disoccluded;
  if (ids.x == 0u) disoccluded = disoccludedSky(pixel, ray);
  else disoccluded = disoccludedSurface(pixel, hitOnTriangle(TIME_SLICE, ray, ids.x - 1u, ids.y, ids.z));
  if (disoccluded.is_so) imageStore(disoccluded_img, pixel, vec4(1));
  if (disoccluded.velocity == vec2(0)) return;
  imageStore(velocity_img, pixel, vec4(quantisedVelocity(disoccluded.velocity), 0, 0));
  imageStore(path_deviation_img, pixel, vec4(quantisedVelocity(disoccluded.path_deviation), 0, 0));
}
