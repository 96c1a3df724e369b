// SPDX-License-Identifier: MIT
// Needs: edge_img, where_tex.
// Input and output that all edge detectors share: the mask that limits where a detector runs, and the image of edges. Every
// edge detector includes this file.
// In:  `where` (optional): the detector runs where the mask is above 1/2, and everywhere if the mask is absent.
// Out: `edge`: 1 on edges, 0 elsewhere.
#ifndef STROBE_EDGE_GLSL
#define STROBE_EDGE_GLSL

// True if the detector runs at the pixel.
bool isWanted(ivec2 pixel) { return where_at(pixel).x > 0.5; }

// Store the result of the detector at a pixel: 1 if `edge` is true, otherwise 0.
void markEdge(ivec2 pixel, bool edge) { imageStore(edge_img, pixel, vec4(edge ? 1 : 0)); }

#endif
