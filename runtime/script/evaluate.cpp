// SPDX-License-Identifier: MIT
#include "script/evaluate.h"

#include <signal.h>

#include <algorithm>
#include <cstring>
#include <map>
#include <memory>
#include <mutex>
#include <unordered_map>

#include "base/cores.h"
#include "base/hash.h"
#include "base/json_text.h"
#include "script/server.h"

namespace strobe::script {

namespace fs = std::filesystem;

namespace {

// The main file of an evaluation.
struct Main {
  Path file;    // absolute; in a copy of a home, the copy
  Path folder;  // of the file itself: a copy may lack the models and pictures beside the file
  std::string shown;
  std::string name;  // without folder and ".lua"
  bool own_folder = false;
};

// True for modules in folders called lib, which are not main files.
bool isInLib(const Path& name) { return name.parent_path().filename() == "lib"; }

// Names of the main files below a folder: "bar", "oracles/bar".
std::vector<std::string> mainNames(const Home& home, const Path& folder) {
  std::vector<std::string> names = home.namesBelow(folder, ".lua");
  std::erase_if(names, isInLib);
  return names;
}

Main mainFile(const Home& home, const std::string& path, const Texts& texts = {}) {
  Main main;
  const Path file = fs::absolute(path).lexically_normal();
  main.file = copyOf(home, file);
  main.folder = file.parent_path();
  main.shown = home.shown(main.file == file ? Path(path) : main.file);
  main.name = main.file.stem();
  main.own_folder = true;
  if (texts.count(main.file) || fs::is_regular_file(main.file)) return main;
  if (!fs::is_directory(main.file)) throw Error("no such file", {path});
  const Path folder = main.file.has_filename() ? main.file : main.file.parent_path();
  const Path inside = Path(path) / (folder.filename().string() + ".lua");
  bool is_there = fs::is_regular_file(inside);
  throw Error(fmt::format("is a folder{}", is_there ? "; did you mean '" + inside.string() + "'?" : ""), {path});
}

// Message about an unknown name of a pipeline or scene: the nearest of `names`, or the folders searched.
std::string noneNamed(const Home& home, const std::string& name, const std::string& what,
                      const std::vector<std::string>& names) {
  std::error_code ignored;
  if (fs::is_regular_file(name, ignored))
    return fmt::format("'{}' is not a {}: a {} is a name, or a file that ends in {}", name, what, what,
                       what == "scene" ? ".lua, .glb or .gltf" : ".lua");
  std::string text = fmt::format("unknown {} '{}'", what, name), near = didYouMean(name, names);
  if (!near.empty()) return text + near;
  text += "; not found in " + placesText(home, Path("scripts") / (what + "s"));
  return home.hasProject() ? text
                           : text + fmt::format("; the current folder is not in a project ({})", Home::kProjectFile);
}

// `what` is "pipeline" or "scene"; its files are in scripts/<what>s. A path that does not exist in the current folder
// may exist in a root.
Main mainOf(const Home& home, const std::string& name_or_path, const std::string& what, const Texts& texts) {
  if (hasExtension(name_or_path, ".lua")) {
    const Path here = fs::absolute(name_or_path).lexically_normal();
    const bool is_here = texts.count(here) || fs::exists(here);
    return mainFile(home, is_here ? name_or_path : home.find(name_or_path).value_or(name_or_path).string(), texts);
  }
  Path folder = Path("scripts") / (what + "s");
  Path file = home.at(folder / (name_or_path + ".lua"));
  // The list of all names is not read if the file exists, because reading the list takes longer than the other steps.
  const Path name = name_or_path;
  bool is_name = !name.empty() && name.is_relative() && name_or_path == name.lexically_normal().string() &&
                 *name.begin() != ".." && !isInLib(name);
  if (!(is_name && fs::is_regular_file(file)) && !texts.count(file)) {
    throw Error(noneNamed(home, name_or_path, what, mainNames(home, folder)), {}, 2);
  }
  Main main = mainFile(home, file.string(), texts);
  main.own_folder = false;
  return main;
}

std::string outOfMemory(const Limits& limits) {
  return fmt::format("stopped: more than {} MB of memory (the limit for a script)", limits.memory_mb);
}

std::string endedBy(const ProgramEnd& child, const Limits& limits) {
  if (child.timed_out) return fmt::format("stopped: more than {} s (the limit for a script)", limits.wall_s);
  if (child.too_long) return "stopped: the result of the script is larger than 64 MB";
  if (child.signal == SIGXCPU) {
    const char* text = "stopped: more than {} s of processor time (the limit for a script); endless loop?";
    return fmt::format(fmt::runtime(text), limits.cpu_s);
  }
  if (child.exit_status == kOutOfMemory) return outOfMemory(limits);
  if (child.signal) return fmt::format("the script's process ended: {}", ::strsignal(child.signal));
  return fmt::format("the script's process ended with status {} and without an answer", child.exit_status);
}

std::vector<Dependency> dependenciesOf(const Json& files) {
  std::vector<Dependency> dependencies;
  for (const Json& file : files) {
    dependencies.push_back(
        {file.at("path").get<std::string>(), file.at("shown").get<std::string>(), file.at("hash").get<std::string>()});
  }
  return dependencies;
}

// `text` on one line, without control characters.
std::string plain(std::string text) {
  std::replace_if(
      text.begin(), text.end(), [](unsigned char c) { return c < 0x20 || c == 0x7f; }, ' ');
  return text;
}

// Throws all problems. A single problem keeps its place as a field; several are joined, each preceded by its place.
// Problems in options only are errors of the command line, exit code 2.
[[noreturn]] void throwProblems(const Json& errors) {
  std::vector<Error> problems;
  int exit_code = 2;
  for (const Json& error : errors) {
    Place place{plain(error.at("file").get<std::string>()), error.at("line").get<int>()};
    if (!place.file.starts_with("--")) exit_code = 1;
    problems.emplace_back(plain(error.at("message").get<std::string>()), place);
  }
  if (problems.size() == 1) throw Error(problems.front().message(), problems.front().place(), exit_code);
  std::vector<std::string> messages;
  for (const Error& problem : problems) messages.emplace_back(problem.what());
  throwIfAny(messages, exit_code);
  throw Error("the script failed without an error message");
}

Json requestOf(const Main& main, const std::string& function, const Json& argument, const Limits& limits,
               const Texts& texts) {
  return {{"function", function},  {"argument", argument},          {"main", main.file.string()},
          {"shown", main.shown},   {"own_folder", main.own_folder}, {"texts", Json(texts)},
          {"cpu_s", limits.cpu_s}, {"wall_s", limits.wall_s},       {"memory_mb", limits.memory_mb}};
}

// Adds the path of the preset if the preset is a file: in a root (which may be a copy), otherwise in the current
// folder.
void addPreset(const Home& home, const Settings& sets, const Texts& texts, Json& request) {
  std::string set;
  for (const auto& [name, value] : sets)
    if (const auto* text = std::get_if<std::string>(&value); text && name == plan::kPresetSetting) set = *text;
  if (!set.ends_with(".lua")) return;
  Path here = fs::absolute(set).lexically_normal();
  bool is_here = texts.count(here) || Path(set).is_absolute();
  Path file = is_here ? copyOf(home, here) : home.find(set).value_or(here);
  request["preset"] = file.string();
  request["preset_shown"] = home.shown(file);
}

// Result in the answer to a request. The answer comes from a process that ran an untrusted script, so all its fields
// are checked.
Json resultOf(const Main& main, const ProgramEnd& child, std::vector<Dependency>* dependencies, const Limits& limits) {
  bool answered = child.succeeded() && !child.too_long;
  Json answer = answered ? jsonFromText(child.output) : Json();
  if (!answer.is_object()) throw Error(endedBy(child, limits), {main.shown});
  try {
    if (dependencies) *dependencies = dependenciesOf(answer.at("files"));
    if (answer.contains("out_of_memory")) throw Error(outOfMemory(limits), {main.shown});
    if (answer.contains("errors")) throwProblems(answer["errors"]);
    return std::move(answer.at("result"));
  } catch (const Json::exception&) {
    throw Error("the answer of the script's process has a wrong form", {main.shown});
  }
}

// Result of a request. `file`: see `answerTo`.
Json evaluate(const Home& home, const Main& main, const Json& request, std::vector<Dependency>* dependencies,
              const Limits& limits, const std::string& file = kNoFile) {
  if (dependencies) *dependencies = {};
  if (dependencies && !main.file.empty()) *dependencies = {{main.file, main.shown, hashOfPath(main.file)}};
  return resultOf(main, answerTo(home, file, textOf(request), limits.wall_s), dependencies, limits);
}

Json evaluate(const Home& home, const Main& main, const std::string& function, const Json& argument,
              std::vector<Dependency>* dependencies, const Limits& limits, const Texts& texts = {}) {
  return evaluate(home, main, requestOf(main, function, argument, limits, texts), dependencies, limits);
}

// Outcomes of `evaluate(0)` to `evaluate(count - 1)`, on all cores.
template <class Value, class Evaluate>
std::vector<Outcome<Value>> outcomesOf(size_t count, const Evaluate& evaluate) {
  std::vector<Outcome<Value>> outcomes(count);
  forEachOnAllCores(count, [&](size_t i) {
    try {
      outcomes[i].value = evaluate(i);
    } catch (const Error&) {
      outcomes[i].error = std::current_exception();
    }
  });
  return outcomes;
}

// Values read from texts. Most texts of an evaluation are also texts of earlier evaluations.
template <class Value>
class ReadTexts {
 public:
  template <class Read>
  std::shared_ptr<const Value> of(const std::string& text, const Read& read) {
    constexpr size_t kMost = 4096;
    std::unique_lock lock(mutex_);
    if (auto known = values_.find(text); known != values_.end()) return known->second;
    lock.unlock();
    auto value = std::make_shared<const Value>(read(jsonFromText(text)));
    lock.lock();
    if (values_.size() >= kMost) values_.clear();
    return values_[text] = std::move(value);
  }

