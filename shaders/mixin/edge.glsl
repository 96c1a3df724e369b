// SPDX-License-Identifier: MIT
// Needs: edge_img, where_tex.
// Input mask and output of every edge detector.
// In:  `where` (optional): the detector runs where it is above 1/2; everywhere if absent.
// Out: `edge`: 1 on edges, 0 elsewhere.
#ifndef STROBE_EDGE_GLSL
#define STROBE_EDGE_GLSL

// True if the detector runs at the pixel.
bool isWanted(ivec2 pixel) { return where_at(pixel).x > 0.5; }

void markEdge(ivec2 pixel, bool edge) { imageStore(edge_img, pixel, vec4(edge ? 1 : 0)); }

#endif
