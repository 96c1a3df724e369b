// SPDX-License-Identifier: MIT
// Views of the images of a frame, as display images (image/tone.h) with three channels. CPU only. NaN is magenta and
// infinity yellow, but +infinity in a depth is background and black.
#pragma once

#include <string>
#include <vector>

#include "graph/graph.h"
#include "image/legend.h"

namespace strobe::lab {

// Options of a view.
struct ViewOptions {
  // "auto" selects by name, format and channels. It also replaces a kind that does not fit the image, and "numbers",
  // since the window prints these texels itself.
  //   colour   linear radiance times 2^exposure_stops, sRGB-encoded
  //   depth    metres on a logarithmic scale, near pale, far dark
  //   normal   n / 2 + 1 / 2; no normal (0) is black
  //   velocity direction as hue, length as brightness, with a colour wheel as legend
  //   arrows   displacements as arrows on a grid, with their scale
  //   id       one colour per id
  //   mask     orange where set, over the dimmed colour
  //   scalar   magma with a labelled bar; length of two channels, mean of three
  std::string kind = "auto";
  double exposure_stops = 0;
  double low = 0, high = 0;  // ends of the scale (depth m; velocity and arrows px, only high); equal: from the image
  bool over = true;          // draw masks and arrows over the colour, otherwise over black
  bool operator==(const ViewOptions&) const = default;
};

// Kind that "auto" selects; `port` is "node.port" or the name of an output.
std::string automaticKind(const graph::ReadImage& image, const std::string& port);

// Kinds that fit an image, "auto" first, for a menu.
std::vector<std::string> viewKinds(const graph::ReadImage& image);

// Frame pixels per texel and axis of an output or a "node.port". 0: does not map to the frame. 1 for an unknown name.
int divideOf(const plan::Plan& plan, const std::string& port);

// View of an image at the size of the frame. `divide`: frame pixels per texel and axis; 0: an image of fixed size,
// fitted into the frame. `under` (may be null): linear colour beneath masks and arrows, at frame size. The legend is
// returned in `legend`; if null, it is drawn into the lower right corner.
image::Image shown(const graph::ReadImage& image, const std::string& port, int divide, int width, int height,
                   const ViewOptions& options, const image::Image* under, image::Legend* legend = nullptr);

// `a` left of the fraction `at` of the width, `b` to the right, and a line between.
image::Image wiped(const image::Image& a, const image::Image& b, double at);
// First column of `b` in a wipe of this width, px.
int wipedFrom(double at, int width);

// Mean absolute difference of the colours in magma, with 1 / gain at the upper end. Legend as for `shown`.
image::Image difference(const image::Image& linear_a, const image::Image& linear_b, double gain,
                        const std::string& title = "mean |A - B|", image::Legend* legend = nullptr);

}  // namespace strobe::lab
