// SPDX-License-Identifier: MIT
// A shot as a scene of Mitsuba 3, to render ground truth with programs that share no code with Strobe. Times in the
// file are shares of the exposure: 0 at shutter open, 1 at shutter close.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "base/files.h"
#include "scene/frame_poser.h"
#include "scene/scene.h"

namespace strobe::scene {

// Result of an export to Mitsuba 3: the written files, and descriptions of the contents that were left out.
struct MitsubaExport {
  std::vector<Path> files;            // scene.xml last
  std::vector<std::string> left_out;  // parts of the shot that the file cannot express, with their names
};

// Writes scene.xml, a binary PLY file for each geometry and an EXR file for each texture to `folder`.
// `pose_at`: the scene at a time, s. If all materials are unlit, the file requests an image of their colours;
// otherwise it requests direct light.
MitsubaExport exportMitsuba(const Scene& scene, const std::function<Pose(double)>& pose_at, const FrameView& frame,
                            const Path& folder);

}  // namespace strobe::scene
