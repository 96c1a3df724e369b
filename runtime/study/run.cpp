// SPDX-License-Identifier: MIT
#include "study/run.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <set>

#include "base/log.h"
#include "image/metrics.h"
#include "image/png.h"
#include "lab/against_truth.h"
#include "lab/batch.h"
#include "lab/capture.h"
#include "lab/pace.h"
#include "study/crops.h"
#include "study/layout.h"
#include "study/points.h"

namespace strobe::study {

namespace {

using image::Image;

constexpr int kFrameCost = 12;  // of one frame of a method, in time samples of truth

// ---- what is measured where

bool hasAxis(const Experiment& experiment, const Group& group, const std::string& name) {
  return std::any_of(group.at.begin(), group.at.end(),
                     [&](const At& at) { return experiment.axes[at.axis].name == name; });
}

// The shot in which an axis is measured first.
bool isFirstShot(const Experiment& experiment, const Group& group, const std::string& axis) {
  for (const Group& other : experiment.groups)
    if (hasAxis(experiment, other, axis)) return other.shot == group.shot;
  return false;
}

// Measures that the experiment asks for, and those that its layout shows of such a point.
std::vector<std::string> measuresOf(const Experiment& experiment, const Group& group) {
  std::vector<std::string> wanted = experiment.measures;
  auto add = [&](const std::vector<std::string>& names) { wanted.insert(wanted.end(), names.begin(), names.end()); };
  add({"rmse", "pixels", "broken"});
  if (picturesOf(experiment.layout)) add({"displacement", "clamped"});
  if (curvesOf(experiment.layout)) add({"contrast", "change", "changed"});
  if (experiment.background) add({"background_deviation", "background_difference", "background_pixels", "clamped"});
  if (std::optional<TableLayout> table = tableOf(experiment.layout)) {
    for (const std::string& axis : table->axes) {
      if (!hasAxis(experiment, group, axis)) continue;
      add(table->cells);
      if (isFirstShot(experiment, group, axis)) add(table->once);
    }
    if (table->share) add({"contrast"});
  }
  std::vector<std::string> ordered;
  for (const std::string& name : measureNames())
    if (std::find(wanted.begin(), wanted.end(), name) != wanted.end()) ordered.push_back(name);
  return ordered;
}

bool contains(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

bool wantsTime(const std::vector<std::string>& names) { return contains(names, "ms") || contains(names, "ms_least"); }

// ---- order

// The one axis of a group that has a benign value, or nothing.
const Axis* walkedAxis(const Experiment& experiment, const Group& group) {
  const Axis* axis = group.at.size() == 1 ? &experiment.axes[group.at[0].axis] : nullptr;
  return axis && axis->benign ? axis : nullptr;
}

bool isBenign(const Experiment& experiment, const Group& group) {
  const Axis* axis = walkedAxis(experiment, group);
  return axis && group.at[0].value == *axis->benign;
}

// Groups of one shot along one axis, the benign one first: the others are compared to it. Groups that vary otherwise
// stand alone.
std::vector<std::vector<size_t>> walksOf(const Experiment& experiment) {
  std::vector<std::vector<size_t>> walks;
  const Axis* last = nullptr;
  for (size_t i = 0; i < experiment.groups.size(); ++i) {
    const Group& group = experiment.groups[i];
    const Axis* axis = walkedAxis(experiment, group);
    bool same = axis && axis == last && experiment.groups[walks.back().front()].shot == group.shot;
    if (!same) walks.emplace_back();
    bool first = same && isBenign(experiment, group);
    walks.back().insert(first ? walks.back().begin() : walks.back().end(), i);
    last = axis;
  }
  return walks;
}

// ---- cost

// Time samples of what runs in loops, truth and floors; 0 without loops.
int loopCost(lab::Batch& batch, const lab::Shot& shot) {
  lab::Evaluated evaluated = batch.evaluate(shot.pipeline, shot.sets);
  if (!evaluated.pipeline) throw lab::Refusal(evaluated.refusal);
  int64_t cost = 0;
  for (const plan::LoopDesc& loop : evaluated.pipeline->loops) {
    if (loop.count.value) cost += std::get<int64_t>(*loop.count.value);
    for (const auto& [name, value] : evaluated.pipeline->values)
      if (name == loop.count.follows) cost += std::get<int64_t>(value);
  }
  return int(cost);
}

int costOf(const Experiment& experiment, const Group& group, lab::Batch& batch) {
  if (!experiment.shots[group.shot].missing.empty()) return 0;
  int cost = loopCost(batch, truthShotOf(experiment, group));
  if (experiment.full_truth) cost += loopCost(batch, truthShotOf(experiment, group, *experiment.full_truth));
  for (size_t arm : group.arms) {
    bool loops = experiment.arms[arm].role == Role::floor;
    cost += loops ? loopCost(batch, shotOf(experiment, group, experiment.arms[arm])) : kFrameCost;
  }
  return std::max(cost, 1);
}

// ---- one picture

// "NODE: COUNT WHAT" of each limit a picture met: its warnings without those of the scene, without what to do about
// them.
std::vector<std::string> limitsMet(const lab::Picture& picture) {
  std::vector<std::string> met, of_scene = picture.record["scene"]["warnings"].get<std::vector<std::string>>();
  for (const std::string& warning : picture.warnings)
    if (!contains(of_scene, warning)) met.push_back(warning.substr(0, warning.find(';')));
  return met;
}

// What a scene's file says of its author: its copyright, else the first line of the text beside it.
std::string attributionOf(const Json& scene) {
  if (!scene.contains("attribution") || !scene["attribution"].is_object()) return "";
  const Json& said = scene["attribution"];
  if (said.contains("copyright") && said["copyright"].is_string()) return said["copyright"].get<std::string>();
  std::string text = said.contains("text") && said["text"].is_string() ? said["text"].get<std::string>() : "";
  return text.substr(0, text.find('\n'));
}

class Runner {
 public:
  Runner(const Experiment& experiment, lab::Batch& batch, const Path& folder, Results& results, lab::Pace& pace)
      : experiment_(experiment),
        batch_(batch),
        folder_(folder),
        results_(results),
        pace_(pace),
        pictures_(picturesOf(experiment.layout)) {}

  void walk(const std::vector<size_t>& groups);

 private:
  // A point whose time is measured when its walk has been drawn.
  struct Timed {
    size_t group, point;
    lab::Shot shot;
    std::vector<std::string> names;
  };

  void group(size_t index);
  std::shared_ptr<const lab::Picture> drawn(const lab::Shot& shot);
  void prepareTruth(const Group& group);
  Sight sightOf(const Group& group, const Arm& arm, const lab::Picture& picture);
  Point pointOf(const Group& group, const Arm& arm, const lab::Shot& shot, const std::vector<std::string>& names);
  void write(const Group& group, const Arm& arm, const lab::Shot& shot, const lab::Picture& picture,
             Point& point) const;
  void describeShot(const Group& group);
  image::Rectangle placed(const Crop& crop) const;
  void timeInTurn();
  void warnOnce(const std::string& who, const std::vector<std::string>& warnings);

  const Experiment& experiment_;
  lab::Batch& batch_;
  Path folder_;
  Results& results_;
  lab::Pace& pace_;
  std::optional<PicturesLayout> pictures_;

  lab::Shot truth_shot_;
  std::shared_ptr<const lab::Picture> truth_;
  TruthPicture held_against_;
  std::map<std::string, Image> benign_, fronts_;  // colours by arm
  std::vector<Timed> timed_;
  std::set<std::string> warned_;
};

// Progress counts what is drawn, not what is known already.
std::shared_ptr<const lab::Picture> Runner::drawn(const lab::Shot& shot) {
  int cost = loopCost(batch_, shot), last = 0;
  if (cost == 0) cost = kFrameCost;
  std::shared_ptr<const lab::Picture> picture = batch_.picture(shot, {}, [&](int done, int of) {
    int now = int(int64_t(cost) * done / std::max(of, 1));
    pace_.advance(now - last);
    last = now;
  });
  pace_.advance(cost - last);
  return picture;
}

void Runner::prepareTruth(const Group& group) {
  truth_shot_ = truthShotOf(experiment_, group);
  std::shared_ptr<const lab::Picture> before = truth_;
  truth_ = drawn(truth_shot_);
  if (truth_ == before) return;
  held_against_ = {};
  held_against_.color = lab::colorOf(*truth_);
  for (const std::string& region : experiment_.regions) {
    held_against_.masks[region] = lab::maskOf(*truth_, region);
    held_against_.sigma[region] = lab::sigmaOf(*truth_, held_against_.masks[region]);
  }
  if (experiment_.full_truth)
    held_against_.full = lab::colorOf(*drawn(truthShotOf(experiment_, group, *experiment_.full_truth)));
  held_against_.exposures = image::automaticExposures(held_against_.color, held_against_.color);
}

void Runner::warnOnce(const std::string& who, const std::vector<std::string>& warnings) {
  for (const std::string& warning : warnings)
    if (warned_.insert(warning).second) warn(who + ": " + warning);
}

// What a picture is held against: truth, its own at the benign value, what is in front of what it knows.
Sight Runner::sightOf(const Group& group, const Arm& arm, const lab::Picture& picture) {
  Sight sight;
  sight.role = arm.role;
  sight.truth = &held_against_;
  sight.picture = &picture;
  sight.color = lab::colorOf(picture);
  auto of = [](const std::map<std::string, Image>& images, const std::string& name) {
    auto found = images.find(name);
    return found == images.end() ? nullptr : &found->second;
  };
  bool along = walkedAxis(experiment_, group) != nullptr;
  if (along && isBenign(experiment_, group)) benign_[arm.name] = sight.color;
  sight.benign = along ? of(benign_, arm.name) : nullptr;
  const std::optional<Background>& background = experiment_.background;
  if (background && background->front == arm.name) fronts_[arm.name] = sight.color;
  if (!background || background->arm != arm.name) return sight;
  for (const std::string& output : {background->color, background->valid})
    if (!picture.frame.outputs.count(output))
      throw Error(fmt::format("arm '{}' has no output '{}', which the background names", arm.name, output),
                  {experiment_.file});
  sight.background = &*background;
  sight.front = of(fronts_, background->front);
  return sight;
}

Point Runner::pointOf(const Group& group, const Arm& arm, const lab::Shot& shot,
                      const std::vector<std::string>& names) {
  bool is_truth = arm.role == Role::truth;
  std::shared_ptr<const lab::Picture> picture = is_truth ? truth_ : drawn(shot);
  Sight sight = sightOf(group, arm, *picture);
  sight.bytes = plan::bytesAliased(*batch_.planOf(shot));
  Point point;
  point.arm = arm.name;
  point.role = arm.role;
  point.values = measured(sight, names, experiment_.regions);
  point.limits = limitsMet(*picture);
  point.command = commandOf(experiment_.shots[group.shot], shot);
  std::string at = describe(experiment_, group);
  warnOnce(fmt::format("{}{}, {}", experiment_.shots[group.shot].title, at.empty() ? "" : ", " + at, arm.name),
           picture->warnings);
  if (pictures_) write(group, arm, shot, *picture, point);
  return point;
}

// The EXR holds colour and what tables are made from; the record has the hash of every output.
void Runner::write(const Group& group, const Arm& arm, const lab::Shot& shot, const lab::Picture& picture,
                   Point& point) const {
  const StudiedShot& studied = experiment_.shots[group.shot];
  std::string name = fileNameOf(arm.name);
  for (const At& at : group.at)
    if (at.value != 0) name += "_" + fileNameOf(experiment_.axes[at.axis].values[at.value].label);
  std::string stem = fileNameOf(studied.title) + "/" + name;
  std::set<std::string> kept = {"color", "error"};
  if (arm.role == Role::truth) kept.insert(experiment_.regions.begin(), experiment_.regions.end());
  lab::Picture written = picture;
  std::erase_if(written.frame.outputs, [&](const auto& output) { return !kept.count(output.first); });
  lab::writePicture(written, folder_ / (stem + ".exr"), false);
  point.measured = point.shown = stem + ".exr";
  Image shown = lab::colorOf(picture);
  if (studied.picture_aa > 1) {
    lab::Shot box = shot;
    box.sets = joined(box.sets, arm.box);
    box.aa = arm.box.empty() ? studied.picture_aa : 1;
    lab::Picture boxed = *batch_.picture(box, {"color"});
    shown = lab::colorOf(boxed);
    point.shown = stem + "_shown.exr";
    lab::writePicture(boxed, folder_ / point.shown, false);
  }
  point.record = stem + ".record.json";
  point.picture = stem + ".png";
  image::writePng(folder_ / point.picture, image::toneMap(shown, studied.tone));
}

// Exposure and the like as the scene supplied them, and where the crops lie, from the shot's first truth.
void Runner::describeShot(const Group& group) {
  ShotSummary& summary = results_.shots[group.shot];
  if (summary.fps != 0) return;
  const Json& shot = truth_->record["shot"];
  summary.fps = shot["fps"].get<double>();
  summary.exposure = shot["exposure"].get<double>();
  if (summary.attribution.empty()) summary.attribution = attributionOf(truth_->record["scene"]);
  if (!pictures_) return;
  for (const Crop& crop : experiment_.shots[group.shot].crops) summary.crops.push_back(placed(crop));
}

image::Rectangle Runner::placed(const Crop& crop) const {
  double scale_x = double(experiment_.width) / experiment_.file_width,
         scale_y = double(experiment_.height) / experiment_.file_height;
  auto inner = held_against_.masks.find("inner");
  image::Rectangle size{0, 0, pictures_->crop_width, pictures_->crop_height};
  if (crop) return scaledCrop(*crop, scale_x, scale_y, held_against_.color);
  image::Rectangle scaled = scaledCrop(size, scale_x, scale_y, held_against_.color);
  if (inner != held_against_.masks.end()) return densestCrop(inner->second, scaled.width, scaled.height);
  return {(held_against_.color.width - scaled.width) / 2, (held_against_.color.height - scaled.height) / 2,
          scaled.width, scaled.height};
}

void Runner::group(size_t index) {
  const Group& group = experiment_.groups[index];
  const StudiedShot& shot = experiment_.shots[group.shot];
  std::vector<std::string> names = measuresOf(experiment_, group);
  PointGroup& result = results_.groups[index];
  prepareTruth(group);
  describeShot(group);
  result.shot = shot.name;
  result.anchor = truth_shot_.anchor;
  for (const At& at : group.at)
    result.at.emplace_back(experiment_.axes[at.axis].name, experiment_.axes[at.axis].values[at.value].value);
  result.points.push_back(pointOf(group, experiment_.truth, truth_shot_, names));
  fronts_.clear();
  for (size_t number : group.arms) {
    const Arm& arm = experiment_.arms[number];
    lab::Shot of_arm = shotOf(experiment_, group, arm);
    result.points.push_back(pointOf(group, arm, of_arm, names));
    // What runs in loops (truth) is not timed.
    if (wantsTime(names) && loopCost(batch_, of_arm) == 0)
      timed_.push_back({index, result.points.size() - 1, of_arm, names});
  }
  std::string at = describe(experiment_, group);
  pace_.finish(shot.title + (at.empty() ? "" : ", " + at));
}

// One after the other, as often as there are rounds, so that what else the machine does meets all alike.
void Runner::timeInTurn() {
  std::vector<lab::Shot> shots;
  for (const Timed& one : timed_) shots.push_back(one.shot);
  if (shots.empty()) return;
  std::vector<lab::Timing> timings = batch_.timeInTurn(shots, experiment_.rounds);
  for (size_t i = 0; i < timed_.size(); ++i) {
    Sight sight;
    sight.times_ms = timings[i].ms;
    Values& values = results_.groups[timed_[i].group].points[timed_[i].point].values;
    for (const char* name : {"ms", "ms_least"})
      if (contains(timed_[i].names, name)) values[name]["all"] = measureNamed(name).of(sight, "", {});
  }
  timed_.clear();
}

void Runner::walk(const std::vector<size_t>& groups) {
  benign_.clear();
  for (size_t index : groups) {
    const StudiedShot& shot = experiment_.shots[experiment_.groups[index].shot];
    if (shot.missing.empty()) group(index);
    else if (warned_.insert(shot.name).second) note(fmt::format("{}: skipped, {}", shot.title, shot.missing));
  }
  timeInTurn();
}

}  // namespace

Results run(const Experiment& experiment, lab::Workbench& bench, const Path& folder) {
  Results results = outlineOf(experiment);
  const gpu::DeviceInfo& device = bench.device().info();
  results.device = device.name, results.driver = device.driver, results.software = device.software;
  results.groups.resize(experiment.groups.size());
  lab::Batch batch(bench);
  int count = 0, cost = 0;
  for (const Group& group : experiment.groups)
    if (int own = costOf(experiment, group, batch)) ++count, cost += own;
  lab::Pace pace("sweep", count, cost);
  Runner runner(experiment, batch, folder, results, pace);
  for (const std::vector<size_t>& walk : walksOf(experiment)) runner.walk(walk);
  std::erase_if(results.groups, [](const PointGroup& group) { return group.points.empty(); });
  if (experiment.expectations) judgeResults(bench.home(), results, experiment.file);
  return results;
}

}  // namespace strobe::study
