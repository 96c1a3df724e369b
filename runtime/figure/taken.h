// SPDX-License-Identifier: MIT
// Pictures of a capture, for the capture's figures and films.
#pragma once

#include <functional>
#include <map>
#include <memory>

#include "image/tone.h"
#include "lab/workbench.h"

namespace strobe::figure {

// Picture of a shot drawn by an arm, at one step of a sequence (0 without a sequence).
struct Taken {
  std::string shot, arm;
  int step = 0;
  std::shared_ptr<const lab::Picture> picture;  // outputs, and the outputs of all passes as taps ("node.port")
  image::ToneMap tone;                          // tone map for display
  std::map<std::string, int> divides;           // frame pixels per texel and axis of each image (lab::divideOf)
  std::map<std::string, dvec3> nodes_ws;        // position of each scene node at the raster time, world space, metres
};

// Number of pictures in memory. The pictures found last stay.
inline constexpr size_t kPicturesFound = 8;

// Returns a picture. It stays valid until `kPicturesFound` other pictures were found. Throws `Error` for an unknown
// shot or arm.
using FindTaken = std::function<const Taken&(const std::string& shot, const std::string& arm, int step)>;

}  // namespace strobe::figure
