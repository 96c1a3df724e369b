// SPDX-License-Identifier: MIT
// How a layer's paths go on: polynomials of second order through the places of their points at the capture and the two frames
// before it, of third order through those of three, taken over the exposure, wherever that lies. In a loop of the times
// "frames" with as many slices.
// In:  depth, id, hit, normal as path_bend has them; velocity (px over the exposure, from the frame before alone).
// Out: velocity (px between the ends of the curve), curve (px, mixin/curve.glsl), bend (px: how far the curve is from the line
//      between its ends in the middle), bent (1 where an end of the exposure is more than `most_bend` px from where the curve
//      has it, by true poses, or a pixel grows to more than `most_growth` px).
// With the differences of places from frame to frame, D = p0 - p1, of these, D2 = p0 - 2 p1 + p2, and of these, D3, the point
// is f frames after the capture at p0 + f D + f (f + 1) / 2 D2 + f (f + 1) (f + 2) / 6 D3 (Newton).
// Fails: what changes its way after the capture. Poses beyond a cut are none: fewer of them make a lower order, and one alone
// the straight path. What comes back to its pose of the capture in the second or third frame before is taken for cut.
#include "mixin/stored.glsl"
#include "mixin/texel_path.glsl"
#include "mixin/curve.glsl"

const int kPoses = PARAM_trajectory == trajectory_cubic ? 3 : 2;

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

// How many of the poses come before one that stands as the capture does, which is beyond a cut.
int knownPoses(uint id, vec2 places[kPoses]) {
  for (int k = 1; k < kPoses; ++k) {
    uint slice = SLICE_SAMPLE + uint(k);
    bool camera_is_cut = cameraStands(slice) && !cameraStands(slice - 1u);
    bool instance_is_cut = instanceStands(slice, id) && !instanceStands(slice - 1u, id);
    if (camera_is_cut || instance_is_cut || places[k] == vec2(0)) return k;
  }
  return kPoses;
}

struct Differences {
  vec2 first, second, third;  // px per frame, per frame^2, per frame^3
};

Differences differencesOf(vec2 places[kPoses], int known) {
  Differences d = Differences(-places[0], vec2(0), vec2(0));
  if (known > 1) d.second = places[1] - 2.0 * places[0];
#if PARAM_trajectory == trajectory_cubic
  if (known > 2) d.third = 3.0 * (places[1] - places[0]) - places[2];
#endif
  return d;
}

// Px from the capture, so many frames after it.
vec2 placeAt(Differences d, float f) {
  return f * (d.first + 0.5 * (f + 1.0) * (d.second + (f + 2.0) / 3.0 * d.third));
}

vec4 curveOf(Differences d) {
  float exposure = frame.exposure, middle = 0.5 * exposure * (frame.shutter.x + frame.shutter.y);
  vec2 b = -exposure * exposure / 8.0 * (d.second + (1.0 + middle) * d.third);
  return vec4(b, -exposure * exposure * exposure / 48.0 * d.third);
}

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
      int known = places[0] == vec2(0) ? 0 : knownPoses(id, places);
      Differences d = differencesOf(places, known);
      vec2 open = placeAt(d, frame.exposure * frame.shutter.x), close = placeAt(d, frame.exposure * frame.shutter.y);
      vec2 between = close - open;
      if (known > 1 && !any(isnan(between)) && !any(isinf(between))) {
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
