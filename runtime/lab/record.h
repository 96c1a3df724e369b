// SPDX-License-Identifier: MIT
// The run record: what it takes to make a picture again, and the hash of each image it gave. Timings stand apart.
#pragma once

#include "lab/drawing.h"

namespace strobe::lab {

struct RecordContext {
  const Home& home;
  const Shot& shot;
  const Drawing& drawing;
  const gpu::DeviceInfo& device;
};

Json makeRecord(const RecordContext& context, const graph::FrameResult& frame);

// Milliseconds per pass and for the frame (GPU), seconds (wall clock) of loading the scene, of preparation and of
// drawing, and the most memory that the process has held so far.
Json makeTimings(const graph::FrameResult& frame, const gpu::DeviceInfo& device, const HeldScene& scene,
                 double prepare_s, double draw_s);

// What the scene of a record says of its author: its copyright, else the first line of the text beside it; or "".
std::string attributionOf(const Json& record);

// The revision of the program: the hash of its own file.
const std::string& programHash();

// Hash of an image's format, size and texels.
std::string hashOf(const graph::ReadImage& image);

}  // namespace strobe::lab
