// SPDX-License-Identifier: MIT
// Shots and settings of experiments and captures. scripts/strobe/shots.lua checks them before they are read here.
#pragma once

#include "base/home.h"
#include "image/tone.h"
#include "lab/shot.h"

namespace strobe::lab {

// Pipeline with settings, and its name in results.
struct Arm {
  std::string name, pipeline;
  script::Settings sets;
};
// Arm from { name, pipeline, set }; a pipeline in a file may be beside the script.
Arm armFrom(const Json& json, const Path& script);

// Settings in json[name], a list of { name, value }, with `prefix` before each name. Empty if the list is missing.
script::Settings settingsFrom(const Json& json, const char* name, const std::string& prefix = "");

// Sets options from a list of { name, value }; skips unknown names. Throws `Error` (exit code 2) for a value that an
// option does not accept.
void setOptions(Shot& shot, const Json& options);

// Path of a .lua, .glb or .gltf file that a script names: beside the script if it exists there, otherwise `name`.
std::string besideScript(const Path& script, const std::string& name);

// File of a scene; "shared:FILE" is in the shared data.
struct SceneFile {
  std::string scene;    // value for `Shot::scene`
  std::string shared;   // FILE of "shared:FILE", or ""
  std::string missing;  // reason if the file is missing, or ""
};
SceneFile sceneFile(const Home& home, const std::string& scene);

// Tone map from `stops` and `curve` of a shot.
image::ToneMap toneFrom(const Json& json);

// Frames of a sequence from `frames`: { from, to, step }, both ends inclusive. Empty without `frames`.
std::vector<int> framesFrom(const Json& json);

// File name for a label, in lower case with "_" for other characters: "Half-split" becomes "half_split".
std::string fileNameOf(const std::string& label);

}  // namespace strobe::lab
