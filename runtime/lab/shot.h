// SPDX-License-Identifier: MIT
// What a frame is taken of and how: the options every command shares (app/shot_options.cpp), with their defaults.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "base/json.h"
#include "script/evaluate.h"
#include "shader/interface.h"

namespace strobe::lab {

struct Shot {
  std::string scene = "living_room";  // a name below scripts/scenes, a .lua, .glb or .gltf file
  std::string pipeline;               // a name below scripts/pipelines or a .lua file
  script::Settings sets;              // `--set`, in order
  int width = 0, height = 0;          // pixels; 0: what the scene asks for, else 960x540
  double fps = 0;                     // 0: what the scene asks for, else 24
  int frame = -1;                     // the capture is at frame / fps seconds; -1: what the scene asks for, else 1
  double exposure = -1;               // shutter open time in frame intervals; -1: what the scene asks for, else 0.5
  std::string anchor = "close";       // "close", "centre", "open": the window relative to the capture
  std::string camera;                 // "" takes the scene's first
  // Instead of the camera's pose: it stands at the first three (metres), looks at the last three, y is up, all through.
  std::optional<std::array<double, 6>> view;
  std::string animation = "all";
  std::vector<std::string> moves, spins;  // NODE=dx,dy,dz and NODE=ax,ay,az,deg per frame
  int rest_frame = -1;                    // at which nodes of the two are at rest; -1: `frame`
  int aa = 1;                             // sub-pixel camera offsets, averaged
  uint32_t seed = 0;
  std::string device;
  std::string backend = "auto";   // "pipeline", "query", "auto": query where there is one
  std::vector<std::string> taps;  // "node.port" to keep as well

  double captureTime() const { return frame / fps; }
  double restTime() const { return (rest_frame < 0 ? frame : rest_frame) / fps; }
  // Start and end of the exposure window, seconds.
  std::array<double, 2> window() const;
};

// Checks ranges; throws `Error` with exit code 2 naming the option.
void checkShot(const Shot& shot);

// Everything that decides the picture, for the run record.
Json toJson(const Shot& shot);

// The shot of a run record (what `toJson` gave). Throws `Error` naming the file for anything else.
Shot shotFromRecord(const Path& record);

// One line for a shell that makes the same picture.
std::string commandOf(const Shot& shot);

// Sets `name` among `sets` to `value`, in the place of earlier settings of it.
void putSetting(script::Settings& sets, const std::string& name, const std::string& value);

// An option of a shot that has one value, as the command line spells it without "--".
struct ShotOption {
  plan::ParamDesc declaration;  // choices that depend on the scene (camera, animation) are not filled in
  plan::Value (*get)(const Shot& shot);
  void (*set)(Shot& shot, const plan::Value& value);
};
const std::vector<ShotOption>& shotOptions();

// "ex,ey,ez,tx,ty,tz", of two different points.
std::array<double, 6> parseView(const std::string& text);
std::string viewText(const std::array<double, 6>& view);

// ANCHOR_* of shaders/shared/frame.h.
uint32_t anchorCode(const std::string& anchor);

// "WxH" in pixels, each 1 to 16384.
std::array<int, 2> parseSize(const std::string& text, const std::string& option = "--size");

}  // namespace strobe::lab
