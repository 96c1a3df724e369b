// SPDX-License-Identifier: MIT
// What a sweep has to draw and measure, with what identifies each result before it is drawn.
#pragma once

#include "lab/batch.h"
#include "study/experiment.h"
#include "study/layout.h"
#include "study/store.h"

namespace strobe::study {

// One arm, or truth, at a group's values.
struct Task {
  const Arm* arm = nullptr;
  lab::Shot shot;
  std::vector<std::string> measures;
  std::string key;        // content of all that makes the result but its times; "" where it is refused
  std::string refused;    // why it cannot be drawn
  int cost = 0;           // in time samples of truth
  bool timed = false;     // times are among the measures, and it is no truth
  bool compares = false;  // differences from the benign value are among them
};

// The tasks of a group: truth, then its arms in their order.
struct TaskGroup {
  const Group* group = nullptr;
  std::vector<Task> tasks;
  std::vector<std::string> truth_keys, full_keys;  // contents of the truths, by frame of the sequence
  std::optional<lab::Shot> full;                   // the second truth

  const Task& truth() const { return tasks.front(); }
};

// Of groups whose shots can be rendered; scripts run and scenes are loaded, nothing is drawn. The experiment must
// outlive them.
std::vector<TaskGroup> tasksOf(const Experiment& experiment, lab::Batch& batch);

// Groups of which the store does not have everything, and what the rest costs in time samples of truth.
struct Left {
  std::vector<const TaskGroup*> groups;
  int cost = 0;
};
Left leftOf(const std::vector<TaskGroup>& groups, const Store& store);

// Content of a truth: of its picture, of what draws it, and of the standard error it must have.
std::string truthKeyOf(const Experiment& experiment, lab::Batch& batch, const lab::Shot& truth);

// The pictures of a task: one, or a sequence.
std::vector<lab::Shot> sequenceOf(const Experiment& experiment, const Group& group, const lab::Shot& shot);

// The group with the benign value of the one axis along which a group lies, which may be the group itself.
std::optional<Group> benignOf(const Experiment& experiment, const Group& group);

}  // namespace strobe::study
