// SPDX-License-Identifier: MIT
// Shots as Lua text, for the experiments and captures that the window writes.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "lab/shot_options.h"
#include "lab/workbench.h"

namespace strobe::live {

// Options that the shot's scene suggests with the files of `home`; a written script may omit them. Throws `Error` if
// the scene's script fails.
lab::Shot suggestedShot(const Home& home, const lab::Shot& shot, const script::Limits& limits);

using LeftOut = std::function<bool(const std::string& name)>;  // true to omit a field; an empty function omits nothing

// Fields of the options that differ between `shot` and `from`, without scene and size.
std::vector<std::string> optionFields(const lab::Shot& shot, const lab::Shot& from, const LeftOut& left_out);
// Fields of the settings of the scene or of the pipeline. The last value of a name counts.
std::vector<std::string> settingFields(const script::Settings& sets, bool of_scene, const LeftOut& left_out);

}  // namespace strobe::live
