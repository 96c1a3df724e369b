// SPDX-License-Identifier: MIT
#include "study/run.h"

#include <algorithm>

#include "base/log.h"
#include "lab/pace.h"
#include "study/point_renderer.h"
#include "study/points.h"

namespace strobe::study {

namespace {

std::string titleOf(const Experiment& experiment, const TaskGroup& group) {
  std::string at = describe(experiment, *group.group);
  return experiment.shots[group.group->shot].title + (at.empty() ? "" : ", " + at);
}

// ---- drawing

void renderHere(const Experiment& experiment, lab::Batch& batch, const Store& store, const Left& left) {
  if (left.groups.empty()) return;
  lab::Pace pace("sweep", int(left.groups.size()), left.cost);
  PointRenderer renderer(experiment, batch, store);
  for (const TaskGroup* group : left.groups) {
    renderer.render(*group, [&](int by) { pace.advance(by); });
    pace.finish(titleOf(experiment, *group));
  }
}

// ---- times

// Groups of one shot along one axis are timed together, the others alone.
std::vector<std::vector<const TaskGroup*>> walksOf(const Experiment& experiment, const std::vector<TaskGroup>& groups) {
  std::vector<std::vector<const TaskGroup*>> walks;
  for (const TaskGroup& group : groups) {
    const Group* last = walks.empty() ? nullptr : walks.back().back()->group;
    bool along = last && benignOf(experiment, *group.group) && last->at.size() == 1;
    bool same = along && last->shot == group.group->shot && last->at[0].axis == group.group->at[0].axis;
    if (!same) walks.emplace_back();
    walks.back().push_back(&group);
  }
  return walks;
}

// What times of a shot are ratios to: the base arm, else the first that is timed, where it comes first.
const Task* baseOf(const Experiment& experiment, const std::vector<TaskGroup>& groups, const Store& store,
                   size_t shot) {
  const Task* first = nullptr;
  for (const TaskGroup& group : groups)
    for (const Task& task : group.tasks) {
      if (group.group->shot != shot || !task.timed || !store.has(task.key)) continue;
      if (task.arm->name == experiment.base) return &task;
      if (!first) first = &task;
    }
  return first;
}

// Times that are ratios to something else, or of other rounds, are measured again.
std::string timesOf(const Experiment& experiment, const Task& task, const Task& base) {
  bool is_ratio = std::find(task.measures.begin(), task.measures.end(), "ms_ratio") != task.measures.end();
  const lab::Rounds& rounds = experiment.rounds;
  return fmt::format("{} to {} rounds, {}{}", rounds.least, rounds.most, rounds.within,
                     is_ratio ? ", base " + base.key : "");
}

bool lacksTimes(const Experiment& experiment, const Task& task, const Task& base, const Store& store) {
  if (!task.timed || !store.has(task.key)) return false;
  Point point = *store.point(task.key);
  return point.times != timesOf(experiment, task, base) ||
         std::any_of(task.measures.begin(), task.measures.end(),
                     [&](const std::string& name) { return measureNamed(name).is_time && !point.values.count(name); });
}

void keepTimes(const Store& store, const Task& task, const std::string& times, const lab::Timing& own,
               const lab::Timing& base) {
  Sight sight;
  sight.times_ms = own.ms, sight.base_ms = base.ms;
  Point point = *store.point(task.key);
  point.times = times;
  for (const std::string& name : task.measures)
    if (measureNamed(name).is_time) point.values[name]["all"] = measureNamed(name).of(sight, "", {});
  store.keep(task.key, point);
}

// One after the other, so that what else the machine does meets all alike; the base among them.
void timeInTurn(const Experiment& experiment, lab::Batch& batch, const Store& store,
                const std::vector<TaskGroup>& groups, const std::vector<const TaskGroup*>& walk) {
  const Task* base = baseOf(experiment, groups, store, walk.front()->group->shot);
  std::vector<const Task*> tasks;
  for (const TaskGroup* group : walk)
    for (const Task& task : group->tasks)
      if (base && lacksTimes(experiment, task, *base, store)) tasks.push_back(&task);
  if (tasks.empty()) return;
  std::vector<lab::Shot> shots = {base->shot};
  for (const Task* task : tasks) shots.push_back(task->shot);
  std::vector<lab::Timing> timings = batch.timeInTurn(shots, experiment.rounds);
  for (size_t i = 0; i < tasks.size(); ++i)
    keepTimes(store, *tasks[i], timesOf(experiment, *tasks[i], *base), timings[i + 1], timings.front());
}

// ---- results

// What a scene's file says of its author: its copyright, else the first line of the text beside it.
std::string attributionOf(const Json& scene) {
  if (!scene.contains("attribution") || !scene["attribution"].is_object()) return "";
  const Json& said = scene["attribution"];
  if (said.contains("copyright") && said["copyright"].is_string()) return said["copyright"].get<std::string>();
  std::string text = said.contains("text") && said["text"].is_string() ? said["text"].get<std::string>() : "";
  return text.substr(0, text.find('\n'));
}

// Exposure and the like as the scene supplied them, and where the crops lie, from a truth of the shot.
void describeShot(const Experiment& experiment, const TaskGroup& group, const Store& store, ShotSummary& summary) {
  auto none = []() -> std::shared_ptr<const lab::Picture> { throw Error("truth was not drawn"); };
  std::shared_ptr<const lab::Picture> truth = store.truth(group.truth_key, none);
  const Json& shot = truth->record["shot"];
  summary.fps = shot["fps"].get<double>();
  summary.exposure = shot["exposure"].get<double>();
  if (summary.attribution.empty()) summary.attribution = attributionOf(truth->record["scene"]);
  std::optional<PicturesLayout> pictures = picturesOf(experiment.layout);
  if (!pictures) return;
  TruthPicture against = truthPictureOf(experiment, *truth);
  for (const Crop& crop : experiment.shots[group.group->shot].crops)
    summary.crops.push_back(placedCrop(experiment, crop, *pictures, against));
}

PointGroup resultOf(const Experiment& experiment, const TaskGroup& group, const Store& store, std::string anchor) {
  const StudiedShot& studied = experiment.shots[group.group->shot];
  PointGroup result{studied.name, std::move(anchor), {}, {}};
  for (const At& at : group.group->at)
    result.at.emplace_back(experiment.axes[at.axis].name, experiment.axes[at.axis].values[at.value].value);
  for (const Task& task : group.tasks) {
    Point point;
    if (!task.key.empty()) point = store.point(task.key).value_or(Point());
    else point.failed = task.refused;
    point.arm = task.arm->name;
    point.role = task.arm->role;
    if (point.command.empty()) point.command = commandOf(studied, task.shot);
    result.points.push_back(std::move(point));
  }
  return result;
}

}  // namespace

Results run(const Experiment& experiment, lab::Workbench& bench, const Store& store) {
  for (const StudiedShot& shot : experiment.shots)
    if (!shot.missing.empty()) note(fmt::format("{}: skipped, {}", shot.title, shot.missing));
  lab::Batch batch(bench);
  std::vector<TaskGroup> groups = tasksOf(experiment, batch);
  renderHere(experiment, batch, store, leftOf(groups, store));
  for (const auto& walk : walksOf(experiment, groups)) timeInTurn(experiment, batch, store, groups, walk);

  Results results = outlineOf(experiment);
  const gpu::DeviceInfo& device = bench.device().info();
  results.device = device.name, results.driver = device.driver, results.software = device.software;
  for (const TaskGroup& group : groups) {
    ShotSummary& summary = results.shots[group.group->shot];
    bool has_truth = !group.truth().key.empty() && store.has(group.truth().key);
    if (summary.fps == 0 && has_truth) describeShot(experiment, group, store, summary);
    std::string anchor = group.truth().refused.empty() ? batch.filled(group.truth().shot).anchor : "";
    results.groups.push_back(resultOf(experiment, group, store, anchor));
  }
  if (experiment.expectations) judgeResults(bench.home(), results, experiment.file);
  return results;
}

}  // namespace strobe::study
