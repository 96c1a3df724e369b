// SPDX-License-Identifier: MIT
// Run record: the inputs that reproduce a picture, and the hash of each image. Timings are kept separately.
#pragma once

#include "lab/drawing.h"

namespace strobe::lab {

// Run record of a drawn frame.
Json makeRecord(const Home& home, const Shot& shot, const Drawing& drawing, const gpu::DeviceInfo& device,
                const graph::FrameResult& frame);

// Timings: GPU milliseconds per pass and per frame; wall-clock seconds of loading the scene, preparation and drawing;
// peak memory of the process, bytes.
Json makeTimings(const graph::FrameResult& frame, const gpu::DeviceInfo& device, const HeldScene& scene,
                 double prepare_s, double draw_s);

// Attribution of the scene in a record: its copyright, otherwise the first line of the text beside it, or "".
std::string attributionOf(const Json& record);

// Revision of the program: hash of the executable file.
const std::string& programHash();

// Hash of the format, size and texels of an image.
std::string hashOf(const graph::ReadImage& image);

}  // namespace strobe::lab
