// SPDX-License-Identifier: MIT
// By how much the view depth of what a layer shows changes within the exposure. That of a point which moves in a straight line
// at an even pace changes evenly, before any camera that does not turn: two numbers say all, with no divide by depths.
// In:  depth (view depth, m, sky +inf, 0 where the layer has nothing) of the layer, at its own time: the capture or an end
//      of the exposure; hit (instance + 1, geometry, primitive), or of a layer of the capture id (instance + 1) alone.
// Out: change (m over the exposure: what is at z is at z + change.x t for t < 0 and at z + change.y t for t > 0, t in
//      exposures from the layer's own time). Where the exposure has one of the parts only both are that part's. With
//      `displacement` = extrapolated both are the change since the frame before the capture. Behind the near plane, and
//      behind the camera, the numbers mean the same.
// Fails: what turns, or what a turning camera sees, within one part; what bends, where `hit` is absent: it is taken to keep
//      its depth.
#include "mixin/surface.glsl"

// Changes by less than this share of the depth are rounding, of poses seen from an angle.
const float kRounding = 1.0 / 1048576.0;

// The time at which the layer has things where they are, exposures from the capture.
float ownTime() {
  if (TIME_SLICE == SLICE_CAPTURE) return 0.0;
  return TIME_SLICE == SLICE_OPEN ? frame.shutter.x : frame.shutter.y;
}

#if HAS_hit
struct Point {
  Hit hit;
  vec3 capture_ws;
};

Point pointAt(ivec2 pixel, float depth) {
  Ray ray = cameraRay(TIME_SLICE, samplePosition(pixel));
  uvec4 seen = texelFetch(hit_tex, pixel, 0);
  Hit hit = hitOnTriangle(TIME_SLICE, ray, seen.x - 1u, seen.y, seen.z);
  bool at_capture = TIME_SLICE == SLICE_CAPTURE;
  return Point(hit, at_capture ? ray.origin + ray.direction * depth : positionOf(SLICE_CAPTURE, hit));
}

vec3 positionIn(uint slice, Point point) { return movedTo(slice, point.hit, point.capture_ws); }

bool isSky(ivec2 pixel) { return texelFetch(hit_tex, pixel, 0).x == 0u; }
#elif HAS_id
struct Point {
  uint instance;
  vec3 capture_ws;
};

Point pointAt(ivec2 pixel, float depth) {
  Ray ray = cameraRay(SLICE_CAPTURE, samplePosition(pixel));
  return Point(texelFetch(id_tex, pixel, 0).x - 1u, ray.origin + ray.direction * depth);
}

vec3 positionIn(uint slice, Point point) { return carriedBy(point.instance, slice, point.capture_ws); }

bool isSky(ivec2 pixel) { return texelFetch(id_tex, pixel, 0).x == 0u; }
#endif

#if HAS_hit || HAS_id
float depthIn(uint slice, Point point) { return viewFromWorld(slice, positionIn(slice, point)).z; }

vec2 changeOf(Point point) {
#if PARAM_displacement == displacement_extrapolated
  return vec2(frame.exposure * (depthIn(SLICE_CAPTURE, point) - depthIn(SLICE_PREVIOUS, point)));
#else
  float own = depthIn(TIME_SLICE, point);
  vec2 span = frame.shutter - ownTime();
  vec2 way = vec2(depthIn(SLICE_OPEN, point), depthIn(SLICE_CLOSE, point)) - own;
  if (span.x == 0.0) return vec2(way.y / span.y);
  if (span.y == 0.0) return vec2(way.x / span.x);
  return way / span;
#endif
}

float unlessRounding(float change, float depth) {
  return isnan(change) || isinf(change) || abs(change) <= kRounding * depth ? 0.0 : change;
}
#endif

void run(ivec2 pixel) {
  vec2 change = vec2(0);
#if HAS_hit || HAS_id
  float depth = texelFetch(depth_tex, pixel, 0).x;
  if (depth > 0.0 && !isinf(depth) && !isSky(pixel)) {
    change = changeOf(pointAt(pixel, depth));
    change = vec2(unlessRounding(change.x, depth), unlessRounding(change.y, depth));
  }
#endif
  imageStore(change_img, pixel, vec4(change, 0, 0));
}
