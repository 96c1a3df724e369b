// SPDX-License-Identifier: MIT
#include "archive/capture_run.h"

#include <algorithm>
#include <filesystem>

#include "archive/crate.h"
#include "archive/taker.h"
#include "base/frozen_home.h"
#include "base/hash.h"
#include "figure/film.h"
#include "lab/workbench.h"

namespace strobe::archive {

namespace fs = std::filesystem;

Path inputCopy(const std::string& name) {
  size_t colon = name.find(':');
  return Path(kInputsFolder) / name.substr(0, colon) / Path(name.substr(colon + 1)).relative_path();
}

// Copies of what was used, and of nothing else; their names.
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

static Json captureJson(const CaptureFile& capture, const std::string& name, const Order& order) {
  Json json = {{"file", name},
               {"title", capture.title},
               {"size", {capture.width, capture.height}},
               {"most_flip", capture.most_flip},
               {"bundle", order.bundle}};
  if (!capture.note.empty()) json["note"] = capture.note;
  // A script of no root is found from the manifest.
  if (name.starts_with("capture:"))
    json["from_here"] = fs::absolute(order.file).lexically_relative(fs::absolute(order.folder)).generic_string();
  if (!order.only.empty()) json["only"] = order.only;
  for (const CapturedShot& shot : capture.shots)
    if (!shot.missing.empty()) json["missing"][shot.name] = shot.missing;
  return json;
}

namespace {

class Run {
 public:
  Run(const CaptureFile& capture, const Order& order, const Home& home, lab::Workbench& bench,
      const Taker::MakeBench& make, const std::function<void(const std::string&)>& report)
      : capture_(capture), order_(order), report_(report), taker_(bench, home, capture, order.folder, make) {}

  void draw() {
    for (const script::Dependency& file : capture_.scripts) addInput(inputs_, taker_.names(), file.path, file.hash);
    for (const CapturedArm& arm : capture_.arms) addFiles(arm.files);
    bool of_figure = isFigure(order_.only);
    std::vector<Frame> all = framesOf(capture_), frames = framesOf(capture_, of_figure ? "" : order_.only);
    for (size_t i = 0; i < frames.size() && !of_figure; ++i)
      take(frames[i], fmt::format("{} of {}", i + 1, frames.size()));
    if (order_.only.empty() || of_figure) drawFigures();
    for (const Frame& frame : all)
      if (taker_.has(frame.name())) collect(frame);
  }

  Json pictures = Json::array(), files = Json::object();
  std::vector<Path> shown;  // files for people
  const Inputs& inputs() const { return inputs_; }
  const Taker& taker() const { return taker_; }

 private:
  bool isFigure(const std::string& name) const {
    for (const auto* list : {&capture_.figures, &capture_.films})
      for (const Json& one : *list)
        if (one.at("name") == name) return true;
    return false;
  }

  void take(const Frame& frame, const std::string& count) {
    int before = taker_.drawn();
    taker_.entry(frame);
    if (report_) report_(fmt::format("{}: {}{}", count, frame.name(), taker_.drawn() > before ? "" : ", is there"));
  }

  // Scripts and shaders of an arm's own, used or not: without them the script cannot be read.
  void addFiles(const Path& folder) {
    if (folder.empty()) return;
    for (const auto& entry : fs::recursive_directory_iterator(folder))
      if (entry.is_regular_file() && isText(entry.path()))
        addInput(inputs_, taker_.names(), entry.path(), hashText(readText(entry.path())));
  }

  // The shots that its cells show, each once.
  std::vector<const CapturedShot*> shotsOf(const Json& figure) const {
    std::vector<const CapturedShot*> shots;
    for (const Json& cell : figure.at("cells")) {
      std::string name = cell.value("shot", capture_.shots.front().name);
      const CapturedShot* shot = &capture_.shot(name);
      if (std::find(shots.begin(), shots.end(), shot) == shots.end()) shots.push_back(shot);
    }
    return shots;
  }

