// SPDX-License-Identifier: MIT
// Needs: edge_img, where_tex.
// Mask that limits an edge detector, and output of the detector. Every edge detector includes this file.
// In:  `where` (optional): the detector runs where the mask is above 1/2, and everywhere if the mask is absent.
// Out: `edge`: 1 on edges, 0 elsewhere.
#ifndef STROBE_EDGE_GLSL
#define STROBE_EDGE_GLSL

// True if the detector runs at the pixel.
bool isWanted(ivec2 pixel) { return where_at(pixel).x > 0.5; }

void markEdge(ivec2 pixel, bool edge) { imageStore(edge_img, pixel, vec4(edge ? 1 : 0)); }

#endif
