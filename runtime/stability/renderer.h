// SPDX-License-Identifier: MIT
// Many small pictures on one device: each pipeline's settings are evaluated once, each scene once, and pictures that
// would come out the same are rendered once.
#pragma once

#include <list>
#include <map>
#include <memory>
#include <string>

#include "lab/workbench.h"

namespace strobe::stability {

// A pipeline evaluated with some settings, or why it cannot be.
struct Evaluated {
  std::shared_ptr<const plan::PipelineDesc> pipeline;  // null if refused
  std::string refusal;
};

// A pipeline does not take the settings; any other error is one of the scene or the program.
struct Refusal : Error {
  using Error::Error;
};

// What decides which pictures a plan makes: the plan without the names of the pipeline and of values nobody uses.
std::string identityOf(const plan::Plan& plan);

class Renderer {
 public:
  explicit Renderer(lab::Workbench& bench) : bench_(bench) {}

  lab::Workbench& bench() { return bench_; }
  const Evaluated& evaluate(const std::string& pipeline, const script::Settings& sets);
  // Colour of the shot, four channels. Throws `Refusal`, or `Error` for what cannot be loaded or built.
  std::shared_ptr<const image::Image> color(const lab::Shot& shot);
  // Forgets pictures of a pipeline; evaluations, scenes and pictures by other pipelines stay.
  void forgetPicturesOf(const std::string& pipeline);

  int rendered() const { return rendered_; }

 private:
  struct Planned {
    std::shared_ptr<const plan::Plan> plan;
    std::string identity;
  };
  const Planned& planOf(const lab::Shot& shot, graph::Backend backend);
  std::shared_ptr<lab::HeldScene> scene(lab::Shot& shot);

  lab::Workbench& bench_;
  std::map<std::string, Evaluated> evaluated_;
  std::map<std::string, Planned> plans_;
  std::list<std::pair<std::string, std::shared_ptr<lab::HeldScene>>> scenes_;  // used last first
  std::map<std::string, std::shared_ptr<const image::Image>> pictures_;
  int rendered_ = 0;
};

}  // namespace strobe::stability
