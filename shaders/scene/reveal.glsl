// SPDX-License-Identifier: MIT
// The surface behind the foreground, along the same ray as the raster's sample (Tan, Cui, Bhojan 2020, "Ray Reveal").
// In:  hit_tex (foreground), mask_tex (> 0.5: reveal).
// Out: color, depth, id, velocity, valid as the G-buffer encodes them; everything 0 where nothing is revealed.
// Instance and geometry termination skip the foreground within one traversal and meet no cap. Motion and luminance
// termination advance hit by hit; the latter stops inside an object whose back is lit differently, and passes through
// a background of the same luminance.
#include "lib/shade.glsl"

float luminance(vec3 color) { return dot(color, vec3(0.2126, 0.7152, 0.0722)); }

const float kFar = 3.0e38;

// Four representable numbers further: the hit itself is not found again, and no true layer is passed over.
float justBehind(float t) { return uintBitsToFloat(floatBitsToUint(t) + 4u); }

// The first hit behind `front` whose luminance differs from it; `capped` when none did within the cap.
Hit revealByLuminance(Ray ray, Hit front, out bool capped) {
  float reference = luminance(shade(SLICE_CAPTURE, front));
  float depth = front.t;
  Hit hit = noHit();
  capped = false;
  for (int layer = 0; layer < params.max_layers; ++layer) {
#if PARAM_advance == advance_restart
    Ray onward = Ray(ray.origin + ray.direction * depth, ray.direction);
    hit = traceNearest(SLICE_CAPTURE, onward, 1e-5 * depth, kFar);
    hit.t += depth;
#else
    hit = traceNearest(SLICE_CAPTURE, ray, justBehind(depth), kFar);
#endif
    if (!isHit(hit)) return hit;
    depth = hit.t;
    float here = luminance(shade(SLICE_CAPTURE, hit));
    if (abs(here - reference) > params.tolerance * max(here, reference)) return hit;
  }
  capped = true;
  return hit;
}

// Does the surface move as if it were fixed to the foreground: on the screen, at both ends of the exposure?
bool goesAlong(Hit hit, uint instance) {
  vec3 capture_ws = positionOf(SLICE_CAPTURE, hit);
  for (uint slice = SLICE_OPEN; slice <= SLICE_CLOSE; ++slice) {
    vec2 own = pixelFromView(slice, viewFromWorld(slice, positionOf(slice, hit)));
    vec2 carried = pixelFromView(slice, viewFromWorld(slice, carriedBy(instance, slice, capture_ws)));
    if (!(distance(own, carried) <= params.same_motion)) return false;
  }
  return true;
}

// The first hit behind `front` that does not go along with it: what does (a load on a truck, a lamp in its shade)
// hides the same background as the foreground.
Hit revealByMotion(Ray ray, Hit front, out bool capped) {
  float depth = front.t;
  Hit hit = noHit();
  capped = false;
  for (int layer = 0; layer < params.max_layers; ++layer) {
    hit = traceExcept(SLICE_CAPTURE, ray, justBehind(depth), kFar, front.instance, NO_INSTANCE);
    if (!isHit(hit) || !goesAlong(hit, front.instance)) return hit;
    depth = hit.t;
  }
  capped = true;
  return hit;
}

void run(ivec2 pixel) {
  uvec4 seen = texelFetch(hit_tex, pixel, 0);
  bool wanted = texelFetch(mask_tex, pixel, 0).r > 0.5 && seen.x != 0u;
  vec4 color = vec4(0);
  float depth = 0.0, valid = 0.0;
  uvec2 id = uvec2(0);
  vec2 velocity = vec2(0);
  if (wanted) {
    Ray ray = cameraRay(SLICE_CAPTURE, samplePosition(pixel));
    Hit front = hitOnTriangle(SLICE_CAPTURE, ray, seen.x - 1u, seen.y, seen.z);
    bool capped = false;
#if PARAM_termination == termination_luminance
    Hit hit = revealByLuminance(ray, front, capped);
#elif PARAM_termination == termination_motion
    Hit hit = revealByMotion(ray, front, capped);
#elif PARAM_termination == termination_geometry
    Hit hit = traceExcept(SLICE_CAPTURE, ray, front.t, kFar, front.instance, front.geometry);
#else
    Hit hit = traceExcept(SLICE_CAPTURE, ray, front.t, kFar, front.instance, NO_INSTANCE);
#endif
    if (capped) count_capped(1u);
    if (!capped || PARAM_on_cap == on_cap_last_hit) {
      valid = 1.0;
      count_revealed(1u);
      if (isHit(hit)) {
        // Where on the triangle: as raster computes it, which does not depend on the device.
        hit = hitOnTriangle(SLICE_CAPTURE, ray, hit.instance, hit.geometry, hit.primitive);
        color = vec4(shade(SLICE_CAPTURE, hit), 1);
        depth = hit.t;
        id = uvec2(hit.instance, hit.geometry) + 1u;
        velocity = displacementOf(hit);
      } else {
        color = vec4(environment(ray.direction), 1);
        depth = uintBitsToFloat(0x7f800000u);
        velocity = displacementOfSky(ray.direction);
      }
    }
  }
  imageStore(color_img, pixel, color);
  imageStore(depth_img, pixel, vec4(depth));
  imageStore(id_img, pixel, uvec4(id, 0u, 0u));
  imageStore(velocity_img, pixel, vec4(velocity, 0, 0));
  imageStore(valid_img, pixel, vec4(valid));
}
