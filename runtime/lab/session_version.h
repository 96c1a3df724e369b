// SPDX-License-Identifier: MIT
// What a session runs, for the files that implement it.
#pragma once

#include "lab/session.h"

namespace strobe::lab {

// Members are destroyed from the last: the graph goes before what it draws.
struct Session::Version {
  std::shared_ptr<HeldScene> scene;
  std::shared_ptr<scene::GpuScene> on_device;
  graph::Backend backend = graph::Backend::None;
  std::unique_ptr<plan::Plan> plan;
  std::string shape;
  std::string plan_hash;
  std::vector<script::Dependency> scripts;
  script::Texts texts;  // of the scripts, as they were evaluated
  std::unique_ptr<graph::Graph> graph;
};

}  // namespace strobe::lab
