// SPDX-License-Identifier: MIT
// Values of a shot that can change while it is drawn, for panels.
#pragma once

#include "lab/drawing.h"
#include "lab/shot_options.h"

namespace strobe::lab {

// Value of a shot that a panel can edit: its declaration, present value, group, origin and place of declaration, and
// the reason if the value has no effect.
struct Control {
  plan::ParamDesc declaration;  // `name` for `Session::set`: "exposure", "samples", "edge.depth_threshold"
  plan::Value value;
  std::string group;   // "shot", "pipeline", or the name of a node
  std::string origin;  // source of the value: "default", "preset best", "scene", "follows samples", "window", ...
  std::string place;   // place of the declaration, "file:line", or ""
  bool set = false;    // true if `origins` has the value
  std::string idle;    // reason why the value has no effect in the present plan, or ""
};

// All values of a drawn shot: shot options first, then pipeline parameters, then node parameters. `origins`: origin by
// name of each value that was set. `given_by`: origin of the shot.
std::vector<Control> controlsOf(const Shot& shot, const Drawing& drawing,
                                const std::map<std::string, std::string>& origins, const std::string& given_by);

// Declaration of a shot value, with the choices that the scene offers.
plan::ParamDesc declarationOf(const ShotField& field, const scene::Scene& scene);

}  // namespace strobe::lab
