// SPDX-License-Identifier: MIT
// A shot: scene, pipeline and options of a frame. The table in lab/shot_options.h has all options with ranges and
// defaults; record, command and identity derive from it.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "base/json_fwd.h"
#include "script/evaluate.h"

namespace strobe::lab {

// Scene, pipeline, settings and options of one picture. Numbers with the initial value here are unset: the scene may
// suggest a value, otherwise the default of the table holds.
struct Shot {
  std::string scene = "living_room";  // name below scripts/scenes, or a .lua, .glb or .gltf file
  std::string pipeline;               // name below scripts/pipelines, or a .lua file
  script::Settings sets;              // `--set`, in order
  int width = 0, height = 0;          // pixels
  double fps = 0;
  int frame = -1;             // the raster time is frame / fps seconds
  double exposure = -1;       // exposure time, frame intervals
  double exposure_time = -1;  // exposure time, seconds; if set, `exposure` is computed from it
  std::string anchor = "end";
  std::string shutter_curve = "box";        // weight over the exposure (math/shutter_curve.h)
  double camera_blur = 1, object_blur = 1;  // share of the motion that blurs, 0 to 1
  std::string follow;                       // node that blurs like the camera
  std::string cuts;           // times at which everything jumps, seconds, in addition to the scene's; "" for no cut
  std::string motion_depths;  // range of view depths that blur (scene/depth_bounds.h); "" for all
  std::string camera;         // "" for the first camera of the scene
  // Replaces the camera pose: position (first three) and target point (last three), metres; y is up. Constant over
  // time.
  std::optional<std::array<double, 6>> view;
  std::vector<std::string> path;  // FRAME=ex,ey,ez,tx,ty,tz: keys of a camera path (lab/camera_path.h)
  std::string animation = "all";
  std::string variant;             // material variant of a glTF scene, or ""
  std::string faces = "material";  // "material": one-sided surfaces stay one-sided; "both": all surfaces have two sides
  bool allow_outside = false;      // files of the scene may lie outside its folder
  std::vector<std::string> moves, spins;  // NODE=dx,dy,dz and NODE=ax,ay,az,deg per frame
  int rest_frame = -1;                    // frame without offset by `moves` and `spins`; -1: `frame`
  int aa = 1;                             // number of averaged sub-pixel samples
  uint32_t seed = 0;
  std::string device;
  std::string backend = "auto";
  std::vector<std::string> taps;  // additional images "node.port" to keep
  bool model_everything = false;  // also run passes that the scene does not require

  double rasterTime() const { return frame / fps; }
  double restTime() const { return (rest_frame < 0 ? frame : rest_frame) / fps; }
  // Length of the exposure, seconds.
  double exposureSeconds() const { return exposure_time >= 0 ? exposure_time : exposure / fps; }
  // Start and end of the exposure window, seconds.
  std::array<double, 2> window() const;
};

// Fills in unset options that a scene may suggest: from `shot` in the scene's description, otherwise with the default.
void fillShot(Shot& shot, const Json& description);

// Checks the ranges of options that are set. Throws `Error` (exit code 2) with the option.
void checkShot(const Shot& shot);

// JSON of all options that decide the picture, for the run record. Settings are values, not texts.
Json toJson(const Shot& shot);

// Shot of a run record (as from `toJson`; settings may be texts). Throws `Error` with the file for any other content.
Shot shotFromRecord(const Path& record);

// Word for a shell, quoted if necessary.
std::string shellWord(const std::string& text);

// Shell command, one line, that makes the same picture.
std::string commandOf(const Shot& shot);

// Identity of the picture: equal for two shots with equal pipeline, settings and options. Unset options count as unset,
// so fill in the shot first. Excludes device and taps.
std::string canonical(const Shot& shot);
// Part of the identity for the scene, and part for the frame (the view of the scene by any pipeline).
std::string sceneIdentity(const Shot& shot);
std::string frameIdentity(const Shot& shot);
// Identity of the pipeline settings or of the scene settings: the last value of each name, sorted by name.
std::string settingsIdentity(const script::Settings& sets, bool of_scene);

// True for a scene setting: the name begins with "scene.".
bool isOfScene(const script::Setting& setting);
script::Settings sceneSettings(const script::Settings& sets);
script::Settings pipelineSettings(const script::Settings& sets);  // all others

// Sets `name` to `value` in `sets`; removes earlier settings of `name`.
void putSetting(script::Settings& sets, const std::string& name, const plan::Value& value);

// Sets the pipeline parameter with this role in `sets`. Does nothing if the pipeline lacks the role.
void putRole(script::Settings& sets, const plan::PipelineDesc& pipeline, plan::Role role, const plan::Value& value);

// Display text of a value; whole numbers without ".0".
std::string plainText(const plan::Value& value);
std::string plainText(const plan::ParamDesc& param, const plan::Value& value);  // "auto" for the number kAuto

// ANCHOR_* code of an anchor (shaders/shared/frame.h).
uint32_t anchorCode(const std::string& anchor);

}  // namespace strobe::lab
