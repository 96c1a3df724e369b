// SPDX-License-Identifier: MIT
// Tasks of a sweep: pictures to draw and measure. A key identifies each result before it is drawn.
#pragma once

#include <map>

#include "lab/batch.h"
#include "study/experiment.h"
#include "study/store.h"

namespace strobe::study {

// Picture of one arm, or of truth, at the values of a group.
struct Task {
  const StudiedArm* arm = nullptr;
  lab::Shot shot;
  std::vector<std::string> measures;
  std::string key;        // hash of all that determines the result, except times; "": refused
  std::string refused;    // reason why the picture cannot be drawn
  int cost = 0;           // in time samples of truth
  bool timed = false;     // times are measured
  bool compares = false;  // differences from the benign value are measured
};

// Tasks of a group: truth, then the arms in their order.
struct TaskGroup {
  const Group* group = nullptr;
  const StudiedShot* studied = nullptr;
  std::vector<Task> tasks;
  std::vector<std::string> truth_keys, full_keys;  // keys of the truths, by frame of the sequence
  std::optional<lab::Shot> full;                   // the second truth
  bool is_mine = true;                             // in the share of this program

  const Task& truth() const { return tasks.front(); }
};

// Tasks of all groups with shots that can be rendered. Runs scripts and loads scenes; draws nothing. The experiment
// must outlive the tasks.
std::vector<TaskGroup> tasksOf(const Experiment& experiment, lab::Batch& batch);

// Groups of this program's share with missing results in the store, and the cost of the missing results in time samples
// of truth. Results that are set aside are not missing.
struct Remaining {
  std::vector<const TaskGroup*> groups;
  std::map<std::string, size_t> tries;  // number of failed tries of each missing result, by key
  size_t set_aside = 0;
  int cost = 0;
};
Remaining remainingOf(const std::vector<TaskGroup>& groups, const Store& store);

// Key of a truth: hash of its content, of program and device, and of the required standard error.
std::string truthKeyOf(const Experiment& experiment, lab::Batch& batch, const lab::Shot& truth);

// Group at the benign value of the axis, for a group on exactly one axis; may be the same group.
std::optional<Group> benignOf(const Experiment& experiment, const Group& group);

}  // namespace strobe::study
