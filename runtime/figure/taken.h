// SPDX-License-Identifier: MIT
// Pictures as a capture took them, for the figures and films made of them.
#pragma once

#include <functional>
#include <map>
#include <memory>

#include "image/tone.h"
#include "lab/workbench.h"

namespace strobe::figure {

// A shot drawn by an arm, at one step of a sequence (0 where the shot has none).
struct Taken {
  std::string shot, arm;
  int step = 0;
  std::shared_ptr<const lab::Picture> picture;  // outputs, and every pass's output among the taps ("node.port")
  image::ToneMap tone;                          // how it is shown
  std::map<std::string, int> divides;           // frame pixels per texel and axis of each image (lab::divideOf)
  std::map<std::string, dvec3> nodes_ws;        // where each node of the scene is at the raster time, metres
};

// So many pictures found last are in memory.
inline constexpr size_t kPicturesFound = 8;

// The picture stays valid until `kPicturesFound` others were asked for. Throws `Error` for a shot or an arm that there
// is not.
using FindTaken = std::function<const Taken&(const std::string& shot, const std::string& arm, int step)>;

}  // namespace strobe::figure
