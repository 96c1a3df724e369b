// SPDX-License-Identifier: MIT
// What a frame is taken of and how: the options every command shares (app/shot_options.cpp), with their defaults.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "base/json.h"
#include "script/evaluate.h"
#include "shader/interface.h"

namespace strobe::lab {

struct Shot {
  std::string scene = "living_room";   // a name below scripts/scenes, a .lua, .glb or .gltf file
  std::string pipeline;                // a name below scripts/pipelines or a .lua file
  script::Settings sets;               // `--set`, in order
  int width = 0, height = 0;           // pixels; 0: what the scene asks for, else 960x540
  double fps = 0;                      // 0: what the scene asks for, else 24
  int frame = -1;                      // the capture is at frame / fps seconds; -1: what the scene asks for, else 1
  double exposure = -1;                // shutter open time in frame intervals; -1: what the scene asks for, else 0.5
  std::string anchor = "close";        // "close", "centre", "open": the window relative to the capture
  std::string camera;                  // "" takes the scene's first
  std::string animation = "all";
  std::vector<std::string> moves, spins;  // NODE=dx,dy,dz and NODE=ax,ay,az,deg per frame
  int aa = 1;                          // sub-pixel camera offsets, averaged
  uint32_t seed = 0;
  std::string device;
  std::string backend = "auto";        // "pipeline", "query", "auto": query where there is one
  std::vector<std::string> taps;       // "node.port" to keep as well

  double captureTime() const { return frame / fps; }
  // Start and end of the exposure window, seconds.
  std::array<double, 2> window() const;
};

// Checks ranges; throws `Error` with exit code 2 naming the option.
void checkShot(const Shot& shot);

// Everything that decides the picture, for the run record.
Json toJson(const Shot& shot);

// ANCHOR_* of shaders/shared/frame.h.
uint32_t anchorCode(const std::string& anchor);

// "WxH" in pixels, each 1 to 16384.
std::array<int, 2> parseSize(const std::string& text);

}  // namespace strobe::lab
