// SPDX-License-Identifier: MIT
// Extrapolates the paths of a layer's points as parabolas through their screen positions at the raster time and in the two
// frames before it.
// In:  `depth`: view depth, metres; +inf for the sky, 0 where the layer has no surface
//      `id`: instance + 1; 0 for the sky
//      `velocity`: displacement computed from the previous frame alone, px over the exposure
//      `hit`: instance + 1, geometry, primitive; absent: deformation by joints and morph targets is ignored
// Out: `velocity`: displacement between the ends of the curve, px; for a straight path the input `velocity`
//      `curve`: coefficients of the curve, px (mixin/curve.glsl)
// Method: Newton's backward differences of the position p0 at the raster time, p1 one frame before and p2 two frames before.
//   A loop of the shader over two times reads p1 and p2. With D = p0 - p1 and D2 = p0 - 2 p1 + p2, the point is at p0 + f D + f (f + 1) / 2 D2, f frames after
//   the raster time. Poses beyond a cut are ignored. If only one earlier pose remains, the path is straight.
// Fails: objects that change direction after the raster time have wrong paths. If the pose of an object two frames before the
//   raster time equals its pose at the raster time, but the pose one frame before differs, a cut between the two earlier
//   frames is assumed and the path is straight.
#include "mixin/quantised.glsl"
#include "mixin/texel_path.glsl"
#include "mixin/curve.glsl"

const int kPoses = 2;

// True if the pose of the camera at `slice` equals its pose at the raster time.
bool cameraHasRasterPose(uint slice) {
  SceneCamera then = scene_cameras[slice], now = scene_cameras[SLICE_RASTER];
  return then.position == now.position && then.forward == now.forward && then.right == now.right &&
         then.half_extent == now.half_extent;
}

// True if the pose of an instance (`id`: instance + 1) at `slice` equals its pose at the raster time.
bool instanceHasRasterPose(uint slice, uint id) {
  if (id == 0u) return true;
  SceneTransform then = transformOf(slice, id - 1u), now = transformOf(SLICE_RASTER, id - 1u);
  return then.row_x == now.row_x && then.row_y == now.row_y && then.row_z == now.row_z;
}

// True if a cut seems to lie between the two frames before the raster time. The runtime replaces poses beyond a cut by the pose
// of the raster time. The test is therefore that the older of the two poses equals the pose of the raster time, and the newer
// one does not.
bool isSecondPoseCut(uint id) {
  uint slice = SLICE_SAMPLE + 1u;
  bool camera_is_cut = cameraHasRasterPose(slice) && !cameraHasRasterPose(slice - 1u);
  return camera_is_cut || (instanceHasRasterPose(slice, id) && !instanceHasRasterPose(slice - 1u, id));
}

// Backward differences D and D2 of the positions of a point.
struct Differences {
  vec2 first, second;  // D: velocity, px per frame; D2: acceleration, px per frame^2
};

// True if the path can be curved: both earlier positions differ from the position at the raster time, and no cut lies between
// them. `places`: earlier positions relative to the raster time, px. A point that did not move in the last frame keeps a
// straight path.
bool hasDifferences(uint id, vec2 places[kPoses]) {
  return places[0] != vec2(0) && places[1] != vec2(0) && !isSecondPoseCut(id);
}

Differences differencesOf(vec2 places[kPoses], bool is_curved) {
  return Differences(-places[0], is_curved ? places[1] - 2.0 * places[0] : vec2(0));
}

// Position f frames after the raster time, px, relative to the position at the raster time.
vec2 placeAt(Differences d, float f) { return f * (d.first + 0.5 * (f + 1.0) * d.second); }

// Coefficients of the parabola for mixin/curve.glsl: deviation of the parabola from its chord in the middle of the exposure,
// px. The deviation is -(D2 / 2) (exposure / 2)^2. D2 is the second difference of the position, `d.second`, px per frame^2, and
// the exposure is in frames.
vec4 curveOf(Differences d) { return vec4(-frame.exposure * frame.exposure / 8.0 * d.second, 0, 0); }

void run(ivec2 pixel) {
  uint id = texelFetch(id_tex, pixel, 0).x;
  vec2 velocity = vec2(texelFetch(velocity_tex, pixel, 0));
  vec4 curve = vec4(0);
  if (isCurvedAt(pixel, id)) {
    vec2 places[kPoses];
    for (int k = 0; k < kPoses; ++k) places[k] = pathOfTexel(SLICE_SAMPLE + uint(k), pixel);
    bool has_differences = hasDifferences(id, places);
    Differences d = differencesOf(places, has_differences);
    vec2 open = placeAt(d, frame.exposure * frame.shutter.x), close = placeAt(d, frame.exposure * frame.shutter.y);
    vec2 between = close - open;
    if (has_differences && !any(isnan(between)) && !any(isinf(between))) {
      velocity = quantisedVelocity(between);
      curve = curveOf(d);
    }
  }
  imageStore(velocity_img, pixel, vec4(velocity, 0, 0));
  imageStore(curve_img, pixel, curve);
}
