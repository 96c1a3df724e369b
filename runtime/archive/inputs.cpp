// SPDX-License-Identifier: MIT
#include "archive/inputs.h"

#include <filesystem>

#include "base/frozen_home.h"
#include "base/hash.h"

namespace strobe::archive {

namespace fs = std::filesystem;

Json toJson(const Inputs& inputs) {
  Json list = Json::array();
  for (const auto& [name, input] : inputs)
    list.push_back({{"name", name}, {"sha256", input.sha256}, {"bytes", input.bytes}});
  return list;
}

Inputs inputsFrom(const Json& json) {
  Inputs inputs;
  for (const Json& one : json) {
    Input input{one.at("name").get<std::string>(), one.at("sha256").get<std::string>(),
                one.at("bytes").get<uint64_t>()};
    inputs[input.name] = input;
  }
  return inputs;
}

bool isText(const Path& file) {
  const Path ending = file.extension();
  return ending == ".lua" || ending == ".glsl" || ending == ".h" || file.filename() == FrozenHome::kAbsent;
}

InputNames::InputNames(const Home& home, const Home& original, const Path& capture_file) {
  for (const Home* of : {&home, &original}) {
    if (of->hasProject()) roots_.push_back({Home::kProjectPrefix, of->project()});
    roots_.push_back({Home::kShippedPrefix, of->shipped()});
  }
  if (std::optional<Path> data = home.data()) roots_.push_back({Home::kSharedPrefix, *data});
  roots_.push_back({"capture:", fs::absolute(capture_file).lexically_normal().parent_path()});
}

InputNames::InputNames(const Home& home, const InputNames& names, const Path& other)
    : roots_(names.roots_), other_(other), other_name_(names.nameOf(other, false)) {
  roots_.insert(roots_.begin(), {Home::kShippedPrefix, home.shipped()});
  if (home.hasProject()) roots_.insert(roots_.begin(), {Home::kProjectPrefix, home.project()});
}

std::optional<std::string> InputNames::named(const Path& path) const {
  for (const Root& root : roots_) {
    Path below = path.lexically_relative(fs::absolute(root.folder).lexically_normal());
    if (!below.empty() && *below.begin() != ".." && liesIn(path, root.folder))
      return root.prefix + below.generic_string();
  }
  return std::nullopt;
}

std::string InputNames::nameOf(const Path& file, bool allow_outside) const {
  Path path = fs::absolute(file).lexically_normal();
  std::optional<std::string> name = named(path);
  if (name && !other_.empty()) {
    size_t colon = name->find(':');
    Path below = Path(name->substr(0, colon)) / name->substr(colon + 1);
    if (isText(below) && fs::is_regular_file(other_ / below)) return other_name_ + "/" + below.generic_string();
  }
  if (name) return *name;
  if (allow_outside) return "outside:" + path.generic_string();
  throw Error(
      "lies outside Strobe's folder, the project, the shared data and the folder of the capture; allow_outside = true "
      "of the shot lists it in the manifest",
      {path.string()});
}

Path InputNames::pathOf(const std::string& name) const {
  Path first;
  for (const Root& root : roots_) {
    if (!name.starts_with(root.prefix)) continue;
    Path path = root.folder / name.substr(root.prefix.size());
    if (fs::is_regular_file(path)) return path;
    if (first.empty()) first = path;
  }
  return first.empty() ? Path(name.substr(name.find(':') + 1)) : first;
}

void addInput(Inputs& inputs, const InputNames& names, const Path& file, const std::string& was, bool allow_outside) {
  if (fs::is_directory(file)) {
    for (const auto& entry : fs::directory_iterator(file))
      if (entry.is_regular_file() && entry.path().extension() == ".lua")
        addInput(inputs, names, entry.path(), hashText(readText(entry.path())), allow_outside);
    return;
  }
  if (!fs::is_regular_file(file)) return;
  std::string name = names.nameOf(file, allow_outside);
  if (auto known = inputs.find(name); known != inputs.end()) {
    if (known->second.hash == was) return;
    throw Error("changed while pictures were taken; take the capture again", {name});
  }
  std::string text = readText(file);
  if (hashText(text) != was) throw Error("changed while it was in use", {file.string()});
  inputs[name] = {name, sha256(text), text.size(), was};
}

// Adds the files that every shader of a pass is compiled with.
static void addCommonShaders(Inputs& inputs, const InputNames& names, const Home& home) {
  for (const char* folder : {"shaders/shared", "shaders/backend"})
    for (const Path& place : home.folders(folder))
      for (const auto& entry : fs::directory_iterator(place))
        if (entry.is_regular_file()) addInput(inputs, names, entry.path(), hashText(readText(entry.path())));
}

void addInputs(Inputs& inputs, const InputNames& names, const Home& home, const lab::Drawing& drawing,
               bool allow_outside) {
  addCommonShaders(inputs, names, home);
  for (const auto* files : {&drawing.evaluation().scripts, &drawing.scene().dependencies})
    for (const script::Dependency& file : *files) addInput(inputs, names, file.path, file.hash, allow_outside);
  for (const auto& [node, pipeline] : drawing.graph().pipelines())
    for (const auto& [file, hash] : pipeline->sources) addInput(inputs, names, file, hash);
}

}  // namespace strobe::archive
