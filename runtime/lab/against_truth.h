// SPDX-License-Identifier: MIT
// Regions of a truth picture, its standard error, and the counts in a record.
#pragma once

#include "lab/workbench.h"

namespace strobe::lab {

// Mask of a region. "moving": pixels of instances with a displacement of at least 0.5 px at any pixel. "edge": pixels
// at most 2 px (per axis) from a pixel of another instance. Other names: the truth output of that name. Empty for
// "whole". Throws `Error` for an output that the truth lacks.
image::Image maskOf(const Picture& truth, const std::string& region);

// Median displacement of the moving pixels, px over the exposure. 0 without moving pixels, NaN without `velocity` and
// `id`.
double displacementOf(const Picture& picture);

// Standard error of the truth over a region: root mean square of its output `error`; 0 without this output.
double sigmaOf(const Picture& truth, const image::Image& mask);

// Values of the counters in a record whose names begin with `counter` ("clamped", "rays_"), one per node and counter.
// Counters named "clamped" count the same pixels in several passes, so the largest value stands for all.
std::vector<uint64_t> countsOf(const Json& record, const std::string& counter);

}  // namespace strobe::lab
