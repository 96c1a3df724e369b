// SPDX-License-Identifier: MIT
// Pure functions that blur filters share. Displacements d are in px over the exposure, x right, y down; time t is in
// exposures, 0 at the capture. A point now at y is at y + d*t, so pixel X sees at time t what is now at X - d*t.
#ifndef STROBE_BLUR_GLSL
#define STROBE_BLUR_GLSL

// Slowest motion that blurs: a shift of half a pixel reaches no other pixel's centre. The slack keeps motion of exactly
// half a pixel, as rounded by any projection, on the still side.
const float kStillRadius = 0.5 + 1e-4;

// --- Lengths and places
// ------------------------------------------------------------------------------------------------

// Length, with the largest component divided out first, so that no square underflows or overflows.
float lengthOf(vec2 d) {
  float largest = max(abs(d.x), abs(d.y));
  return largest > 0.0 ? largest * length(d / largest) : 0.0;
}

// `d`, shortened to `limit` if it is longer; bit for bit `d` if it is not.
vec2 clampLength(vec2 d, float limit) {
  if (dot(d, d) <= limit * limit) return d;
  float d_length = lengthOf(d);
  if (d_length <= limit) return d;
  float largest = max(abs(d.x), abs(d.y));
  vec2 scaled = d / largest;
  return scaled * (limit / length(scaled));
}

// The integers that floats hold, up to 2^22; of what is farther away, that. The bits of a float between 2^23 and 2^24 count
// by ones: a device whose conversion goes component by component, invocation by invocation, has them in one step.
ivec2 wholeOf(vec2 whole) { return floatBitsToInt(clamp(whole, -4194304.0, 4194303.0) + 12582912.0) - 0x4B400000; }

// To the nearest integer, halves away from zero: mirrored offsets stay mirrored. Offsets beyond 2^22 are cut off there, far
// outside of any picture.
ivec2 roundSymmetric(vec2 offset) { return wholeOf(trunc(offset + 0.5 * sign(offset))); }

ivec2 clampToImage(ivec2 pixel, ivec2 size) { return clamp(pixel, ivec2(0), size - 1); }

bool isInside(ivec2 pixel, ivec2 size) {
  return all(lessThan(uvec2(pixel), uvec2(size)));
}

// --- The exposure window
// -----------------------------------------------------------------------------------------------

// Time at the fraction part / parts of the window's length. Run backwards, a window has the same times but for their sign, bit for
// bit: a tap half-way between two pixels goes to the same one.
float evenTimeAt(float part, int parts, vec2 shutter) {
  return (shutter.x * (float(parts) - part) + shutter.y * part) / float(parts);
}

// How far a displacement of length 1 moves to its farther side within the window: 1 one-sided, 1/2 centred.
float reachFactor(vec2 shutter) { return max(abs(shutter.x), abs(shutter.y)); }

bool isCentred(vec2 shutter) { return shutter.x < 0.0 && shutter.y > 0.0; }

// The parts of the window before and after the capture; empty where the anchor has none.
vec2 partBefore(vec2 shutter) { return vec2(shutter.x, min(shutter.y, 0.0)); }

vec2 partAfter(vec2 shutter) { return vec2(max(shutter.x, 0.0), shutter.y); }

// How many tiles away something may be that comes here: displacements up to limit_px, tiles of tile_px, `tiles` in all.
int tilesInReach(float limit_px, int tile_px, vec2 shutter, ivec2 tiles) {
  return min(int(ceil(limit_px * reachFactor(shutter) / float(tile_px))), max(tiles.x, tiles.y));
}

// Where, relative to the pixel, the surface that moves by d and is at the pixel at time t is now.
vec2 tapOffset(vec2 d, float t) { return -d * t; }

// Is what is now at the texel `now`, and moves by d, at the pixel at time t? The slack keeps the pixel itself, half a
// sample's share of its path away, on one side however that is rounded.
bool isAt(ivec2 pixel, ivec2 now, vec2 d, float t, float tolerance_px) {
  vec2 off = vec2(now - pixel) + t * d;
  float within_px = tolerance_px * (1.0 + 1e-4);
  return dot(off, off) <= within_px * within_px;
}

// Do two texels move so differently that a silhouette may lie between them? By half a pixel; with `slowest` below that, what
// moves slowly does by less. On one surface displacements vary from texel to texel.
bool movesOtherwise(vec2 d, vec2 other, float slowest) {
  if (d == other && slowest > 0.0) return false;
  return lengthOf(d - other) >= clamp(0.05 * min(lengthOf(d), lengthOf(other)), slowest, max(slowest, 0.5));
}

// Does the surface now at `offset` from a pixel pass over that pixel within the window? Rounding of the tap and of the
// path may each put it half a pixel off: across its path 3/4 px pass (the diagonal of both, nearly), along it 1/2.
bool motionReaches(vec2 offset, vec2 d, vec2 shutter) {
  float d_length = lengthOf(d);
  if (d_length < 0.5) return lengthOf(offset) < 0.5;
  vec2 direction = d / d_length;
  float travelled = dot(-offset, direction);
  float aside = abs(offset.x * direction.y - offset.y * direction.x);
  return aside <= 0.75 && travelled >= d_length * shutter.x - 0.5 && travelled <= d_length * shutter.y + 0.5;
}

// --- Weights (distance and radius in px)
// -------------------------------------------------------------------------------

// Share of a point spread over `radius` px to either side. McGuire 2012.
float cone(float distance_px, float radius_px) { return clamp(1.0 - distance_px / radius_px, 0.0, 1.0); }

// 1 within the radius, 0 outside, soft over 10 % of it. McGuire 2012.
float cylinder(float distance_px, float radius_px) {
  return 1.0 - smoothstep(0.95 * radius_px, 1.05 * radius_px, distance_px);
}

// --- Depths (view depth, positive, larger is farther, +inf is sky)
// -----------------------------------------------------

// By which share of the farther depth two depths differ, in [0, 1]: free of scale and of inf - inf.
float relativeGap(float za, float zb) { return za == zb ? 0.0 : 1.0 - min(za, zb) / max(za, zb); }

// 1 if zb is nearer than za or equal, falling to 0 where it is farther by the share `extent`. McGuire's
// softDepthCompare, with his fixed length replaced by a share of the depth.
float softDepth(float za, float zb, float extent) {
  return zb <= za ? 1.0 : clamp(1.0 - relativeGap(za, zb) / extent, 0.0, 1.0);
}

// 0 if z is at `behind` or farther, rising to 1 where it is nearer by the share `extent`.
float inFrontOf(float z, float behind, float extent) { return 1.0 - softDepth(z, behind, extent); }

// From -1 (zy is nearer than zx by the share `extent` or more) over 0 (equal) to 1 (farther).
float depthOrder(float zx, float zy, float extent) {
  float gap = clamp(relativeGap(zx, zy) / extent, 0.0, 1.0);
  return zy > zx ? gap : -gap;
}

#endif
