// SPDX-License-Identifier: MIT
// Pixel with a trail that stays displayed while values change.
#pragma once

#include "lab/trail.h"

namespace strobe::live {

// Line in the table of a pixel's trail.
struct TrailLine {
  bool heading = false;  // first line of a surface on the pixel's ray
  std::string name, value, meaning;
  std::string doc;  // tooltip: format, size, texel
};

// Pixel pinned by the user, with the texel of each pass and the surfaces along its camera ray. Updated after each
// change of the shot.
class PinnedPixel {
 public:
  // `bench` must outlive this object.
  explicit PinnedPixel(lab::Workbench& bench) : bench_(bench) {}

  // Throws `Error` if the pixel is outside of the shot or the pixel's trail cannot be computed.
  void pin(const lab::Shot& shot, int x, int y);
  void unpin();
  // Updates the trail of the pinned pixel, if any, for another shot. Unpins a pixel outside of that shot.
  void follow(const lab::Shot& shot);

  std::optional<std::pair<int, int>> at() const { return at_; }
  std::vector<TrailLine> lines() const;
  Json json() const;  // throws `Error` without a pinned pixel
  const std::string& problem() const { return problem_; }

 private:
  lab::Workbench& bench_;
  std::optional<std::pair<int, int>> at_;
  std::optional<lab::Trail> trail_;
  std::string problem_;
};

}  // namespace strobe::live
