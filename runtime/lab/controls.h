// SPDX-License-Identifier: MIT
// The values of a shot that can be changed while it is drawn, as panels show them.
#pragma once

#include "lab/drawing.h"
#include "lab/shot_options.h"

namespace strobe::lab {

struct Control {
  plan::ParamDesc declaration;  // `name` as `Session::set` takes it: "exposure", "samples", "edge.depth_threshold"
  plan::Value value;
  std::string group;   // "shot", "pipeline", or the name of a node
  std::string origin;  // who set it: "default", "preset best", "scene", "follows samples", "window", ...
  std::string place;   // where it is declared, "file:line", or ""
  bool set = false;    // `origin` is one of those given
  std::string idle;    // why its value changes nothing as the plan stands, or ""
};

// Every value of a shot that is drawn: the shot's first, then the pipeline's, then the nodes' own. `origins` are those
// of values that were set, by name; `given_by` gave the shot.
std::vector<Control> controlsOf(const Shot& shot, const Drawing& drawing,
                                const std::map<std::string, std::string>& origins, const std::string& given_by);

// The declaration of a value of a shot with the choices that a scene gives it.
plan::ParamDesc declarationOf(const ShotField& field, const scene::Scene& scene);

}  // namespace strobe::lab
