// SPDX-License-Identifier: MIT
#include "study/tasks.h"

#include <algorithm>
#include <set>

#include "base/hash.h"
#include "base/lists.h"
#include "lab/record.h"
#include "study/measures.h"

namespace strobe::study {

namespace {

constexpr int kFrameCost = 12;  // cost of one frame of a method, in time samples of truth

// ---- measures

bool hasAxis(const Experiment& experiment, const Group& group, const std::string& name) {
  return std::any_of(group.at.begin(), group.at.end(),
                     [&](const At& at) { return experiment.axes[at.axis].name == name; });
}

// True if the first measured shot of the axis is the shot of the group.
bool isFirstShot(const Experiment& experiment, const Group& group, const std::string& axis) {
  for (const Group& other : experiment.groups)
    if (hasAxis(experiment, other, axis)) return other.shot == group.shot;
  return false;
}

// Measures that the experiment requests or that its layout shows for a group.
std::vector<std::string> measuresOf(const Experiment& experiment, const Group& group) {
  std::vector<std::string> wanted = experiment.measures;
  auto add = [&](const std::vector<std::string>& names) { wanted.insert(wanted.end(), names.begin(), names.end()); };
  add({"rmse", "pixels", "broken"});
  const ReportLayout& layout = experiment.layout;
  if (layout.pictures) add({"displacement", "clamped"});
  if (layout.curves) add({"contrast", "change", "changed"});
  if (layout.front) add({layout.front->x, layout.front->y});
  if (experiment.background) add({"background_deviation", "background_difference", "background_pixels", "clamped"});
  if (layout.table) {
    for (const std::string& axis : layout.table->axes) {
      if (!hasAxis(experiment, group, axis)) continue;
      add(layout.table->cells);
      if (isFirstShot(experiment, group, axis)) add(layout.table->once);
    }
    if (layout.table->share) add({"contrast"});
  }
  std::vector<std::string> ordered;
  for (const std::string& name : measureNames())
    if (contains(wanted, name)) ordered.push_back(name);
  return ordered;
}

// ---- cost

// Iterations of all loops of a pipeline; 0 without loops.
int loopCost(const plan::PipelineDesc& pipeline) {
  int64_t cost = 0;
  for (const plan::LoopDesc& loop : pipeline.loops) {
    if (loop.count.value) cost += std::get<int64_t>(*loop.count.value);
    for (const auto& [name, value] : pipeline.values)
      if (name == loop.count.follows) cost += std::get<int64_t>(value);
  }
  return int(cost);
}

// ---- identity

// Key of a result: the hash of its content, and a hash of the device. The same content gives the same picture by the
// same program on the same device.
std::string keyOf(const std::string& content, lab::Batch& batch) {
  const gpu::DeviceInfo& device = batch.bench().device().info();
  return hashText(content) + "_" + hashText(device.name + "|" + device.driver).substr(0, 8);
}

std::vector<std::string> contentsOfKeys(const std::vector<std::string>& keys) {
  std::vector<std::string> contents;
  for (const std::string& key : keys) contents.push_back(keyWithoutDevice(key));
  return contents;
}

std::vector<std::string> contentsOf(const StudiedShot& studied, const lab::Shot& shot, lab::Batch& batch) {
  std::vector<std::string> contents;
  for (const lab::Shot& one : sequenceOf(studied, shot)) contents.push_back(batch.contentOf(one));
  return contents;
}

std::vector<std::string> truthKeysOf(const Experiment& experiment, const StudiedShot& studied, const lab::Shot& truth,
                                     lab::Batch& batch) {
  std::vector<std::string> keys;
  for (const lab::Shot& one : sequenceOf(studied, truth)) keys.push_back(truthKeyOf(experiment, batch, one));
  return keys;
}

// Everything that determines the crops of a shot in a picture of truth.
Json cropParts(const Experiment& experiment, const StudiedShot& studied) {
  const PicturesLayout size = experiment.layout.pictures.value_or(PicturesLayout());
  Json parts = {size.crop_width, size.crop_height, experiment.file_width, experiment.file_height};
  for (const Crop& crop : studied.wanted_crops)
    parts.push_back(crop ? Json{crop->x, crop->y, crop->width, crop->height} : Json("inner"));
  return parts;
}

// Everything that determines a result.
Json partsOf(const Experiment& experiment, const TaskGroup& group, const Task& task, lab::Batch& batch) {
  Json parts = {{"program", lab::programHash()},
                {"truth", contentsOfKeys(group.truth_keys)},
                {"full", contentsOfKeys(group.full_keys)},
                {"regions", experiment.regions},
                {"role", nameOf(task.arm->role)}};
  parts["picture"] =
      task.arm->role == ArmRole::truth ? parts["truth"] : Json(contentsOf(*group.studied, task.shot, batch));
  if (task.arm->role == ArmRole::truth) parts["crops"] = cropParts(experiment, *group.studied);
  for (const std::string& name : task.measures)
    if (!measureNamed(name).isTime()) parts["measures"].push_back(name);
  std::optional<Group> benign = benignOf(experiment, *group.group);
  if (benign && task.compares)
    parts["benign"] =
        task.arm->role == ArmRole::truth
            ? contentsOfKeys(truthKeysOf(experiment, *group.studied, truthShotOf(experiment, *benign), batch))
            : contentsOf(*group.studied, shotOf(experiment, *benign, *task.arm), batch);
  const std::optional<Background>& background = experiment.background;
  if (background && background->arm == task.arm->name)
    for (const StudiedArm& arm : experiment.arms)
      if (arm.name == background->front)
        parts["front"] = contentsOf(*group.studied, shotOf(experiment, *group.group, arm), batch);
  if (experiment.layout.pictures) {
    const StudiedShot& studied = *group.studied;
    lab::Shot box = task.shot;
    box.sets = joined(box.sets, task.arm->box);
    parts["shown"] = {batch.contentOf(box),    studied.picture_aa, studied.tone.stops,
                      int(studied.tone.curve), studied.title,      task.arm->name};
  }
  return parts;
}

void complete(const Experiment& experiment, const TaskGroup& group, Task& task, lab::Batch& batch) {
  try {
    std::shared_ptr<const plan::PipelineDesc> pipeline = batch.evaluate(task.shot.pipeline, task.shot.sets);
    bool is_truth = pipeline->kind == plan::PipelineDesc::Kind::Truth;
    int cost = loopCost(*pipeline) + (is_truth ? 0 : kFrameCost);
    task.cost = cost * int(sequenceOf(*group.studied, task.shot).size());
    for (const std::string& name : task.measures) {
      const Measure& measure = measureNamed(name);
      task.timed = task.timed || (measure.isTime() && task.arm->timed.value_or(!is_truth));
      task.compares = task.compares || measure.needs == Needs::benign;
    }
    task.key = keyOf(partsOf(experiment, group, task, batch).dump(), batch);
  } catch (const Error& error) {
    task.refused = error.what();
  }
}

TaskGroup groupOf(const Experiment& experiment, const Group& group, lab::Batch& batch) {
  TaskGroup result;
  result.group = &group, result.studied = &experiment.shots[group.shot];
  std::vector<std::string> names = measuresOf(experiment, group);
  result.tasks.push_back({&experiment.truth, truthShotOf(experiment, group), names});
  for (size_t arm : group.arms)
    result.tasks.push_back({&experiment.arms[arm], shotOf(experiment, group, experiment.arms[arm]), names});
  try {
    result.truth_keys = truthKeysOf(experiment, *result.studied, result.truth().shot, batch);
    if (experiment.full_truth) result.full = truthShotOf(experiment, group, *experiment.full_truth);
    if (result.full) result.full_keys = truthKeysOf(experiment, *result.studied, *result.full, batch);
  } catch (const Error& error) {
    for (Task& task : result.tasks) task.refused = std::string("truth: ") + error.what();
  }
  for (Task& task : result.tasks)
    if (task.refused.empty()) complete(experiment, result, task, batch);
  return result;
}

}  // namespace

std::string truthKeyOf(const Experiment& experiment, lab::Batch& batch, const lab::Shot& truth) {
  return keyOf(fmt::format("{}|{}|{}", batch.contentOf(truth), lab::programHash(), experiment.truth_error), batch);
}

std::optional<Group> benignOf(const Experiment& experiment, const Group& group) {
  if (group.at.size() != 1) return std::nullopt;
  const std::optional<size_t>& benign = experiment.axes[group.at[0].axis].benign;
  if (!benign) return std::nullopt;
  Group result = group;
  result.at[0].value = *benign;
  return result;
}

Remaining remainingOf(const std::vector<TaskGroup>& groups, const Store& store) {
  Remaining remaining;
  std::set<std::string> seen;  // full truths, and results that are set aside
  for (const TaskGroup& group : groups) {
    bool lacks = false;
    for (const Task& task : group.tasks) {
      if (!group.is_mine || task.key.empty() || seen.count(task.key) || store.has(task.key)) continue;
      const size_t tries = store.triesOf(task.key);
      if (tries >= kMostTries && !store.retries) {
        ++remaining.set_aside, seen.insert(task.key);
        continue;
      }
      lacks = true;
      if (remaining.tries.emplace(task.key, tries).second) remaining.cost += task.cost;
    }
    if (!lacks) continue;
    remaining.groups.push_back(&group);
    if (group.full && seen.insert(group.full_keys.front()).second) remaining.cost += group.truth().cost;
  }
  return remaining;
}

std::vector<TaskGroup> tasksOf(const Experiment& experiment, lab::Batch& batch) {
  const std::vector<size_t> shares = sharesOf(experiment, experiment.share.of);
  std::vector<TaskGroup> groups;
  for (size_t i = 0; i < experiment.groups.size(); ++i) {
    const Group& group = experiment.groups[i];
    if (!experiment.shots[group.shot].missing.empty()) continue;
    groups.push_back(groupOf(experiment, group, batch));
    groups.back().is_mine = shares[i] == experiment.share.index;
  }
  return groups;
}

}  // namespace strobe::study
