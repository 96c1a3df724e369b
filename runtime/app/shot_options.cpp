// SPDX-License-Identifier: MIT
#include "app/shot_options.h"

#include <cstdlib>

namespace strobe::app {

void ShotOptions::addWithPipeline(CLI::App& command) {
  command.add_option("pipeline", shot.pipeline, "a name of scripts/pipelines or a .lua file");
  addTo(command);
  command.add_option("--record", record, "a run record: its shot instead of the defaults; options given beside it win");
}

void ShotOptions::addTo(CLI::App& command) {
  command_ = &command;
  command.add_option("--scene", shot.scene, "a name of scripts/scenes, a .lua, .glb or .gltf file")
      ->capture_default_str();
  command.add_option("--size", size, "WIDTHxHEIGHT in pixels (default: the scene's, else 960x540)");
  // Ranges are checked here: what a shot leaves to its scene is stored as values outside of them.
  command.add_option("--fps", shot.fps, "frames per second (default: the scene's, else 24)")
      ->check(CLI::Range(1e-3, 1e6));
  command.add_option("--frame", shot.frame, "the capture is at FRAME/FPS seconds (default: the scene's, else 1)")
      ->check(CLI::Range(0, 1000000));
  command.add_option("--exposure", shot.exposure, "shutter time in frame intervals (default: the scene's, else 0.5)")
      ->check(CLI::Range(0.0, 1000.0));
  command.add_option("--anchor", shot.anchor, "exposure window: close, centre or open")->capture_default_str();
  command.add_option("--camera", shot.camera, "a camera of the scene (default: its first)");
  command.add_option("--view", view, "EX,EY,EZ,TX,TY,TZ: camera at E, looking at T, instead of its pose in the scene");
  command.add_option("--animation", shot.animation, "a clip of the scene, all or none")->capture_default_str();
  command.add_option("--move", shot.moves, "NODE=dx,dy,dz: metres per frame in world axes")->allow_extra_args(false);
  command.add_option("--spin", shot.spins, "NODE=ax,ay,az,deg: degrees per frame about an axis")
      ->allow_extra_args(false);
  command
      .add_option("--rest-frame", shot.rest_frame, "frame at which --move and --spin are at rest (default: --frame)")
      ->check(CLI::Range(0, 1000000));
  command.add_option("--aa", shot.aa, "sub-pixel samples, each a full run of the pipeline")->capture_default_str();
  command.add_option("--samples", samples, "short for --set samples=N");
  command.add_option("--shading", shading, "short for --set shading=frozen|full");
  command.add_option("--set", sets, "PARAM=VALUE of the pipeline, NODE.PARAM=VALUE of a pass, scene.PARAM=VALUE")
      ->allow_extra_args(false);
  command.add_option("--tap", shot.taps, "NODE.PORT to write as well")->allow_extra_args(false);
  command.add_option("--seed", shot.seed, "of every random number")->capture_default_str();
  command.add_option("--device", shot.device, "index or part of the name of a Vulkan device");
  command.add_option("--backend", shot.backend, "how rays are traced: pipeline, query or auto")->capture_default_str();
}

std::pair<std::string, std::string> parseSetting(const std::string& text, const std::string& option) {
  size_t equals = text.find('=');
  if (equals == std::string::npos || equals == 0)
    throw Error(fmt::format("{} '{}' is not NAME=VALUE", option, text), {}, 2);
  return {text.substr(0, equals), text.substr(equals + 1)};
}

// The record's shot with what the command line gives put over it.
lab::Shot ShotOptions::recorded() const {
  lab::Shot resolved = lab::shotFromRecord(record);
  auto given = [this](const char* option) { return command_->count(option) > 0; };
  if (!shot.pipeline.empty()) resolved.pipeline = shot.pipeline;
  if (given("--scene")) resolved.scene = shot.scene;
  if (given("--fps")) resolved.fps = shot.fps;
  if (given("--frame")) resolved.frame = shot.frame;
  if (given("--exposure")) resolved.exposure = shot.exposure;
  if (given("--anchor")) resolved.anchor = shot.anchor;
  if (given("--camera")) resolved.camera = shot.camera;
  if (given("--animation")) resolved.animation = shot.animation;
  if (given("--move")) resolved.moves = shot.moves;
  if (given("--spin")) resolved.spins = shot.spins;
  if (given("--rest-frame")) resolved.rest_frame = shot.rest_frame;
  if (given("--aa")) resolved.aa = shot.aa;
  if (given("--seed")) resolved.seed = shot.seed;
  if (given("--backend")) resolved.backend = shot.backend;
  resolved.taps = shot.taps;
  resolved.device = shot.device;
  return resolved;
}

lab::Shot ShotOptions::resolve() const {
  lab::Shot resolved = record.empty() ? shot : recorded();
  if (resolved.pipeline.empty()) throw Error("a pipeline is required, or --record FILE", {}, 2);
  if (!view.empty()) resolved.view = lab::parseView(view);
  if (!size.empty()) {
    auto [width, height] = lab::parseSize(size);
    resolved.width = width;
    resolved.height = height;
  }
  if (samples) resolved.sets.push_back({"samples", std::to_string(samples)});
  if (!shading.empty()) resolved.sets.push_back({"shading", shading});
  for (const std::string& set : sets) resolved.sets.push_back(parseSetting(set));
  return resolved;
}

void addTev(CLI::App& command, std::string& address) {
  CLI::callback_t take = [&address](const std::vector<std::string>& given) {
    bool bare = given.empty() || given[0].empty();
    address = bare ? "localhost:14158" : given[0];
    return true;
  };
  command.add_option("--tev", take, "send outputs and taps to the viewer tev, if it runs (default: localhost:14158)")
      ->expected(0, 1)
      ->type_name("[HOST:PORT]");
}

bool validationWanted() {
  const char* value = std::getenv("STROBE_VALIDATION");
  return value && *value && std::string(value) != "0";
}

void refuseMessages(const gpu::Device& device) {
  std::vector<std::string> messages = device.takeMessages();
  for (std::string& message : messages) message = "Vulkan validation: " + message;
  throwIfAny(messages);
}

}  // namespace strobe::app