  void drawFigures() {
    auto find = [this](const std::string& shot, const std::string& arm, int step) -> const figure::Taken& {
      return taker_.find(shot, arm, step);
    };
    for (const auto* list : {&capture_.figures, &capture_.films})
      for (const Json& figure : *list) {
        const std::string name = figure.at("name").get<std::string>();
        if (isFigure(order_.only) && name != order_.only) continue;
        std::vector<const CapturedShot*> shots = shotsOf(figure);
        auto missing =
            std::find_if(shots.begin(), shots.end(), [](const auto* shot) { return !shot->missing.empty(); });
        if (missing != shots.end()) {
          if (report_) report_(fmt::format("{}: left out, {}", name, (*missing)->missing));
          continue;
        }
        size_t steps = 1;
        for (const CapturedShot* shot : shots) steps = std::max(steps, shot->steps.size());
        bool film = list == &capture_.films;
        for (const Path& file : film ? figure::writeFilm(figure, find, int(steps), order_.folder, capture_.truth)
                                     : figure::writeFigure(figure, find, capture_.truth, order_.folder)) {
          files[file.lexically_relative(order_.folder).generic_string()] = fileEntry(file);
          shown.push_back(file);
        }
        if (report_) report_(fmt::format("{} {}", film ? "film" : "figure", name));
      }
  }

  // What is said once for all pictures goes out of the entry.
  void collect(const Frame& frame) {
    Json entry = taker_.entry(frame);
    for (const auto& [name, input] : inputsFrom(entry["inputs"])) {
      auto known = inputs_.find(name);
      if (known != inputs_.end() && !(known->second == input))
        throw Error("changed while pictures were taken; take the capture again", {name});
      inputs_[name] = input;
    }
    files.update(entry["files"]);
    for (const auto& [kind, file] : entry["images"].items())
      if (kind == "png") shown.push_back(order_.folder / file.get<std::string>());
    for (const char* part : {"inputs", "files", "key"}) entry.erase(part);
    pictures.push_back(std::move(entry));
  }

  const CaptureFile& capture_;
  const Order& order_;
  const std::function<void(const std::string&)>& report_;
  Taker taker_;
  Inputs inputs_;
};

}  // namespace

Captured runCapture(const Home& home, const Order& order, const std::function<void(const std::string&)>& report) {
  const std::string date = crateDate(home);
  FrozenHome frozen(home, order.folder / ".inputs");
  CaptureFile capture = readCapture(frozen.home(), frozen.at(order.file), order.size);
  auto make = [&](const Home& of) { return std::make_unique<lab::Workbench>(of, order.device, order.validation); };
  std::unique_ptr<lab::Workbench> bench = make(frozen.home());
  Run run(capture, order, home, *bench, make, report);
  run.draw();
  run.taker().refuseMessages();
  const InputNames& names = run.taker().names();

  std::set<std::string> listed = copyInputs(run.inputs(), names, order.folder, order.bundle);
  for (const auto& [name, file] : run.files.items()) listed.insert(name);
  listed.insert(kManifestFile);
  Manifest manifest = {order.folder,
                       {{"format", kManifestFormat},
                        {"format_version", kManifestVersion},
                        {"capture", captureJson(capture, names.nameOf(capture.file, true), order)},
                        {"program", programJson(home)},
                        {"device", deviceJson(bench->device().info())},
                        {"inputs", toJson(run.inputs())},
                        {"pictures", std::move(run.pictures)},
                        {"files", std::move(run.files)}}};
  writeFileAtomically(order.folder / kManifestFile, manifest.json.dump(1) + "\n");
  writeFileAtomically(order.folder / kCrateFile, crateOf(manifest, listed, date).dump(1) + "\n");
  if (run.taker().drawn() > 0) writeFileAtomically(order.folder / "timings.json", run.taker().timings().dump(1) + "\n");
  writeFileAtomically(order.folder / kSumsFile, sumsOf(order.folder, listed));
  return {std::move(manifest), std::move(run.shown)};
}

}  // namespace strobe::archive
