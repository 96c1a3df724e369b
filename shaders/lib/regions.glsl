// SPDX-License-Identifier: MIT
// Regions of the error report as bits, per pixel. The time samples of a pixel set these bits. The *raster instance* is
// the instance that the pixel shows at the raster time.
#ifndef STROBE_REGIONS_GLSL
#define STROBE_REGIONS_GLSL

const uint kRegionInner = 1u;   // a sample hit another instance, or the sky, farther away than the raster instance
const uint kRegionHidden = 2u;  // a sample hit a point that is occluded at the raster time
const uint kRegionOuter = 4u;   // a sample hit another instance, nearer than the raster instance
const uint kRegionSelf = 8u;    // a sample hit a point of the raster instance that is occluded at the raster time

#endif
