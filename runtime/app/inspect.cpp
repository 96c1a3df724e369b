// SPDX-License-Identifier: MIT
#include "app/inspect.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <set>

#include "app/shot_options.h"
#include "graph/pipelines.h"
#include "lab/workbench.h"
#include "page/table.h"
#include "plan/canonical.h"
#include "scene/json_scene.h"

namespace strobe::app {

namespace {

// Runs `step`, keeping what it complains about.
template <class Step>
void collect(std::vector<std::string>& problems, const Step& step) {
  try {
    step();
  } catch (const Error& error) {
    bool known = std::find(problems.begin(), problems.end(), error.what()) != problems.end();
    if (!known) problems.push_back(error.what());
  }
}

plan::PipelineDesc checkPipeline(const Home& home, const std::string& name, const script::Settings& sets,
                                 std::set<std::string>& checked) {
  plan::PipelineDesc pipeline = script::evaluatePipeline(home, {name, sets});
  lab::Shot shot;
  shot.width = 64;
  shot.height = 36;
  for (graph::Backend backend : {graph::Backend::Query, graph::Backend::Pipeline})
    graph::checkShaders(home, lab::planOf(shot, pipeline, backend), backend, checked);
  return pipeline;
}

// Does it choose among the files of a folder of passes?
bool choosesPasses(const Home& home, const plan::ParamDesc& param) {
  std::set<Path> folders;
  for (const Path& pass : home.namesBelow("passes", ".lua")) folders.insert(pass.parent_path());
  for (const Path& folder : folders) {
    std::vector<std::string> files = home.namesIn("passes" / folder, ".lua");
    auto is_file = [&](const auto& choice) { return std::find(files.begin(), files.end(), choice) != files.end(); };
    if (std::count_if(param.choices.begin(), param.choices.end(), is_file) > 1) return true;
  }
  return false;
}

script::Settings with(script::Settings sets, const std::string& name, const std::string& value) {
  sets.emplace_back(name, value);
  return sets;
}

// Every preset of a pipeline is a graph of its own, and in each of them every pass that can be chosen.
void checkShapes(const Home& home, const std::string& name, std::set<std::string>& checked,
                 std::vector<std::string>& problems) {
  collect(problems, [&] {
    plan::PipelineDesc pipeline = checkPipeline(home, name, {}, checked);
    std::vector<script::Settings> presets;
    for (const auto& param : pipeline.params)
      for (const std::string& choice : param.choices)
        if (param.name == "preset") presets.push_back({{"preset", choice}});
    if (presets.empty()) presets.push_back({});
    for (const script::Settings& preset : presets) {
      collect(problems, [&] { checkPipeline(home, name, preset, checked); });
      for (const auto& param : pipeline.params)
        for (const std::string& choice : choosesPasses(home, param) ? param.choices : std::vector<std::string>())
          collect(problems, [&] { checkPipeline(home, name, with(preset, param.name, choice), checked); });
    }
  });
}

// Everything in scripts/pipelines by name, and what looks into a picture, in scripts/inspect, by path.
std::vector<std::string> shippedPipelines(const Home& home) {
  std::vector<std::string> names = script::pipelineNames(home);
  const Path folder = "scripts/inspect";
  for (const std::string& name : home.namesIn(folder, ".lua"))
    names.push_back(home.at(folder / (name + ".lua")).string());
  return names;
}

struct CheckOptions {
  std::vector<std::string> files, sets;
  bool json = false;
};

void check(const Home& home, const CheckOptions& options) {
  const std::vector<std::string>& files = options.files;
  if (files.empty() && !options.sets.empty()) throw Error("--set needs a pipeline to set it in", {}, 2);
  script::Settings sets;
  for (const std::string& set : options.sets) sets.push_back(script::settingFromText(set));
  std::vector<std::string> problems;
  std::vector<std::string> pipelines = files.empty() ? shippedPipelines(home) : files;
  std::vector<std::string> scenes;
  if (files.empty()) {
    collect(problems, [&] { script::evaluateAllPasses(home); });
    scenes = script::sceneNames(home);
  }
  std::set<std::string> checked;
  for (const std::string& name : pipelines) {
    if (sets.empty()) checkShapes(home, name, checked, problems);
    else collect(problems, [&] { checkPipeline(home, name, sets, checked); });
  }
  for (const std::string& name : scenes)
    collect(problems, [&] { scene::sceneFromJson(script::evaluateScene(home, name, {}), name, lab::suggestions()); });
  if (options.json) {
    Json report;
    report["pipelines"] = pipelines;
    report["scenes"] = scenes;
    report["problems"] = problems;
    std::printf("%s\n", report.dump(2).c_str());
    if (!problems.empty()) throw Error(fmt::format("{} problems", problems.size()));
    return;
  }
  throwIfAny(problems);
  std::printf("%zu pipelines and %zu scenes are sound\n", pipelines.size(), scenes.size());
}

struct PlanOptions {
  ShotOptions shot;
  bool json = false;
};

void plan(const Home& home, const PlanOptions& options) {
  lab::Shot shot = options.shot.resolve();
  lab::fillShot(shot, {});
  lab::checkShot(shot);
  plan::PipelineDesc pipeline = script::evaluatePipeline(home, {shot.pipeline, shot.sets});
  graph::Backend backend = shot.backend == "pipeline" ? graph::Backend::Pipeline : graph::Backend::Query;
  plan::Plan planned = lab::planOf(shot, pipeline, backend);
  std::string text = options.json ? plan::toJson(planned).dump(2) + "\n" : plan::describe(planned);
  std::fputs(text.c_str(), stdout);
}

Json deviceJson(const gpu::DeviceInfo& info) {
  Json json = {{"name", info.name}, {"driver", info.driver}, {"api", info.api}, {"software", info.software}};
  json["backends"] = Json::array();
  if (info.ray_pipeline) json["backends"].push_back("pipeline");
  if (info.ray_query) json["backends"].push_back("query");
  json["missing"] = info.missing();
  for (const auto& feature : info.features)
    json["features"].push_back({{"name", feature.name},
                                {"provides", feature.provides},
                                {"required", feature.required},
                                {"present", feature.present}});
  return json;
}

std::string featuresOf(const gpu::DeviceInfo& info) {
  page::Table table{"", {"", "feature", "what it provides"}};
  for (const auto& feature : info.features)
    table.add({feature.present ? "  yes" : feature.required ? "  NO" : "  no", feature.name, feature.provides});
  return page::textOf(table);
}

void doctor(const Home& home, bool json) {
  std::vector<gpu::DeviceInfo> devices = gpu::listDevices();
  Json report;
  report["strobe"] = STROBE_VERSION;
  report["devices"] = Json::array();
  for (const auto& info : devices) report["devices"].push_back(deviceJson(info));
  auto data = home.data();
  report["shared_data"] = data ? Json(data->string()) : Json(nullptr);
  bool suffices = !devices.empty() && devices.front().missing().empty();
  report["suffices"] = suffices;
  if (json) {
    std::printf("%s\n", report.dump(2).c_str());
  } else {
    std::printf("strobe %s\n", STROBE_VERSION);
    for (size_t i = 0; i < devices.size(); ++i) {
      const auto& info = devices[i];
      std::printf("device %zu: %s (%s, Vulkan %s)%s\n", i, info.name.c_str(), info.driver.c_str(), info.api.c_str(),
                  info.software ? ", software: pictures are right, timings are not a GPU's" : "");
      std::fputs(featuresOf(info).c_str(), stdout);
      std::string missing = info.missing();
      std::printf("  %s\n", missing.empty() ? "suffices" : ("lacks " + missing).c_str());
    }
    std::printf("shared data: %s\n",
                data ? data->c_str() : "none (STROBE_DATA names its folder); tests that need it skip");
  }
  if (devices.empty())
    throw Error("no Vulkan device: install a driver (Debian: mesa-vulkan-drivers gives a software device)");
  if (!suffices) throw Error("no device suffices; Mesa 25's software device (Debian: bookworm-backports) does");
}

}  // namespace

void registerCheck(CLI::App& program, const Home& home) {
  auto options = std::make_shared<CheckOptions>();
  CLI::App* command = program.add_subcommand("check", "Validate scripts and shaders; needs no device");
  command->add_option("pipelines", options->files, "names or .lua files (default: everything that ships)");
  command
      ->add_option("--set", options->sets, "PARAM=VALUE: the pipeline with this alone, not with each preset and pass")
      ->allow_extra_args(false);
  command->add_flag("--json", options->json, "report as JSON");
  command->callback([options, &home] { check(home, *options); });
}

void registerPlan(CLI::App& program, const Home& home) {
  auto options = std::make_shared<PlanOptions>();
  CLI::App* command = program.add_subcommand("plan", "Print what a pipeline runs, in which order, on which memory");
  command->add_flag("--json", options->json, "the plan as data");
  options->shot.addWithPipeline(*command);
  command->callback([options, &home] { plan(home, *options); });
}

void registerDoctor(CLI::App& program, const Home& home) {
  auto json = std::make_shared<bool>(false);
  CLI::App* command = program.add_subcommand("doctor", "What this machine can do and what is missing");
  command->add_flag("--json", *json, "report as JSON");
  command->callback([json, &home] { doctor(home, *json); });
}

}  // namespace strobe::app
