// SPDX-License-Identifier: MIT
// What a picture of truth says about others: its regions, its own standard error; and what their records say of limits.
#pragma once

#include "lab/workbench.h"

namespace strobe::lab {

// Pixels of a region: an output of the truth by that name; empty for "whole"; "moving" and "edge" as below.
image::Image maskOf(const Picture& truth, const std::string& region);

// By a picture's outputs `velocity` and `id`, empty where it has none: pixels of instances that move by half a pixel or
// more anywhere in the picture, and pixels at most 2 px from one of another instance.
image::Image movingMask(const Picture& picture);
image::Image edgeMask(const Picture& picture);

// The median displacement of the pixels of what moves, px over the exposure; 0 where nothing does, NaN without
// `velocity` and `id`.
double displacementOf(const Picture& picture);

// Truth's standard error over a region: root mean square of its output `error`, 0 where it has none.
double sigmaOf(const Picture& truth, const image::Image& mask);

// Counts of the nodes' counters whose names begin so ("clamped", "rays_"), by a picture's record; by node.
std::vector<uint64_t> countsOf(const Json& record, const std::string& counter);

}  // namespace strobe::lab
