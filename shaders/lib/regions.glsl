// SPDX-License-Identifier: MIT
// Regions of the error report as bits, per pixel, set by the hits of the pixel's time samples. f: instance that the pixel shows
// at the raster time.
#ifndef STROBE_REGIONS_GLSL
#define STROBE_REGIONS_GLSL

const uint kRegionInner = 1u;   // a sample hit another instance, or the sky, farther away than f
const uint kRegionHidden = 2u;  // a sample hit a point that is occluded at the raster time
const uint kRegionOuter = 4u;   // a sample hit another instance, nearer than f
const uint kRegionSelf = 8u;    // a sample hit a point of f that is occluded at the raster time

#endif
