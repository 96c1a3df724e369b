// SPDX-License-Identifier: MIT
// Textures: smaller levels of an image, and images made from a few numbers.
#pragma once

#include <functional>

#include "scene/scene.h"

namespace strobe::scene {

// IEC 61966-2-1, of values in 0..1.
double linearFromSrgb(double encoded);
double srgbFromLinear(double linear);

// Fills the levels below level 0, down to 1x1: each texel is the mean over the area it covers, in linear light and
// weighted with alpha (Rgba8Srgb), or of the values as they are. Sizes halve and round down.
void buildLevels(Texture& texture);

// Mean of the texels, linear RGB, in the precision of the texture's smallest level.
vec3 meanColor(const Texture& texture);

// A texture of 8-bit sRGB texels from `color_at` (linear RGBA in 0..1 of u, v in 0..1, v downwards), each the mean of
// `samples` x `samples` points, with all its levels.
Texture paint(int width, int height, int samples, const std::function<vec4(dvec2 uv)>& color_at);

// A pattern and its numbers; which of them a pattern reads is said at its name.
struct Pattern {
  std::string type;
  int width = 512, height = 512;
  std::vector<vec3> colors;    // linear
  dvec2 count = dvec2(8);      // repeats across u and v
  std::vector<double> widths;  // stripes: relative, one per colour
  double amount = 0.5;         // strength of grain, noise, dirt
  double line = 0.06;          // width of lines relative to a repeat
  int seed = 1;
};

// Names of patterns:
// stripes (colors, widths, count.x; along v), checker (2 colors, count), quilt (3: cloth, seam, dots; count, line),
// rug (4: field, border, motif, line), wood (2: light, dark; count.x planks, amount, seed), noise (2; count, amount,
// seed), weave (2; count), spine (3: cover, band, gilt; seed), painting (5: sky, sun, far, near, ground; seed),
// gradient (2: top, bottom), leaf (2: blade, vein).
const std::vector<std::string>& patternNames();
size_t patternColors(const std::string& type);  // how many a pattern needs at least
// Its texture as `paint` makes it, of 2x2 points a texel.
Texture paintPattern(const Pattern& pattern);

// Who paints the patterns of a scene.
using Painter = std::function<Texture(const Pattern&)>;

// Texels given one by one (top row first), sampled without any filter: for pictures that have a closed form.
Texture texelTexture(int width, int height, const std::vector<vec4>& texels);

// KHR_texture_transform: scaled, then turned anticlockwise by `rotation` radians in a picture with v downwards, then
// shifted.
glm::dmat3x2 uvTransform(dvec2 offset, double rotation, dvec2 scale);

}  // namespace strobe::scene
