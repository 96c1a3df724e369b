// SPDX-License-Identifier: MIT
// Any image of a frame as a picture for people. Pure CPU. Results are display images (image/tone.h) of three channels.
// Loud everywhere: NaN is magenta, infinity yellow (but +infinity in a depth is "nothing there" and black).
#pragma once

#include <string>
#include <vector>

#include "graph/graph.h"
#include "image/image.h"
#include "image/magma.h"

namespace strobe::lab {

// How an image is shown.
struct ViewOptions {
  // "auto" chooses by name, format and channels; so does a kind that the image cannot be shown as, and "numbers", whose
  // texels the window prints itself.
  //   colour   linear radiance times 2^exposure_stops, sRGB-encoded
  //   depth    metres on a logarithmic scale, near pale, far dark
  //   normal   n / 2 + 1 / 2; no normal (0) is black
  //   velocity direction as hue, length as brightness, with the wheel that says which and how long
  //   arrows   displacements drawn on a grid, to a stated scale
  //   id       a colour of its own for every id
  //   mask     orange where set, over the dimmed colour
  //   scalar   magma with a labelled bar; the length of two channels, the mean of three
  std::string kind = "auto";
  double exposure_stops = 0;
  double low = 0, high = 0;  // ends of a scale (depth m, velocity and arrows px: high alone); equal: from the image
  bool over = true;          // masks and arrows over the colour instead of black
  bool operator==(const ViewOptions&) const = default;
};

// The kind that "auto" stands for; `port` is "node.port" or the name of an output.
std::string automaticKind(const graph::ReadImage& image, const std::string& port);

// The kinds that make sense for an image, "auto" first: a menu.
std::vector<std::string> viewKinds(const graph::ReadImage& image);

// Frame pixels per texel and axis of an output or a "node.port"; 0: no picture of the frame; 1 for what there is not.
int divideOf(const plan::Plan& plan, const std::string& port);

// What the colours of a view mean: nothing to say, a bar of scalars or of depths (m) from low to high, a wheel of
// displacements up to `high` px, or words alone.
struct Legend {
  enum class Kind { none, bar, depth, wheel, words };
  Kind kind = Kind::none;
  double low = 0, high = 0;
  std::string text;  // words; in the middle of a bar
  bool operator==(const Legend&) const = default;
};

// A legend alone, to be shown beside a picture or on it; empty where there is nothing to say.
image::Image pictureOf(const Legend& legend);

// At `t` from 0 (low) to 1 (high) of a bar.
image::Colour barColour(Legend::Kind kind, float t);

// `divide` is how many frame pixels a texel covers per axis; 0: an image of fixed size, which is fitted into the frame.
// `under` (may be null) is the linear colour beneath masks and arrows, of the frame's size. The legend is drawn into
// the lower right corner, or, with `legend`, returned there.
image::Image shown(const graph::ReadImage& image, const std::string& port, int divide, int width, int height,
                   const ViewOptions& options, const image::Image* under, Legend* legend = nullptr);

// `a` left of `at` (0 to 1 of the width), `b` right of it, a line between.
image::Image wiped(const image::Image& a, const image::Image& b, double at);
// The first column of b in a wipe of that width.
int wipedFrom(double at, int width);

// Mean absolute difference of the colours in magma, its upper end at 1 / gain; the legend as `shown` has it.
image::Image difference(const image::Image& linear_a, const image::Image& linear_b, double gain,
                        const std::string& title = "mean |A - B|", Legend* legend = nullptr);

}  // namespace strobe::lab
