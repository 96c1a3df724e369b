// SPDX-License-Identifier: MIT
// Joint upsampling (Kopf, Cohen, Lischinski, Uyttendaele 2007) of a revealed layer with one ray per 2x2 pixels.
// In:  hit, mask, front_depth of full resolution; color, depth, id, velocity, valid of the revealed layer, a texel per
//      square of 2x2 pixels, whose ray went through sourcePixel() of the square.
// Out: the same layer at full resolution, as a ray per pixel would have written it.
// A pixel whose own ray revealed something has exactly that. Another one is the mean of the rays less than
//   2 px away in x and in y, weighted by a tent, that passed through the same geometry in front and revealed the same
//   surface as the one of largest weight: the same ids, at depths that differ by less than depth_extent. Where no ray
//   passed through the same geometry, one that revealed something farther away than the pixel's own surface, of another
//   instance, stands in. Else nothing is revealed there (counter `unmatched`).
// Fails: detail of the revealed surface finer than 2 px is smoothed or missed, silhouettes in it move by up to a pixel;
//   which pixel of a square has the ray is not symmetric under mirroring.
#include "lib/blur.glsl"
#include "lib/sanitise.glsl"
#include "mixin/square.glsl"
#include "mixin/stored.glsl"

struct Sample {
  ivec2 square;
  float weight;  // 0: of no use
  float depth;
  uvec2 id;
};
const int kSamples = 9;

struct Revealed {
  vec4 color;
  float depth;
  vec2 velocity;
};

// What the ray of a square says about a pixel that sees `seen` at `here`.
Sample sampleOf(ivec2 square, ivec2 pixel, uvec4 seen, float here) {
  Sample s = Sample(square, 0.0, 0.0, uvec2(0));
  if (!isInside(square, textureSize(valid_tex, 0)) || texelFetch(valid_tex, square, 0).x <= 0.5) return s;
  ivec2 source = sourcePixel(square, 2);
  vec2 tent = max(vec2(0), 1.0 - 0.5 * abs(vec2(source - pixel)));
  s.weight = tent.x * tent.y;
  s.depth = saneDepth(texelFetch(depth_tex, square, 0).x);
  s.id = texelFetch(id_tex, square, 0).xy;
  bool same_front = texelFetch(hit_tex, source, 0).xy == seen.xy;
  bool stands_in = s.depth > here && s.id.x != seen.x;
  if (!same_front) s.weight *= stands_in ? 1e-6 : 0.0;  // outweighed by any through the same
  return s;
}

bool isOneSurface(Sample a, Sample b) {
  return a.id == b.id && relativeGap(a.depth, b.depth) < params.depth_extent;
}

Revealed revealedIn(ivec2 square) {
  vec4 color = texelFetch(color_tex, square, 0);
  return Revealed(vec4(finiteColor(color), color.w), saneDepth(texelFetch(depth_tex, square, 0).x),
                  texelFetch(velocity_tex, square, 0).xy);
}

// Differences to the best sample are averaged: where all are equal, the result is that, bit for bit.
Revealed blended(Sample samples[kSamples], Sample best) {
  Revealed centre = revealedIn(best.square);
  if (best.weight == 1.0) return centre;  // the pixel's own ray
  Revealed sum = Revealed(vec4(0), 0.0, vec2(0));
  float weights = 0.0;
  for (int i = 0; i < kSamples; ++i) {
    float weight = samples[i].weight;
    if (weight <= 0.0 || !isOneSurface(samples[i], best)) continue;
    Revealed other = revealedIn(samples[i].square);
    weights += weight;
    sum.color += weight * kSumScale * (other.color - centre.color);
    sum.velocity += weight * (other.velocity - centre.velocity);
    if (!isinf(centre.depth)) sum.depth += weight * (other.depth - centre.depth);
  }
  return Revealed(centre.color + sum.color / weights / kSumScale, centre.depth + sum.depth / weights,
                  centre.velocity + sum.velocity / weights);
}

void run(ivec2 pixel) {
  Sample best = Sample(ivec2(0), 0.0, 0.0, uvec2(0));
  Revealed revealed = Revealed(vec4(0), 0.0, vec2(0));
  if (isMasked(pixel)) {
    uvec4 seen = texelFetch(hit_tex, pixel, 0);
    float here = saneDepth(texelFetch(front_depth_tex, pixel, 0).x);
    Sample samples[kSamples];
    for (int i = 0; i < kSamples; ++i) {
      samples[i] = sampleOf(pixel / 2 + ivec2(i % 3 - 1, i / 3 - 1), pixel, seen, here);
      if (samples[i].weight > best.weight) best = samples[i];
    }
    if (best.weight > 0.0) revealed = blended(samples, best);
    else count_unmatched(1u);
  }
  imageStore(color_img, pixel, storedColor(revealed.color));
  imageStore(depth_img, pixel, vec4(storedDepth(revealed.depth)));
  imageStore(id_img, pixel, uvec4(best.id, 0u, 0u));
  imageStore(velocity_img, pixel, vec4(storedVelocity(revealed.velocity), 0, 0));
  imageStore(valid_img, pixel, vec4(best.weight > 0.0 ? 1.0 : 0.0));
}
