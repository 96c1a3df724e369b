// SPDX-License-Identifier: MIT
// Shots and settings as experiments and captures have them, checked by scripts (scripts/strobe/shots.lua) and read
// here.
#pragma once

#include "base/home.h"
#include "image/tone.h"
#include "lab/shot.h"

namespace strobe::lab {

// json[name], a list of { name, value }, `prefix` before each name; nothing where there is none.
script::Settings settingsFrom(const Json& json, const char* name, const std::string& prefix = "");

// A list of { name, value } of options; throws `Error` (exit code 2) for a value that an option does not take.
void setOptions(Shot& shot, const Json& options);

// A file that a script names lies beside it, if there is one there; else the name as it is.
std::string besideScript(const Path& script, const std::string& name);

// A scene "shared:FILE" is one of the shared data.
struct SceneFile {
  std::string scene;    // as a shot has it
  std::string shared;   // FILE, or ""
  std::string missing;  // why it is not there, or ""
};
SceneFile sceneFile(const Home& home, const std::string& scene);

// `stops` and `curve` of a shot.
image::ToneMap toneFrom(const Json& json);

// { from, to, step }: the frames of a sequence; none where json has no `frames`.
std::vector<int> framesFrom(const Json& json);

// As much of `label` as makes a good file name: "Half-split" becomes "half_split".
std::string fileNameOf(const std::string& label);

}  // namespace strobe::lab
