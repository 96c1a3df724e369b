// SPDX-License-Identifier: MIT
// What time samples of a pixel have met, as bits; f is the instance seen at the capture.
#ifndef STROBE_REGIONS_GLSL
#define STROBE_REGIONS_GLSL

const uint kRegionInner = 1u;   // a sample saw a farther, different instance, where the capture sees f
const uint kRegionHidden = 2u;  // a sample saw a point that was occluded at the capture
const uint kRegionOuter = 4u;   // a sample saw a nearer, different instance
const uint kRegionSelf = 8u;    // a sample saw a point of f that was occluded at the capture

#endif
