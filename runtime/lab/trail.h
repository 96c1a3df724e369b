// SPDX-License-Identifier: MIT
// The trail of one pixel: what every pass of the frame left there, in the order of execution, and everything its ray
// meets. Looking changes nothing: pictures and records are those of a run that was not looked at.
#pragma once

#include <string>
#include <vector>

#include "lab/workbench.h"

namespace strobe::lab {

// The texel of one image that covers the pixel.
struct TrailRow {
  std::string node, port, format;
  std::string doc;                 // what the port holds and in which units, as its pass declares it
  int width = 0, height = 0;       // of the image
  int divide = 1;                  // frame pixels per texel; 0: not a picture of the frame
  int x = 0, y = 0;                // texel; of an image that is no picture of the frame: 0,0
  std::vector<double> values;      // one per channel; empty for an image of fixed size larger than 1x1
  std::vector<uint32_t> integers;  // the same of integer images
};

// One surface along the camera's ray through the pixel's centre at the raster time, nearest first.
struct TrailHit {
  int layer = 0;         // 0 is what the camera sees
  std::string instance;  // its node's name in the scene
  uint32_t geometry = 0, primitive = 0;
  bool front = false;       // the side that is seen
  double depth = 0;         // linear view depth, metres
  vec3 normal = vec3(0);    // unit, world space, towards the camera
  vec2 velocity = vec2(0);  // displacement over the exposure, px, x right, y down
  vec3 color = vec3(0);     // linear radiance towards the camera
};

struct Trail {
  std::string pipeline;
  int x = 0, y = 0, width = 0, height = 0;  // the pixel and the frame it is in
  std::vector<TrailRow> rows;
  std::vector<TrailHit> hits;
};

// "X,Y" in pixels from the top left. Throws `Error` with exit code 2.
std::array<int, 2> parsePixel(const std::string& text);

// Renders the shot and follows the pixel. The picture and its record are what `render` gives for the same shot.
// Throws `Error` with exit code 2 for a pixel outside of the picture.
struct Followed {
  Picture picture;
  Trail trail;
};
Followed follow(Workbench& bench, const Shot& shot, int x, int y, const std::function<void(int, int)>& progress = {},
                bool id_coverage = false);

// Numbers that are not finite are the texts "nan", "inf" and "-inf"; all others read back to the same 32-bit float.
Json toJson(const Trail& trail);

// Aligned text; floats with as few digits as read back to the same.
std::string tableOf(const Trail& trail);

}  // namespace strobe::lab
