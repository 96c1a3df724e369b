// SPDX-License-Identifier: MIT
// Trail of one pixel: the texel that each pass of the frame stores for it, in execution order, and all surfaces along
// its ray. Pictures and records are equal to a run without a trail.
#pragma once

#include <string>
#include <vector>

#include "lab/workbench.h"

namespace strobe::lab {

// Texel of one image that covers the pixel.
struct TrailRow {
  std::string node, port, format;
  std::string doc;                 // meaning and unit of the port, from its pass
  int width = 0, height = 0;       // size of the image, texels
  int divide = 1;                  // frame pixels per texel; 0: does not map to the frame
  int x = 0, y = 0;                // texel; 0,0 if `divide` is 0
  std::vector<double> values;      // one per channel; empty for an image of fixed size larger than 1x1
  std::vector<uint32_t> integers;  // values of an integer image
};

// A surface on the camera ray through the pixel centre at the raster time; hits are sorted by distance.
struct TrailHit {
  int layer = 0;         // index along the ray; 0: visible surface
  std::string instance;  // name of the node in the scene
  uint32_t geometry = 0, primitive = 0;
  bool front = false;       // true if the ray hits the front side
  double depth = 0;         // linear view depth, metres
  vec3 normal = vec3(0);    // unit length, world space, towards the camera
  vec2 velocity = vec2(0);  // displacement over the exposure, px, x right, y down
  vec3 color = vec3(0);     // linear radiance towards the camera
};

// Debug trace of one pixel: the texel of every image in the frame graph that covers the pixel, and every surface along
// the camera ray.
struct Trail {
  std::string pipeline;
  int x = 0, y = 0, width = 0, height = 0;  // pixel, and size of the frame, px
  std::vector<TrailRow> rows;
  std::vector<TrailHit> hits;
};

// Numbers as the shortest texts that read back as the same 32-bit floats.
std::string numbersText(const std::vector<double>& numbers, const char* between = "  ");
// Values of a row; "-" without values.
std::string valuesText(const TrailRow& row);

// Parses "X,Y", pixels from the top left. Throws `Error` (exit code 2).
std::array<int, 2> parsePixel(const std::string& text);

// Renders the shot and records the trail of a pixel. Picture and record are the same as from `Workbench::render`.
// Throws `Error` (exit code 2) for a pixel outside the picture.
struct Followed {
  Picture picture;
  Trail trail;
};
Followed follow(Workbench& bench, const Shot& shot, int x, int y, const std::function<void(int, int)>& progress = {},
                bool id_coverage = false);

// JSON of a trail. Non-finite numbers are the texts "nan", "inf" and "-inf"; all other numbers read back to the same
// 32-bit float.
Json toJson(const Trail& trail);

// Aligned text. Floats have the fewest digits that read back to the same float.
std::string tableOf(const Trail& trail);

}  // namespace strobe::lab
