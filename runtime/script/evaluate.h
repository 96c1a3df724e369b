// SPDX-License-Identifier: MIT
// Lua files to plain data. Every call evaluates in a child process of its own (the program starting itself, or for a
// `PipelineEvaluator` a copy of one that has loaded the scripts) with limits on processor time, memory and wall clock;
// what comes back is validated before anything uses it. Drawing needs no Lua.
#pragma once

#include <exception>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/home.h"
#include "base/json.h"
#include "plan/description.h"

namespace strobe::script {

// `--set NAME=VALUE` in order; of two for one name the later counts. A text serves as the value it reads as.
using Setting = std::pair<std::string, plan::Value>;
using Settings = std::vector<Setting>;

// What a user typed: "NAME=VALUE". Throws `Error` (exit code 2) naming `option` for anything else.
Setting settingFromText(const std::string& text, const std::string& option = "--set");

// A file an evaluation read, or a folder it listed: what a record names and what a reload watches.
struct Dependency {
  Path path;          // absolute
  std::string shown;  // as `Home::shown` has it
  std::string hash;   // of its content
};

// Of the file's text, or of the names in a folder; "" where there is neither.
std::string hashOfPath(const Path& path);

// Texts to evaluate instead of what the files of these absolute paths hold now.
using Texts = std::map<std::string, std::string>;

struct Limits {
  double cpu_s = 5;     // processor time
  double wall_s = 10;   // until the child is killed in any case
  int memory_mb = 256;  // of Lua's heap; the address space of the child is limited to twice that
  bool operator==(const Limits&) const = default;
};

// What an evaluation described: passes and parameters that the next one describes alike it only names.
struct Described {
  plan::Known known;
  std::vector<std::string> pass_hashes;  // of the descriptions of the passes as the child had them
  std::string params_hash;
};

struct PipelineRequest {
  std::string name_or_path;  // "x" for scripts/pipelines/x.lua, or a path that ends in ".lua"
  // "PARAM" of the pipeline (a preset may be a file "x.lua"), "NODE.PARAM"; "scene.PARAM" is left to `evaluateScene`.
  Settings sets;
  Texts texts = {};
};

// A setting that names nothing (any more) or has a value that does not fit.
struct DroppedSetting {
  std::string name, value, reason;
};

// With `dropped`, settings that do not fit are left out and listed there instead of being errors.
// All of these throw `Error` with the places of the user's lines, all mistakes of one table at once; `dependencies`
// is filled on failure too, so that a reload can wait for the next save. `described`: of an evaluation before, or null,
// then of this one, where it succeeds.
plan::PipelineDesc evaluatePipeline(const Home& home, const PipelineRequest& request,
                                    std::vector<Dependency>* dependencies = nullptr, const Limits& limits = {},
                                    std::vector<DroppedSetting>* dropped = nullptr,
                                    std::shared_ptr<const Described>* described = nullptr);

// What became of one of many: `error` is null where there is a `value`.
template <class Value>
struct Outcome {
  std::optional<Value> value;
  std::exception_ptr error;

  // The value, or the error thrown.
  Value take() {
    if (error) std::rethrow_exception(error);
    return std::move(*value);
  }
};

// Many at once, each as `evaluatePipeline` has it, with limits of its own, but without a program started for each.
class PipelineEvaluator {
 public:
  explicit PipelineEvaluator(const Home& home, const Limits& limits = {});
  ~PipelineEvaluator();

  // Outcomes in the order of `requests`. Each file is read once, for the first request that needs it. Not thread-safe.
  std::vector<Outcome<plan::PipelineDesc>> evaluate(const std::vector<PipelineRequest>& requests);
  // One, with what `dependencies` is for `evaluatePipeline`.
  plan::PipelineDesc evaluate(const PipelineRequest& request, std::vector<Dependency>* dependencies);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

// The plain data a scene file returns, keys sorted; an empty table is an empty array. `name_or_path` as above, of
// scripts/scenes. Those of `sets` that begin with "scene." are in the global `scene_params` (without that prefix);
// one that the scene never reads is an error.
Json evaluateScene(const Home& home, const std::string& name_or_path, const Settings& sets,
                   std::vector<Dependency>* dependencies = nullptr, const Limits& limits = {}, const Texts& texts = {});
// The file of a scene, absolute. Throws `Error` as `evaluateScene` does if the file does not exist.
Path sceneScript(const Home& home, const std::string& name_or_path);
std::vector<Outcome<Json>> evaluateScenes(const Home& home, const std::vector<std::string>& names_or_paths,
                                          const Limits& limits = {});

// "experiment" or "capture" of a file that returns one, else "".
std::string kindOfFile(const Home& home, const std::string& path);

// The plain data any other file returns (experiments, extreme cases); `arguments` is what `...` holds in its main
// chunk.
Json evaluateData(const Home& home, const std::string& path, const Json& arguments = {},
                  std::vector<Dependency>* dependencies = nullptr, const Limits& limits = {});

// Every pass below passes/, by name.
std::vector<plan::PassDesc> evaluateAllPasses(const Home& home, std::vector<Dependency>* dependencies = nullptr,
                                              const Limits& limits = {});

// The pipelines of scripts/pipelines that are of that kind, sorted.
std::vector<std::string> pipelinesOfKind(const Home& home, plan::PipelineDesc::Kind kind, const Limits& limits = {});
// The first of them. Throws `Error` where there is none.
std::string pipelineOfKind(const Home& home, plan::PipelineDesc::Kind kind, const Limits& limits = {});

// Names of the files in scripts/pipelines and scripts/scenes, sorted.
std::vector<std::string> pipelineNames(const Home& home);
std::vector<std::string> sceneNames(const Home& home);

// What `strobe --script-child` does: reads a request from stdin, writes the answer to stdout. Ends the process.
[[noreturn]] void runScriptChild();

}  // namespace strobe::script
