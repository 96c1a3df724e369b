// SPDX-License-Identifier: MIT
// A pixel whose trail stays in sight while values change.
#pragma once

#include "lab/trail.h"

namespace strobe::live {

// A line of a pixel's trail, as a table shows it.
struct TrailLine {
  bool heading = false;  // a surface its ray meets, rather than an image
  std::string name, value, meaning;
  std::string doc;  // the rest: format, size, texel
};

class PinnedPixel {
 public:
  // The bench must outlive it.
  explicit PinnedPixel(lab::Workbench& bench) : bench_(bench) {}

  // Throws `Error` for a pixel outside of the shot, or where its trail cannot be followed.
  void pin(const lab::Shot& shot, int x, int y);
  void unpin();
  // Follows the pinned pixel, if any, in another shot; a pixel outside of it is let go.
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
