// SPDX-License-Identifier: MIT
// What a frame is taken of and how. Which options there are, with ranges and defaults: lab/shot_options.h; record,
// command and identity follow from that table.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "base/json_fwd.h"
#include "script/evaluate.h"

namespace strobe::lab {

// Numbers left at what stands here are left to the scene, which may suggest them, or to the table's defaults.
struct Shot {
  std::string scene = "living_room";  // a name below scripts/scenes, a .lua, .glb or .gltf file
  std::string pipeline;               // a name below scripts/pipelines or a .lua file
  script::Settings sets;              // `--set`, in order
  int width = 0, height = 0;          // pixels
  double fps = 0;
  int frame = -1;             // the capture is at frame / fps seconds
  double exposure = -1;       // shutter open time in frame intervals
  double exposure_time = -1;  // the same in seconds, where that was asked for: `exposure` follows from it
  std::string anchor = "end";
  std::string shutter_curve = "box";        // how much the times of the exposure count (math/shutter_curve.h)
  double camera_blur = 1, object_blur = 1;  // shares of their motion that blur
  std::string follow;                       // a node that blurs as the camera does
  std::string cuts;                         // seconds at which everything jumps, beside the scene's own; "" none
  std::string motion_depths;                // between which motion blurs (scene/depth_bounds.h); "" all
  std::string camera;                       // "" takes the scene's first
  // Instead of the camera's pose: it stands at the first three (metres), looks at the last three, y is up, all through.
  std::optional<std::array<double, 6>> view;
  std::vector<std::string> path;  // FRAME=ex,ey,ez,tx,ty,tz: a camera that moves through them (lab/camera_path.h)
  std::string animation = "all";
  std::string variant;                    // of a glTF scene's materials; "" for none
  std::string faces = "material";         // whether what is seen from one side alone is seen from both
  bool allow_outside = false;             // files of the scene may lie outside of its folder
  std::vector<std::string> moves, spins;  // NODE=dx,dy,dz and NODE=ax,ay,az,deg per frame
  int rest_frame = -1;                    // at which nodes of the two are at rest; -1: `frame`
  int aa = 1;                             // sub-pixel camera offsets, averaged
  uint32_t seed = 0;
  std::string device;
  std::string backend = "auto";
  std::vector<std::string> taps;  // "node.port" to keep as well
  bool model_everything = false;  // what the scene does not require is run too

  double captureTime() const { return frame / fps; }
  double restTime() const { return (rest_frame < 0 ? frame : rest_frame) / fps; }
  // Length of the exposure, seconds.
  double exposureSeconds() const { return exposure_time >= 0 ? exposure_time : exposure / fps; }
  // Start and end of the exposure window, seconds.
  std::array<double, 2> window() const;
};

// Fills in what the shot leaves open and a scene may suggest, from `shot` in the scene's description, else by default.
void fillShot(Shot& shot, const Json& description);

// Checks ranges of what is not left open; throws `Error` with exit code 2 naming the option.
void checkShot(const Shot& shot);

// Everything that decides the picture, for the run record; settings are values, not texts.
Json toJson(const Shot& shot);

// The shot of a run record (what `toJson` gave; settings may be texts). Throws `Error` naming the file for anything
// else.
Shot shotFromRecord(const Path& record);

// A word as a shell reads it back, quoted where it would not be taken as it stands.
std::string shellWord(const std::string& text);

// One line for a shell that makes the same picture.
std::string commandOf(const Shot& shot);

// Identity: equal where two shots ask for the same picture by the same pipeline and settings. What a shot leaves open
// counts as left open, so fill it in first. Device and taps are no part of it.
std::string canonical(const Shot& shot);
// What of it decides the scene, and what says how a frame of any pipeline sees a scene.
std::string sceneIdentity(const Shot& shot);
std::string frameIdentity(const Shot& shot);
// Settings of the pipeline (or of the scene), the last of each name, sorted.
std::string settingsIdentity(const script::Settings& sets, bool of_scene);

// Settings whose names begin with "scene." are the scene's.
bool isOfScene(const script::Setting& setting);
script::Settings sceneSettings(const script::Settings& sets);

// Sets `name` among `sets` to `value`, in the place of earlier settings of it.
void putSetting(script::Settings& sets, const std::string& name, const plan::Value& value);

// The same for the pipeline's parameter of that role; nothing where it has none.
void putRole(script::Settings& sets, const plan::PipelineDesc& pipeline, plan::Role role, const plan::Value& value);

// A value as people write it: a whole number without ".0".
std::string plainText(const plan::Value& value);
std::string plainText(const plan::ParamDesc& param, const plan::Value& value);  // "auto" where it is held as a number

// ANCHOR_* of shaders/shared/frame.h.
uint32_t anchorCode(const std::string& anchor);

}  // namespace strobe::lab
