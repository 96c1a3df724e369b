// SPDX-License-Identifier: MIT
// Evaluation of Lua files to plain data. Each evaluation has a process of its own with limits on processor time, memory
// and wall clock (script/server.h). The result is validated before use. Drawing does not run Lua. All functions are
// thread-safe.
#pragma once

#include <exception>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/home.h"
#include "base/json.h"
#include "plan/description.h"

namespace strobe::script {

// `--set NAME=VALUE` in order; the last value of a name counts. A text may stand for the value that it reads as.
using Setting = std::pair<std::string, plan::Value>;
using Settings = std::vector<Setting>;

// Setting from user input "NAME=VALUE". Throws `Error` (exit code 2) naming `option` if the text has another form.
Setting settingFromText(const std::string& text, const std::string& option = "--set");

// A file that an evaluation read, or a folder that it listed. Records name the dependencies, and a reload watches them.
struct Dependency {
  Path path;          // absolute
  std::string shown;  // name as in `Home::shown`
  std::string hash;   // hash of its contents
};

// Hash of a file's text, or of the names in a folder; "" if the path does not exist.
std::string hashOfPath(const Path& path);

// Texts evaluated in place of the contents of files, by absolute path.
using Texts = std::map<std::string, std::string>;

// Resource limits of one script evaluation: processor time and wall clock time in seconds, Lua heap in MiB.
struct Limits {
  double cpu_s = 5;     // processor time
  double wall_s = 10;   // wall clock time until the child is killed
  int memory_mb = 256;  // limit of Lua's heap; the address space of the child is limited to twice as much
  bool operator==(const Limits&) const = default;
};

// Request to evaluate a pipeline's Lua file: its name or path, the settings, and texts to use in place of files.
struct PipelineRequest {
  std::string name_or_path;  // "x" for scripts/pipelines/x.lua, or a path that ends in ".lua"
  // "PARAM" of the pipeline (a preset may be a file "x.lua") or "NODE.PARAM". `evaluateScene` reads "scene.PARAM".
  Settings sets;
  Texts texts = {};
};

// A setting with an unknown name or a value that does not fit.
struct DroppedSetting {
  std::string name, value, reason;
};

// Evaluates a pipeline. With `dropped`, settings that do not fit are left out and listed there; otherwise they are
// errors.
// The evaluate functions throw `Error` with the places of the user's lines, for all mistakes of one table at once.
// `dependencies` is filled on failure too, so that a reload can wait for the next save.
plan::PipelineDesc evaluatePipeline(const Home& home, const PipelineRequest& request,
                                    std::vector<Dependency>* dependencies = nullptr, const Limits& limits = {},
                                    std::vector<DroppedSetting>* dropped = nullptr);

// Result of one of many evaluations: either `value` or `error`.
template <class Value>
struct Outcome {
  std::optional<Value> value;
  std::exception_ptr error;

  // Returns the value, or throws the error.
  Value take() {
    if (error) std::rethrow_exception(error);
    return std::move(*value);
  }
};

// Evaluates many pipelines on all cores. Outcomes in the order of `requests`.
std::vector<Outcome<plan::PipelineDesc>> evaluatePipelines(const Home& home,
                                                           const std::vector<PipelineRequest>& requests,
                                                           const Limits& limits = {});

// The plain data that a scene file returns, keys sorted; an empty table is an empty array. `name_or_path` is a name in
// scripts/scenes or a path that ends in ".lua". Settings with the prefix "scene." are in the global `scene_params`,
// without the prefix; a setting that the scene does not read is an error.
Json evaluateScene(const Home& home, const std::string& name_or_path, const Settings& sets,
                   std::vector<Dependency>* dependencies = nullptr, const Limits& limits = {}, const Texts& texts = {});
// Absolute folder of the files that a scene names. Throws `Error` like `evaluateScene` if the scene does not exist.
Path sceneFolder(const Home& home, const std::string& name_or_path);
std::vector<Outcome<Json>> evaluateScenes(const Home& home, const std::vector<std::string>& names_or_paths,
                                          const Limits& limits = {});

// "experiment" or "capture" if the file returns one; "" for other files.
std::string kindOfFile(const Home& home, const std::string& path);

// The plain data that another file returns (experiments, extreme cases). `arguments` is the value of `...` in its main
// chunk.
Json evaluateData(const Home& home, const std::string& path, const Json& arguments = {},
                  std::vector<Dependency>* dependencies = nullptr, const Limits& limits = {});

// All passes below passes/, sorted by name.
std::vector<plan::PassDesc> evaluateAllPasses(const Home& home, std::vector<Dependency>* dependencies = nullptr,
                                              const Limits& limits = {});

// Names of the pipelines in scripts/pipelines with that kind, sorted.
std::vector<std::string> pipelinesOfKind(const Home& home, plan::PipelineDesc::Kind kind, const Limits& limits = {});
// The first pipeline of that kind. Throws `Error` if the kind has no pipeline.
std::string pipelineOfKind(const Home& home, plan::PipelineDesc::Kind kind, const Limits& limits = {});

// Names of the files in scripts/pipelines and scripts/scenes, sorted.
std::vector<std::string> pipelineNames(const Home& home);
std::vector<std::string> sceneNames(const Home& home);

// Main function of `strobe --script-child ROOT...`, the server of script/server.h. Ends the process.
[[noreturn]] void runScriptChild(int argc, char** argv);

}  // namespace strobe::script
