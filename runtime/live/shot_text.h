// SPDX-License-Identifier: MIT
// Shots as Lua has them, for the experiments and captures that the window writes.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "lab/shot_options.h"
#include "lab/workbench.h"

namespace strobe::live {

// The options that the scene of a shot suggests where a home has these files; its script may leave them out. Throws
// `Error` where the scene's script does not run.
lab::Shot suggestedShot(const Home& home, const lab::Shot& shot, const script::Limits& limits);

using LeftOut = std::function<bool(const std::string& name)>;  // an empty one leaves out nothing

// The options of a shot that differ from another's, without scene and size.
std::vector<std::string> optionFields(const lab::Shot& shot, const lab::Shot& from, const LeftOut& left_out);
// Settings of the scene, or of the pipeline; the last of a name counts.
std::vector<std::string> settingFields(const script::Settings& sets, bool of_scene, const LeftOut& left_out);

}  // namespace strobe::live
