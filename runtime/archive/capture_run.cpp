// SPDX-License-Identifier: MIT
#include "archive/capture_run.h"

#include <algorithm>
#include <filesystem>

#include "base/hash.h"
#include "base/interruption.h"
#include "base/leftovers.h"
#include "base/lists.h"
#include "base/process_name.h"
#include "figure/film.h"

namespace strobe::archive {

namespace fs = std::filesystem;

Path inputCopy(const std::string& name) {
  size_t colon = name.find(':');
  return Path(kInputsFolder) / name.substr(0, colon) / Path(name.substr(colon + 1)).relative_path();
}

// Copies the used inputs, removes all other copies, and returns the names of the copies.
static std::set<std::string> copyInputs(const Inputs& inputs, const InputNames& names, const Path& folder, bool all) {
  std::set<std::string> wanted;
  for (const auto& [name, input] : inputs) {
    if (!all && !isText(name)) continue;
    Path copy = inputCopy(name);
    wanted.insert(copy.generic_string());
    writeFileAtomically(folder / copy, readText(names.pathOf(name)));
  }
  std::vector<Path> others;
  if (fs::exists(folder / kInputsFolder))
    for (const auto& entry : fs::recursive_directory_iterator(folder / kInputsFolder))
      if (entry.is_regular_file() && !wanted.count(entry.path().lexically_relative(folder).generic_string()))
        others.push_back(entry.path());
  for (const Path& file : others) fs::remove(file);
  return wanted;
}

Capturing::Places Capturing::mainPlace(const Home& home, const Order& order) {
  auto frozen = std::make_unique<FrozenHome>(home, order.folder / (".inputs." + processName()));
  auto bench = std::make_unique<lab::Workbench>(frozen->home(), order.device, order.validation);
  InputNames names(frozen->home(), home, frozen->at(order.file));
  Places places;
  places.emplace("", Place{std::move(frozen), std::move(bench), std::move(names)});
  return places;
}

Capturing::Capturing(const Home& home, const Order& order, Report report)
    : order_(order),
      home_(home),
      report_(std::move(report)),
      lease_(Lease::ofFolder(order.folder)),
      places_(mainPlace(home, order)),
      capture_(readCapture(inputs().home(), inputs().at(order.file), order.size)),
      frames_(framesOf(capture_, isFigure(order.only) ? "" : order.only)) {
  removeLeftovers(order.folder);
}

bool Capturing::isFigure(const std::string& name) const {
  for (const auto* list : {&capture_.figures, &capture_.films})
    for (const Json& one : *list)
      if (one.at("name") == name) return true;
  return false;
}

// Adds the scripts and shaders of an arm's own folder, used or not: the capture script cannot be read without the
// folder.
void Capturing::addFiles(const Path& folder) {
  if (folder.empty()) return;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (entry.is_regular_file() && isText(entry.path()))
      addInput(used_, main().names, entry.path(), hashText(readText(entry.path())));
}

// Shots that the cells show, each once.
std::vector<const CapturedShot*> Capturing::shotsOf(const Json& figure) const {
  std::vector<const CapturedShot*> shots;
  for (const Json& cell : figure.at("cells")) {
    std::string name = cell.value("shot", capture_.shots.front().name);
    addOnce(shots, &capture_.shot(name));
  }
  return shots;
}

void Capturing::drawFigures() {
  auto find = [this](const std::string& shot, const std::string& arm, int step) -> const figure::Taken& {
    return this->find(shot, arm, step);
  };
  for (const auto* list : {&capture_.figures, &capture_.films})
    for (const Json& figure : *list) {
      const std::string name = figure.at("name").get<std::string>();
      if (isFigure(order_.only) && name != order_.only) continue;
      stopIfRequested();
      std::vector<const CapturedShot*> shots = shotsOf(figure);
      auto missing = std::find_if(shots.begin(), shots.end(), [](const auto* shot) { return !shot->missing.empty(); });
      if (missing != shots.end()) {
        if (report_) report_(fmt::format("{}: left out, {}", name, (*missing)->missing));
        continue;
      }
      size_t steps = 1;
      for (const CapturedShot* shot : shots) steps = std::max(steps, shot->steps.size());
      bool film = list == &capture_.films;
      for (const Path& file : film ? figure::writeFilm(figure, find, int(steps), order_.folder, capture_.truth)
                                   : figure::writeFigure(figure, find, capture_.truth, order_.folder)) {
        files_[file.lexically_relative(order_.folder).generic_string()] = fileEntry(file);
        figure_files_.push_back(file);
      }
      if (report_) report_(fmt::format("{} {}", film ? "film" : "figure", name));
    }
}

// Adds the entry of a picture to the manifest. Moves the files out of the entry: the manifest lists them once for all
// pictures.
void Capturing::collect(Json entry) {
  files_.update(entry["files"]);
  for (const auto& [kind, file] : entry["images"].items())
    if (kind == "png") picture_files_.push_back(order_.folder / file.get<std::string>());
  for (const char* part : {"files", "key"}) entry.erase(part);
  pictures_.push_back(std::move(entry));
}

Json Capturing::captureJson(const std::string& name) const {
  Json json = {{"file", name},
               {"title", capture_.title},
               {"size", {capture_.width, capture_.height}},
               {"most_flip", capture_.most_flip},
               {"bundle", order_.bundle}};
  if (!capture_.note.empty()) json["note"] = capture_.note;
  // A script outside of the roots is found relative to the manifest.
  if (name.starts_with("capture:"))
    json["from_here"] = fs::absolute(order_.file).lexically_relative(fs::absolute(order_.folder)).generic_string();
  if (!order_.only.empty()) json["only"] = order_.only;
  for (const CapturedShot& shot : capture_.shots)
    if (!shot.missing.empty()) json["missing"][shot.name] = shot.missing;
  return json;
}

Captured Capturing::finish() {
  for (const script::Dependency& file : capture_.scripts) addInput(used_, main().names, file.path, file.hash);
  for (const CapturedArm& arm : capture_.arms) addFiles(arm.files);
  bool of_figure = isFigure(order_.only);
  for (size_t i = 0; i < frames_.size() && !of_figure; ++i) {
    const std::string name = frames_[i].name();
    if (entries_.count(name)) continue;
    stopIfRequested();
    bool drawn = draw(frames_[i]) != nullptr;
    if (report_) report_(fmt::format("{} of {}: {}{}", i + 1, frames_.size(), name, drawn ? "" : ", already drawn"));
  }
  if (order_.only.empty() || of_figure) drawFigures();
  for (const CapturedFrame& frame : framesOf(capture_))
    if (auto entry = entries_.find(frame.name()); entry != entries_.end()) collect(entry->second);
  for (const auto& [files, place] : places_) place.bench->device().refuseMessages();

  const InputNames& names = main().names;
  std::set<std::string> listed = copyInputs(used_, names, order_.folder, order_.bundle);
  for (const auto& [name, file] : files_.items()) listed.insert(name);
  listed.insert(kManifestFile);
  Manifest manifest = {order_.folder,
                       {{"format", kManifestFormat},
                        {"format_version", kManifestVersion},
                        {"capture", captureJson(names.nameOf(capture_.file, true))},
                        {"program", programJson(home_)},
                        {"device", deviceJson(bench().device().info())},
                        {"inputs", toJson(used_)},
                        {"pictures", std::move(pictures_)},
                        {"files", std::move(files_)}}};
  writeFileAtomically(order_.folder / kManifestFile, manifest.json.dump(1) + "\n");
  if (drawn_ > 0) writeFileAtomically(order_.folder / "timings.json", timings_.dump(1) + "\n");
  writeFileAtomically(order_.folder / kSumsFile, sumsOf(order_.folder, listed));
  return {std::move(manifest), std::move(figure_files_), std::move(picture_files_)};
}

}  // namespace strobe::archive
