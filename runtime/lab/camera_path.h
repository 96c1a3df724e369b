// SPDX-License-Identifier: MIT
// Camera path through key views, for captures and films.
#pragma once

#include <array>
#include <string>
#include <vector>

namespace strobe::lab {

// Camera position (first three numbers) and target point (last three) at a frame, metres.
struct CameraKey {
  double frame = 0;
  std::array<double, 6> view{};
};

// Parses keys "FRAME=EX,EY,EZ,TX,TY,TZ"; returns them sorted by frame. Throws `Error` (exit code 2) for malformed text,
// a target equal to the position, and two keys of one frame.
std::vector<CameraKey> cameraKeys(const std::vector<std::string>& texts);

// View at a frame. Between keys: Catmull-Rom spline (1974) with the frames as knots; the rate at a key is the mean rate
// from the previous key to the next one. Outside the keys: linear extrapolation. One key: static camera.
std::array<double, 6> viewAt(const std::vector<CameraKey>& keys, double frame);

}  // namespace strobe::lab