 private:
  std::mutex mutex_;
  std::unordered_map<std::string, std::shared_ptr<const Value>> values_;
};

Json settingsJson(const Settings& sets) {
  Json list = Json::array();
  for (const auto& [name, value] : sets) list.push_back({{"name", name}, {"value", plan::toJson(value)}});
  return list;
}

// Settings of the scene or of the pipeline, with the last value of each name.
Settings lastOfEach(const Settings& sets, bool of_scene) {
  const std::string prefix = "scene.";
  Settings last;
  for (const auto& [name, value] : sets) {
    if (name.starts_with(prefix) != of_scene) continue;
    std::string plain = of_scene ? name.substr(prefix.size()) : name;
    auto earlier = std::find_if(last.begin(), last.end(), [&](const auto& set) { return set.first == plain; });
    if (earlier != last.end()) earlier->second = value;
    if (earlier == last.end()) last.emplace_back(plain, value);
  }
  return last;
}

std::vector<DroppedSetting> droppedSettings(const Json& list) {
  std::vector<DroppedSetting> dropped;
  for (const Json& one : list) {
    dropped.push_back({one.at("name").get<std::string>(), one.at("value").get<std::string>(),
                       plain(one.at("reason").get<std::string>())});
  }
  return dropped;
}

}  // namespace

std::string hashOfPath(const Path& path) {
  std::error_code ignored;
  if (fs::is_directory(path, ignored)) return hashText(fmt::format("{}", fmt::join(namesIn(path, ".lua"), "\n")));
  try {
    return hashText(readText(path));
  } catch (const Error&) {
    return "";
  }
}

Setting settingFromText(const std::string& text, const std::string& option) {
  size_t equals = text.find('=');
  if (equals == std::string::npos || equals == 0)
    throw Error(fmt::format("{} '{}' is not NAME=VALUE", option, text), {}, 2);
  return {text.substr(0, equals), plan::valueFromText(text.substr(equals + 1))};
}

static plan::PipelineDesc pipelineOf(const Main& main, Json result, std::vector<DroppedSetting>* dropped) {
  static ReadTexts<plan::PassDesc> passes;
  static ReadTexts<std::vector<plan::ParamDesc>> params;
  try {
    if (dropped) *dropped = droppedSettings(result.at("dropped"));
    plan::SharedParts parts;
    for (const Json& pass : result.at("passes"))
      parts.passes.push_back(*passes.of(pass.get_ref<const std::string&>(), plan::passFromJson));
    parts.params = *params.of(result.at("params").get_ref<const std::string&>(), plan::paramsFromJson);
    for (const char* read : {"dropped", "passes", "params"}) result.erase(read);
    return plan::pipelineFromJson(result, std::move(parts));
  } catch (const Json::exception&) {
    throw Error("the description of the pipeline has a wrong form", {main.shown});
  }
}

plan::PipelineDesc evaluatePipeline(const Home& home, const PipelineRequest& asked,
                                    std::vector<Dependency>* dependencies, const Limits& limits,
                                    std::vector<DroppedSetting>* dropped) {
  Main main = mainOf(home, asked.name_or_path, "pipeline", asked.texts);
  Json sets = settingsJson(lastOfEach(asked.sets, false));
  Json argument = {{"name", main.name}, {"file", main.shown}, {"sets", sets}, {"lenient", dropped != nullptr}};
  Json request = requestOf(main, "pipeline", argument, limits, asked.texts);
  addPreset(home, asked.sets, asked.texts, request);
  // A file under another name is another file: its name is in places, and its folder may have modules. A session
  // evaluates an edit once, which takes longer from a loaded file.
  const bool once = dropped || !asked.texts.empty();
  const std::string file = fmt::format("{}\n{}\n{}", main.file.string(), main.shown, main.own_folder);
  Json result = evaluate(home, main, request, dependencies, limits, once ? kNoFile : file);
  return pipelineOf(main, std::move(result), dropped);
}

std::vector<Outcome<plan::PipelineDesc>> evaluatePipelines(const Home& home,
                                                           const std::vector<PipelineRequest>& requests,
                                                           const Limits& limits) {
  return outcomesOf<plan::PipelineDesc>(requests.size(),
                                        [&](size_t i) { return evaluatePipeline(home, requests[i], nullptr, limits); });
}

Json evaluateScene(const Home& home, const std::string& name_or_path, const Settings& sets,
                   std::vector<Dependency>* dependencies, const Limits& limits, const Texts& texts) {
  Main main = mainOf(home, name_or_path, "scene", texts);
  Json argument = {{"file", main.shown}, {"sets", settingsJson(lastOfEach(sets, true))}};
  return evaluate(home, main, "scene", argument, dependencies, limits, texts);
}

Path sceneFolder(const Home& home, const std::string& name_or_path) {
  return mainOf(home, name_or_path, "scene", {}).folder;
}

std::vector<Outcome<Json>> evaluateScenes(const Home& home, const std::vector<std::string>& names_or_paths,
                                          const Limits& limits) {
  return outcomesOf<Json>(names_or_paths.size(),
                          [&](size_t i) { return evaluateScene(home, names_or_paths[i], {}, nullptr, limits); });
}

std::string kindOfFile(const Home& home, const std::string& path) {
  return evaluate(home, mainFile(home, path), "kind", Json::object(), nullptr, {}).at("kind");
}

Json evaluateData(const Home& home, const std::string& path, const Json& arguments,
                  std::vector<Dependency>* dependencies, const Limits& limits) {
  Main main = mainFile(home, path);
  Json argument = {{"file", main.shown}, {"arguments", arguments}};
  return evaluate(home, main, "data", argument, dependencies, limits);
}

std::vector<plan::PassDesc> evaluateAllPasses(const Home& home, std::vector<Dependency>* dependencies,
                                              const Limits& limits) {
  std::vector<std::string> modules;
  for (std::string name : mainNames(home, "passes")) {
    std::replace(name.begin(), name.end(), '/', '.');
    modules.push_back("passes." + name);
  }

  Main main;
  main.shown = "passes";
  Json result = evaluate(home, main, "passes", {{"modules", modules}}, dependencies, limits);
  std::vector<plan::PassDesc> passes;
  for (const Json& pass : result) passes.push_back(plan::passFromJson(pass));
  return passes;
}

std::vector<std::string> pipelinesOfKind(const Home& home, plan::PipelineDesc::Kind kind, const Limits& limits) {
  Main main;
  main.shown = "scripts/pipelines";
  const std::string& wanted = plan::pipelineKindNames()[static_cast<size_t>(kind)];
  Json kinds = evaluate(home, main, "kinds", {{"names", pipelineNames(home)}}, nullptr, limits);
  std::vector<std::string> names;
  for (const auto& [name, found] : kinds.items())
    if (found == wanted) names.push_back(name);
  return names;
}

std::string pipelineOfKind(const Home& home, plan::PipelineDesc::Kind kind, const Limits& limits) {
  std::vector<std::string> names = pipelinesOfKind(home, kind, limits);
  if (!names.empty()) return names.front();
  const std::string& wanted = plan::pipelineKindNames()[static_cast<size_t>(kind)];
  throw Error(fmt::format("no pipeline of scripts/pipelines declares kind = \"{}\"", wanted));
}

std::vector<std::string> pipelineNames(const Home& home) { return mainNames(home, "scripts/pipelines"); }
std::vector<std::string> sceneNames(const Home& home) { return mainNames(home, "scripts/scenes"); }

}  // namespace strobe::script
