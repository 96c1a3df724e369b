// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <future>
#include <memory>
#include <set>

#include "app/commands.h"
#include "app/files.h"
#include "app/shot_options.h"
#include "archive/capture_file.h"
#include "base/cores.h"
#include "base/lists.h"
#include "base/numbers.h"
#include "base/version.h"
#include "graph/pipelines.h"
#include "lab/frame.h"
#include "lab/workbench.h"
#include "page/table.h"
#include "plan/canonical.h"
#include "plan/dot.h"
#include "plan/facts.h"
#include "plan/settings.h"
#include "scene/json_scene.h"
#include "study/experiment.h"

namespace strobe::app {

namespace {

// Runs `step` and adds its error to `problems`. With `as_given`, rethrows errors with exit code 2: the command line is
// wrong.
template <class Step>
void collect(std::vector<std::string>& problems, const Step& step, bool as_given = false) {
  try {
    step();
  } catch (const Error& error) {
    if (as_given && error.exitCode() == 2) throw;
    addOnce(problems, std::string(error.what()));
  }
}

// Runs `check` in another thread. The future holds the problems that `check` adds to a list.
template <class Check>
std::future<std::vector<std::string>> beside(const Check& check) {
  return std::async(std::launch::async, [check] {
    std::vector<std::string> problems;
    check(problems);
    return problems;
  });
}

// Names of the passes in each folder below passes/.
std::vector<std::vector<std::string>> passFolders(const Home& home) {
  std::set<Path> folders;
  for (const std::string& pass : home.namesBelow("passes", ".lua")) folders.insert(Path(pass).parent_path());
  std::vector<std::vector<std::string>> names;
  for (const Path& folder : folders) names.push_back(home.namesIn("passes" / folder, ".lua"));
  return names;
}

// True if the parameter chooses between passes: two or more choices are files of one folder.
bool choosesPasses(const std::vector<std::vector<std::string>>& folders, const plan::ParamDesc& param) {
  return std::any_of(folders.begin(), folders.end(), [&](const std::vector<std::string>& files) {
    auto is_file = [&](const auto& choice) { return std::find(files.begin(), files.end(), choice) != files.end(); };
    return std::count_if(param.choices.begin(), param.choices.end(), is_file) > 1;
  });
}

script::Settings with(script::Settings sets, const std::string& name, const plan::Value& value) {
  sets.emplace_back(name, value);
  return sets;
}

// True if the parameter has an effect: it decides the graph, or a parameter of a node follows it.
bool counts(const plan::PipelineDesc& pipeline, const plan::ParamDesc& param) {
  auto follows = [&](const plan::NodeDesc& node) {
    return std::any_of(node.params.begin(), node.params.end(),
                       [&](const auto& bound) { return bound.second.follows == param.name; });
  };
  return plan::decidesGraph(pipeline, param.name) || std::any_of(pipeline.nodes.begin(), pipeline.nodes.end(), follows);
}

// Values of a parameter that may change the graph: passes to choose from, and the bounds of a compiled-in number.
std::vector<plan::Value> shapingValues(const std::vector<std::vector<std::string>>& folders,
                                       const plan::ParamDesc& param) {
  std::vector<plan::Value> values;
  if (choosesPasses(folders, param)) values.assign(param.choices.begin(), param.choices.end());
  if (!param.variant) return values;
  if (param.type == plan::ParamDesc::Type::Float) values = {*param.min, *param.max};
  if (param.type == plan::ParamDesc::Type::Int) values = {int64_t(*param.min), int64_t(*param.max)};
  return values;
}

// Presets of a pipeline, except its current preset.
std::vector<script::PipelineRequest> presetsOf(const std::string& name, const plan::PipelineDesc& pipeline) {
  std::vector<script::PipelineRequest> presets;
  for (const auto& preset : pipeline.presets)
    if (preset.name != pipeline.preset) presets.push_back({name, {{plan::kPresetSetting, preset.name}}});
  return presets;
}

// Requests for all values that may change the graph of `request`.
std::vector<script::PipelineRequest> shapesOf(const std::vector<std::vector<std::string>>& folders,
                                              const script::PipelineRequest& request,
                                              const plan::PipelineDesc& pipeline) {
  std::vector<script::PipelineRequest> shapes;
  for (const auto& param : pipeline.params) {
    if (!counts(pipeline, param)) continue;
    for (const plan::Value& value : shapingValues(folders, param))
      if (value != *plan::valueOf(pipeline, param.name))
        shapes.push_back({request.name_or_path, with(request.sets, param.name, value)});
  }
  return shapes;
}

// Plans the pipeline for every backend and adds the shaders of the plans.
void addPlans(const plan::PipelineDesc& pipeline, graph::ShaderCheck& shaders) {
  lab::Shot shot;
  shot.width = 64;
  shot.height = 36;
  for (const shader::BackendRow& row : shader::backends())
    shaders.add(lab::planOf(shot, pipeline, row.backend), row.backend);
}

// Checks pipelines. With `shapes`, also checks every preset of a sound pipeline, and every value that changes the graph
// of the pipeline or of a preset.
void checkPipelines(const Home& home, const std::vector<script::PipelineRequest>& requests, bool shapes,
                    std::vector<std::string>& problems) {
  graph::ShaderCheck shaders(home);
  const auto folders = passFolders(home);
  auto check_all = [&](const std::vector<script::PipelineRequest>& asked, const auto& look) {
    auto all = script::evaluatePipelines(home, asked);
    forEachOnAllCores(all.size(), [&](size_t i) {
      try {
        if (all[i].value) addPlans(*all[i].value, shaders);
      } catch (...) {
        all[i].error = std::current_exception();
      }
    });
    shaders.start();
    for (size_t i = 0; i < all.size(); ++i)
      collect(
          problems, [&] { look(asked[i], all[i].take()); }, &asked == &requests);
  };
  std::vector<script::PipelineRequest> presets, more;
  auto note = [](std::vector<script::PipelineRequest>& list, const std::vector<script::PipelineRequest>& added) {
    list.insert(list.end(), added.begin(), added.end());
  };
  auto note_shapes = [&](const script::PipelineRequest& request, const plan::PipelineDesc& pipeline) {
    note(more, shapesOf(folders, request, pipeline));
  };
  check_all(requests, [&](const script::PipelineRequest& request, const plan::PipelineDesc& pipeline) {
    if (!shapes) return;
    note(presets, presetsOf(request.name_or_path, pipeline));
    note_shapes(request, pipeline);
  });
  check_all(presets, note_shapes);
  check_all(more, [](const auto&, const auto&) {});
  for (const std::string& problem : shaders.finish()) addOnce(problems, problem);
}

void checkScenes(const Home& home, const std::vector<std::string>& names, std::vector<std::string>& problems) {
  auto scenes = script::evaluateScenes(home, names);
  for (size_t i = 0; i < scenes.size(); ++i)
    collect(problems, [&] {
      scene::checkScene(scenes[i].take(), names[i], lab::suggestions(), lab::filePlaces(home, names[i]));
    });
}

// Pipelines of scripts/pipelines by name, and pipelines of scripts/inspect by path.
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

void checkExperiment(const Home& home, const std::string& file) { study::readExperiment(home, file, true); }

void checkCapture(const Home& home, const std::string& file) {
  if (archive::readCapture(home, file).measured) checkExperiment(home, file);
}

// True if the file lies in that folder of the project. A project may itself lie below such a folder of another root.
bool liesInProject(const Home& home, const Path& file, const Path& folder) {
  const std::vector<Path> folders = home.folders(folder);
  return std::any_of(folders.begin(), folders.end(),
                     [&](const Path& one) { return liesIn(one, home.project()) && liesIn(file, one); });
}

// Experiments or captures of the project in a folder, without presets and libraries.
std::vector<std::string> ownFiles(const Home& home, const Path& folder) {
  std::vector<std::string> files;
  for (const std::string& name : home.namesBelow(folder, ".lua")) {
    Path file = home.at(folder / (name + ".lua"));
    bool is_own = liesInProject(home, file, folder) && file.parent_path().filename() != "lib";
    if (is_own && !isPreset(home, file)) files.push_back(file);
  }
  return files;
}

// Names or files to check.
struct Checked {
  std::vector<std::string> pipelines, scenes, experiments, captures;
};

// "experiment", "capture" or "". Returns "" for a pipeline, and for a file with a mistake: the check of pipelines
// reports it.
std::string kindOf(const Home& home, const std::string& name_or_file) {
  try {
    return hasExtension(name_or_file, ".lua") ? script::kindOfFile(home, name_or_file) : "";
  } catch (const Error&) {
    return "";
  }
}

Checked byKind(const Home& home, const std::vector<std::string>& files) {
  Checked checked;
  for (const std::string& file : files) {
    const std::string kind = kindOf(home, file);
    auto& list = kind == "experiment" ? checked.experiments : kind == "capture" ? checked.captures : checked.pipelines;
    list.push_back(file);
  }
  return checked;
}

// All shipped pipelines and scenes, and the scripts of the project.
Checked allFiles(const Home& home) {
  Checked checked{shippedPipelines(home), script::sceneNames(home), {}, {}};
  if (!home.hasProject()) return checked;
  throwIfAny(home.mistakesOfProject());
  checked.experiments = ownFiles(home, "experiments");
  checked.captures = ownFiles(home, "scripts/captures");
  return checked;
}

// "1 pipeline and 2 experiments are sound".
std::string soundText(const Checked& checked) {
  std::vector<std::string> counts;
  size_t total = 0;
  for (const auto& [names, what] :
       {std::pair(&checked.pipelines, "pipeline"), std::pair(&checked.scenes, "scene"),
        std::pair(&checked.experiments, "experiment"), std::pair(&checked.captures, "capture")}) {
    if (!names->empty()) counts.push_back(countText(names->size(), what));
    total += names->size();
  }
  if (counts.empty()) counts.push_back("0 pipelines");
  return fmt::format("{} {} sound\n", fmt::join(counts, " and "), total == 1 ? "is" : "are");
}

// Numbers of the files of the project, then of the shipped files.
std::string soundTextByRoot(const Home& home, const Checked& checked) {
  Checked own, shipped;
  auto divide = [&](std::vector<std::string> Checked::*names, const char* folder) {
    for (const std::string& name : checked.*names) {
      const bool is_own = home.shown(home.at(Path(folder) / (name + ".lua"))).find(':') == std::string::npos;
      ((is_own ? own : shipped).*names).push_back(name);
    }
  };
  divide(&Checked::pipelines, "scripts/pipelines");
  divide(&Checked::scenes, "scripts/scenes");
  return fmt::format("{}: {}, {}, {}{}: {}", home.project().string(),
                     countText(checked.experiments.size(), "experiment"), countText(checked.captures.size(), "capture"),
                     soundText(own), home.shipped().string(), soundText(shipped));
}

void check(const Home& home, const CheckOptions& options) {
  const std::vector<std::string>& files = options.files;
  script::Settings sets;
  for (const std::string& set : options.sets) sets.push_back(script::settingFromText(set));
  const Checked checked = files.empty() ? allFiles(home) : byKind(home, files);
  if (!sets.empty() && (files.empty() || checked.pipelines.empty())) throw Error("--set needs a pipeline", {}, 2);
  std::vector<std::string> problems;
  for (const std::string& file : checked.experiments) collect(problems, [&] { checkExperiment(home, file); });
  for (const std::string& file : checked.captures) collect(problems, [&] { checkCapture(home, file); });
  std::vector<std::future<std::vector<std::string>>> passes_and_scenes;
  if (files.empty()) {
    passes_and_scenes.push_back(
        beside([&](auto& problems) { collect(problems, [&] { script::evaluateAllPasses(home); }); }));
    passes_and_scenes.push_back(beside([&](auto& problems) { checkScenes(home, checked.scenes, problems); }));
  }
  std::vector<script::PipelineRequest> requests;
  for (const std::string& name : checked.pipelines) requests.push_back({name, sets});
  checkPipelines(home, requests, sets.empty(), problems);
  for (auto& some : passes_and_scenes)
    for (const std::string& problem : some.get()) addOnce(problems, problem);
  if (options.json) {
    Json report;
    report["roots"] = home.roots();
    report["pipelines"] = checked.pipelines;
    report["scenes"] = checked.scenes;
    report["experiments"] = checked.experiments;
    report["captures"] = checked.captures;
    report["problems"] = problems;
    std::printf("%s\n", report.dump(2).c_str());
    if (!problems.empty()) throw Error(countText(problems.size(), "problem"));
    return;
  }
  throwIfAny(problems);
  const bool by_root = files.empty() && home.hasProject();
  std::fputs((by_root ? soundTextByRoot(home, checked) : soundText(checked)).c_str(), stdout);
}

struct PlanOptions {
  ShotOptions shot;
  bool json = false, dot = false;
};

// Size of the shot's scene.
std::string sizeText(const lab::Shot& shot, const scene::Scene& scene) {
  const std::vector<scene::Instance> instances = scene::instancesOf(scene);
  size_t triangles = 0;
  for (const scene::Instance& instance : instances)
    for (const scene::Geometry& geometry : scene.meshes[size_t(instance.mesh)].geometries)
      triangles += geometry.indices.size() / 3;
  return fmt::format("scene {}: {} in {}\n", shot.scene, countText(triangles, "triangle"),
                     countText(instances.size(), "instance"));
}

std::string motionText(const lab::Shot& shot, const graph::Frame& frame) {
  const scene::PixelArea& reach = frame.motion.moving_rect;
  return fmt::format("{}, in {}x{} of {}x{} px", frame.facts.camera_moves ? "the camera too" : "objects",
                     reach.x1 - reach.x0, reach.y1 - reach.y0, shot.width, shot.height);
}

// Facts of the frame, and the passes and memory that `planned` does not need. `whole`: the plan for any frame.
std::string factsText(const lab::Shot& shot, const graph::Frame& frame, const plan::Plan& planned,
                      const plan::Plan& whole) {
  std::string text = fmt::format("frame {} of {}\n", shot.frame, shot.scene);
  const std::string motion = motionText(shot, frame);
  for (const plan::Fact& fact : plan::facts()) {
    std::string holds = fact.name == "motion" ? "yes: " + motion : "yes";
    text += fmt::format("  {}: {}\n", fact.name, plan::lacks(planned, fact.name) ? "no, " + fact.absent : holds);
  }
  double mebibytes = double(plan::bytesAliased(whole) - plan::bytesAliased(planned)) / (1024.0 * 1024.0);
  return text + fmt::format("  not required: {} of {} passes, {:.1f} MiB of images\n",
                            whole.nodes.size() - planned.nodes.size(), whole.nodes.size(), mebibytes);
}

void plan(const Home& home, const PlanOptions& options) {
  lab::Shot in_scene = options.shot.resolve(), shot = in_scene;
  const std::shared_ptr<lab::HeldScene> held = lab::loadScene(home, in_scene);
  lab::fillShot(shot, {});
  lab::checkShot(shot);
  plan::PipelineDesc pipeline = script::evaluatePipeline(home, {shot.pipeline, shot.sets});
  // The plan is the same for all backends that trace rays in compute.
  graph::Backend backend = shot.backend == "pipeline" ? graph::Backend::Pipeline : graph::Backend::Query;
  const graph::Frame frame = lab::frameOf(in_scene, held->scene, plan::earlierFrames(pipeline));
  plan::Plan planned = lab::planOf(shot, pipeline, backend, lab::absentFacts(frame, pipeline));
  std::string text = options.dot    ? plan::toDot(planned)
                     : options.json ? plan::toJson(planned).dump(2) + "\n"
                                    : plan::describe(planned);
  if (!options.dot && !options.json)
    text += factsText(in_scene, frame, planned, lab::planOf(shot, pipeline, backend)) + sizeText(in_scene, held->scene);
  std::fputs(text.c_str(), stdout);
}

Json deviceJson(const gpu::DeviceInfo& info) {
  Json json = {{"name", info.name}, {"driver", info.driver}, {"api", info.api}, {"software", info.software}};
  json["uuid"] = info.uuid;
  if (!info.pci.empty()) json["pci"] = info.pci;
  json["backends"] = Json::array();
  for (const shader::BackendRow& row : shader::backends())
    if (shader::isPresent(row, info)) json["backends"].push_back(row.name);
  json["missing"] = info.missing();
  for (const auto& feature : info.features)
    json["features"].push_back({{"name", feature.name},
                                {"provides", feature.provides},
                                {"required", feature.required},
                                {"present", feature.present}});
  return json;
}

std::string featuresOf(const gpu::DeviceInfo& info) {
  page::Table table{"", {"", "feature", "provides"}};
  for (const auto& feature : info.features)
    table.add({feature.present ? "  yes" : feature.required ? "  NO" : "  no", feature.name, feature.provides});
  return page::textOf(table);
}

// True if the processor has vectors of 512 bits and llvmpipe uses 256, according to its name. llvmpipe does not use the
// widest vectors on some processors.
bool mayBeWider([[maybe_unused]] const gpu::DeviceInfo& info) {
#ifdef __x86_64__
  const bool has_wider = __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512bw") &&
                         __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512vl");
  return has_wider && info.software && info.name.find("256 bits") != std::string::npos;
#else
  return false;
#endif
}

void doctor(const Home& home, bool json) {
  std::vector<std::string> driver_problems = gpu::driverProblems();
  std::vector<gpu::DeviceInfo> devices = gpu::listDevices();
  Json report;
  report["strobe"] = kVersion;
  report["devices"] = Json::array();
  for (const auto& info : devices) report["devices"].push_back(deviceJson(info));
  report["files"] = home.roots();
  auto data = home.data();
  report["shared_data"] = data ? Json(data->string()) : Json(nullptr);
  report["cache"] = home.cache().empty() ? Json(nullptr) : Json(home.cache().string());
  bool suffices = !devices.empty() && devices.front().missing().empty();
  report["suffices"] = suffices;
  report["driver_problems"] = driver_problems;
  if (json) {
    std::printf("%s\n", report.dump(2).c_str());
  } else {
    std::printf("strobe %s\n", kVersion);
    for (size_t i = 0; i < devices.size(); ++i) {
      const auto& info = devices[i];
      std::printf("device %zu: %s (%s, Vulkan %s)%s\n", i, info.name.c_str(), info.driver.c_str(), info.api.c_str(),
                  info.software ? ", software: pictures are right, timings are not a GPU's" : "");
      std::printf("  UUID %s%s\n", info.uuid.c_str(), info.pci.empty() ? "" : (", PCI " + info.pci).c_str());
      std::fputs(featuresOf(info).c_str(), stdout);
      std::string missing = info.missing();
      std::printf("  %s\n", missing.empty() ? "suffices" : ("lacks " + missing).c_str());
      if (mayBeWider(info))
        std::puts(
            "  the processor has vectors of 512 bits: LP_NATIVE_VECTOR_WIDTH=512 gives the same pictures, and truth in "
            "less time");
    }
    for (const std::string& problem : driver_problems) std::printf("driver not loaded: %s\n", problem.c_str());
    for (const Path& root : home.roots()) std::printf("files: %s\n", root.c_str());
    std::printf("shared data: %s\n", data ? data->c_str() : "none (STROBE_DATA names its folder)");
    std::printf("compiled shaders, painted textures: %s\n", home.cache().empty() ? "not kept" : home.cache().c_str());
  }
  std::string unloaded =
      driver_problems.empty() ? "" : fmt::format("a driver did not load: {}", fmt::join(driver_problems, "; "));
  std::string more = unloaded.empty() ? "" : "; " + unloaded;
  if (devices.empty())
    throw Error("no Vulkan device: install a driver (Debian: mesa-vulkan-drivers gives a software device)" + more);
  if (!suffices)
    throw Error("no device meets the requirements; Mesa 25's software device (Debian: bookworm-backports) does" + more);
  if (!unloaded.empty()) throw Error(unloaded);
}

}  // namespace

void registerCheck(CLI::App& program, const Home& home) {
  auto options = std::make_shared<CheckOptions>();
  CLI::App* command = program.add_subcommand("check", "Validate scripts and shaders; needs no device");
  command->add_option("pipelines", options->files,
                      "names of pipelines, or .lua files of pipelines, experiments, captures (default: everything that "
                      "ships)");
  command
      ->add_option("--set", options->sets,
                   "PARAM=VALUE: check the pipelines with this setting only, not with each preset and pass")
      ->allow_extra_args(false);
  command->add_flag("--json", options->json, "report as JSON");
  command->callback([options, &home] { check(home, *options); });
}

void registerPlan(CLI::App& program, const Home& home) {
  auto options = std::make_shared<PlanOptions>();
  CLI::App* command = program.add_subcommand("plan", "Print the passes of a pipeline, their order and their memory");
  CLI::Option* json = command->add_flag("--json", options->json, "print the plan as JSON");
  command->add_flag("--dot", options->dot, "print the graph for Graphviz: | dot -Tsvg")->excludes(json);
  options->shot.addWithPipeline(*command);
  command->callback([options, &home] { plan(home, *options); });
}

void registerDoctor(CLI::App& program, const Home& home) {
  auto json = std::make_shared<bool>(false);
  CLI::App* command = program.add_subcommand("doctor", "List Vulkan devices, their features and missing requirements");
  command->add_flag("--json", *json, "report as JSON");
  command->callback([json, &home] { doctor(home, *json); });
}

}  // namespace strobe::app
