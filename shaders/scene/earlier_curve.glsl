// SPDX-License-Identifier: MIT
// Extrapolated curves of a layer: parabolas through the places of its points at the raster time and in the two frames before,
// taken over the exposure. In a loop of the times "frames" with two slices.
// In:  depth, id, hit, normal as path_bend has them; velocity (px over the exposure, from the frame before alone).
// Out: velocity (px between the ends of the curve), curve (px, mixin/curve.glsl), bend (px: how far the curve is from the line
//      between its ends in the middle), bent (1 where an end of the exposure is more than `most_bend` px from where the curve
//      has it, by true poses, or a pixel grows to more than `most_growth` px).
// Method (Newton): with D = p0 - p1 and D2 = p0 - 2 p1 + p2, the point is at p0 + f D + f (f + 1) / 2 D2, f frames after the
// capture. Poses beyond a cut do not count: one earlier pose gives a straight path.
// Fails: objects that change direction after the capture. An object whose pose of two frames before equals its pose of the
// capture is taken for cut.
#include "mixin/stored.glsl"
#include "mixin/texel_path.glsl"
#include "mixin/curve.glsl"

const int kPoses = 2;

bool cameraStands(uint slice) {
  SceneCamera then = scene_cameras[slice], now = scene_cameras[SLICE_CAPTURE];
  return then.position == now.position && then.forward == now.forward && then.right == now.right &&
         then.half_extent == now.half_extent;
}

bool instanceStands(uint slice, uint id) {
  if (id == 0u) return true;
  SceneTransform then = transformOf(slice, id - 1u), now = transformOf(SLICE_CAPTURE, id - 1u);
  return then.row_x == now.row_x && then.row_y == now.row_y && then.row_z == now.row_z;
}

// True if a cut lies between the two frames before the raster time: the older pose then equals the pose at the raster time.
bool isSecondPoseCut(uint id) {
  uint slice = SLICE_SAMPLE + 1u;
  bool camera_is_cut = cameraStands(slice) && !cameraStands(slice - 1u);
  return camera_is_cut || (instanceStands(slice, id) && !instanceStands(slice - 1u, id));
}

struct Differences {
  vec2 first, second;  // px per frame, per frame^2
};

// False if the path has fewer than two poses before the capture.
bool hasDifferences(uint id, vec2 places[kPoses]) {
  return places[0] != vec2(0) && places[1] != vec2(0) && !isSecondPoseCut(id);
}

Differences differencesOf(vec2 places[kPoses], bool is_curved) {
  return Differences(-places[0], is_curved ? places[1] - 2.0 * places[0] : vec2(0));
}

// Place f frames after the capture, px from that at the capture.
vec2 placeAt(Differences d, float f) { return f * (d.first + 0.5 * (f + 1.0) * d.second); }

vec4 curveOf(Differences d) { return vec4(-frame.exposure * frame.exposure / 8.0 * d.second, 0, 0); }

void run(ivec2 pixel) {
  uint id = texelFetch(id_tex, pixel, 0).x, kind = pathKind(id);
  vec2 velocity = vec2(texelFetch(velocity_tex, pixel, 0));
  vec4 curve = vec4(0);
  float off_px = 0.0;
  bool grows = false;
  bool is_curved = (kind & PATH_CURVED) != 0u && texelFetch(depth_tex, pixel, 0).x > 0.0;
  if (is_curved || isMoving(pixel)) {
    if (is_curved) {
      vec2 places[kPoses];
      for (int k = 0; k < kPoses; ++k) places[k] = pathOfTexel(SLICE_SAMPLE + uint(k), pixel);
      bool has_differences = hasDifferences(id, places);
      Differences d = differencesOf(places, has_differences);
      vec2 open = placeAt(d, frame.exposure * frame.shutter.x), close = placeAt(d, frame.exposure * frame.shutter.y);
      vec2 between = close - open;
      if (has_differences && !any(isnan(between)) && !any(isinf(between))) {
        velocity = storedVelocity(between);
        curve = curveOf(d);
      }
      off_px = max(lengthOf(open - pathOfTexel(SLICE_OPEN, pixel)), lengthOf(close - pathOfTexel(SLICE_CLOSE, pixel)));
    }
    if ((kind & PATH_TURNS) != 0u) grows = growsAt(pixel, id);
  }
  imageStore(velocity_img, pixel, vec4(velocity, 0, 0));
  imageStore(curve_img, pixel, curve);
  imageStore(bend_img, pixel, vec4(storedVelocity(curve.xy), 0, 0));
  imageStore(bent_img, pixel, vec4(!(off_px <= params.most_bend) || grows ? 1 : 0));
}
