// SPDX-License-Identifier: MIT
// A camera that moves through points, as captures and films have it.
#pragma once

#include <array>
#include <string>
#include <vector>

namespace strobe::lab {

// Where the camera is at a frame (the first three, metres) and a point it looks at (the last three).
struct CameraKey {
  double frame = 0;
  std::array<double, 6> view{};
};

// Keys of texts "FRAME=EX,EY,EZ,TX,TY,TZ", by frame. Throws `Error` (exit code 2) for a text of another form, a camera
// that looks nowhere, and two keys of one frame.
std::vector<CameraKey> cameraKeys(const std::vector<std::string>& texts);

// Between the keys the cubic through them whose rate at a key is that from the key before to the one after (Catmull and
// Rom 1974, with frames as knots); before the first and after the last as fast as there. One key: a camera at rest.
std::array<double, 6> viewAt(const std::vector<CameraKey>& keys, double frame);

}  // namespace strobe::lab
