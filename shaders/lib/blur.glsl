// SPDX-License-Identifier: MIT
// Pure functions that blur filters share: lengths, places, the exposure window, weights and depth comparisons.
// Conventions: a displacement d is in px over the exposure, x right, y down. Time t is in exposures, 0 at the raster time. A
// point that is at y at the raster time is at y + d*t at time t. Pixel X therefore shows at time t the point that is at X - d*t
// at the raster time. An exposure window is the pair (shutter open, shutter close) of times; its length is 1.
#ifndef STROBE_BLUR_GLSL
#define STROBE_BLUR_GLSL

// Longest motion of a surface that counts as static, px. A surface that moves by at most half a pixel reaches no other pixel's
// centre. The added 1e-4 keeps a motion of exactly half a pixel static in spite of rounding in the projection.
const float kStaticRadius = 0.5 + 1e-4;

// --- Lengths and places
// ------------------------------------------------------------------------------------------------

// Length of d. The largest component is divided out first, so that no square underflows or overflows.
float lengthOf(vec2 d) {
  float largest = max(abs(d.x), abs(d.y));
  return largest > 0.0 ? largest * length(d / largest) : 0.0;
}

// Displacement d, shortened to the length `limit`. If d is not longer, the result is d, bit for bit.
vec2 clampLength(vec2 d, float limit) {
  if (dot(d, d) <= limit * limit) return d;
  float d_length = lengthOf(d);
  if (d_length <= limit) return d;
  float largest = max(abs(d.x), abs(d.y));
  vec2 scaled = d / largest;
  return scaled * (limit / length(scaled));
}

// Converts floats that hold integers to integers, clamped to [-2^22, 2^22 - 1]. The sum of such a float and 1.5 * 2^23 has the
// integer in its lowest bits. Software devices add vectors in one step, but convert floats to integers one by one.
ivec2 wholeOf(vec2 whole) { return floatBitsToInt(clamp(whole, -4194304.0, 4194303.0) + 12582912.0) - 0x4B400000; }

// Nearest integers, with ties away from zero, so that offsets of opposite sign round to integers of opposite sign. Offsets
// beyond 2^22 px, far outside of any image, are clamped.
ivec2 roundSymmetric(vec2 offset) { return wholeOf(trunc(offset + 0.5 * sign(offset))); }

// Pixel of the image that is nearest to `pixel`.
ivec2 clampToImage(ivec2 pixel, ivec2 size) { return clamp(pixel, ivec2(0), size - 1); }

// True if the pixel is in the image.
bool isInside(ivec2 pixel, ivec2 size) {
  return all(lessThan(uvec2(pixel), uvec2(size)));
}

// --- The exposure window
// -----------------------------------------------------------------------------------------------

// Time at the fraction part / parts of the exposure window `shutter`, evenly spaced. If the scene is reversed in time, the
// times change sign exactly, bit for bit, as displacements do. A tap half-way between two pixels then rounds to the same pixel
// as without the reversal.
float evenTimeAt(float part, int parts, vec2 shutter) {
  return (shutter.x * (float(parts) - part) + shutter.y * part) / float(parts);
}

// Largest distance that a surface moves from its place of the raster time within the exposure window, as a share of its
// displacement: 1 if the raster time is at an end of the window, 1/2 if it is in the middle.
float spreadFactor(vec2 shutter) { return max(abs(shutter.x), abs(shutter.y)); }

// True if the exposure window has times both before and after the raster time.
bool isCentred(vec2 shutter) { return shutter.x < 0.0 && shutter.y > 0.0; }

// Part of the exposure window before the raster time; empty if the exposure starts at the raster time.
vec2 partBefore(vec2 shutter) { return vec2(shutter.x, min(shutter.y, 0.0)); }

// Part of the exposure window after the raster time; empty if the exposure ends at the raster time.
vec2 partAfter(vec2 shutter) { return vec2(max(shutter.x, 0.0), shutter.y); }

// Largest distance, in tiles, between a tile and a surface that can reach the tile. `limit_px`: length of the longest
// displacement. `tile_px`: side of a tile. `tiles`: number of tiles per axis, which bounds the result.
int tilesInReach(float limit_px, int tile_px, vec2 shutter, ivec2 tiles) {
  return min(int(ceil(limit_px * spreadFactor(shutter) / float(tile_px))), max(tiles.x, tiles.y));
}

// Position at the raster time, relative to the pixel, of a surface that moves by d and is at the pixel at time t: the place
// where a filter reads its colour.
vec2 tapOffset(vec2 d, float t) { return -d * t; }

// True if the surface that `texel` shows at the raster time and that moves by d is at the pixel at time t, within the
// tolerance. The factor 1 + 1e-4 makes the result independent of rounding where the distance equals the tolerance. The
// distance equals the tolerance, for example, for the pixel's own texel at half the time between two samples.
bool isAt(ivec2 pixel, ivec2 texel, vec2 d, float t, float tolerance_px) {
  vec2 off = vec2(texel - pixel) + t * d;
  float within_px = tolerance_px * (1.0 + 1e-4);
  return dot(off, off) <= within_px * within_px;
}

// True if a surface that is at `offset` from a pixel at the raster time, and moves by d, passes over the pixel within the
// window. Both the position of the texel and its path may be rounded by half a pixel. The tolerance is therefore 3/4 px across
// the path (sqrt(1/2), rounded up) and 1/2 px along the path.
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

// Weight of a surface at a distance of `distance_px`, if motion spreads the surface over `radius_px` to either side: falls
// linearly from 1 to 0 (McGuire et al. 2012).
float cone(float distance_px, float radius_px) { return clamp(1.0 - distance_px / radius_px, 0.0, 1.0); }

// 1 if the distance is within the radius, 0 outside, with a smooth step over 10 % of the radius (McGuire et al. 2012).
float cylinder(float distance_px, float radius_px) {
  return 1.0 - smoothstep(0.95 * radius_px, 1.05 * radius_px, distance_px);
}

// --- Depths (view depth, positive, larger is farther, +inf is sky)
// -----------------------------------------------------

// Difference of two depths as a share of the farther one, in [0, 1]. Independent of the scale of the scene; avoids inf - inf.
float relativeGap(float za, float zb) { return za == zb ? 0.0 : 1.0 - min(za, zb) / max(za, zb); }

// Soft comparison of depths: 1 if zb is nearer than za or equal; falls linearly to 0 where zb is farther by the share `extent`
// of its depth. This is softDepthCompare of McGuire et al. 2012, with a share of the depth in place of their fixed length.
float softDepth(float za, float zb, float extent) {
  return zb <= za ? 1.0 : clamp(1.0 - relativeGap(za, zb) / extent, 0.0, 1.0);
}

// Soft comparison of a depth with a background: 0 if z is at the depth `background` or farther; rises linearly to 1 where z is
// nearer by the share `extent`.
float inFrontOf(float z, float background, float extent) { return 1.0 - softDepth(z, background, extent); }

// Soft order of two depths, in [-1, 1]: -1 if zy is nearer than zx by the share `extent` or more, 0 if equal, 1 if zy is
// farther by that share or more; linear in between.
float depthOrder(float zx, float zy, float extent) {
  float gap = clamp(relativeGap(zx, zy) / extent, 0.0, 1.0);
  return zy > zx ? gap : -gap;
}

#endif
