// SPDX-License-Identifier: MIT
// Textures: smaller levels of an image, and patterns made from a few numbers.
#pragma once

#include <functional>

#include "scene/scene.h"

namespace strobe::scene {

// Transfer function of sRGB (IEC 61966-2-1) for values in 0..1.
double linearFromSrgb(double encoded);

// Fills the levels below level 0, down to 1x1. Each texel is the mean over its area. The mean of Rgba8Srgb is in linear
// light and weighted with alpha; other formats average the stored values. Sizes halve and round down.
void buildLevels(Texture& texture);

// Mean of the texels, linear RGB, with the precision of the smallest level.
vec3 meanColor(const Texture& texture);

// Texture of 8-bit sRGB texels from `color_at` (linear RGBA in 0..1 at u, v in 0..1, v downwards), with all its levels.
// Each texel is the mean of `samples` x `samples` points.
Texture paint(int width, int height, int samples, const std::function<vec4(dvec2 uv)>& color_at);

// A pattern and its parameters. `patternNames` lists the parameters of each pattern.
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

// Names of patterns, with their parameters:
// stripes (colors, widths, count.x; along v), checker (2 colors, count), quilt (3: cloth, seam, dots; count, line), rug
// (4: field, border, motif, line), wood (2: light, dark; count.x planks, amount, seed), noise (2; count, amount, seed),
// weave (2; count), spine (3: cover, band, gilt; seed), painting (5: sky, sun, far, near, ground; seed), gradient (2:
// top, bottom), leaf (2: blade, vein).
const std::vector<std::string>& patternNames();
size_t patternColors(const std::string& type);  // least number of colours
// Texture of a pattern, painted by `paint` with 2x2 points per texel.
Texture paintPattern(const Pattern& pattern);

// Function that paints the patterns of a scene.
using Painter = std::function<Texture(const Pattern&)>;

// Texture of given texels (top row first), sampled without a filter, for pictures with a closed form.
Texture texelTexture(int width, int height, const std::vector<vec4>& texels);

// Matrix of KHR_texture_transform: scale, then rotation by `rotation` radians (anticlockwise in a picture with v
// downwards), then offset.
glm::dmat3x2 uvTransform(dvec2 offset, double rotation, dvec2 scale);

}  // namespace strobe::scene
