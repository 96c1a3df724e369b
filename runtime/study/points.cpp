// SPDX-License-Identifier: MIT
#include "study/points.h"

#include <algorithm>
#include <map>
#include <set>

#include "base/lists.h"
#include "study/measures.h"

namespace strobe::study {

namespace {

// Allowed values, by "arm", "shot" or the name of an axis; an empty list allows every value.
using Conditions = std::map<std::string, std::vector<std::string>>;

void requireOneOf(const std::string& name, const std::vector<std::string>& known, const std::string& what) {
  if (contains(known, name)) return;
  throw Error(fmt::format("--only: unknown {} '{}'{}; there {} {}", what, name, didYouMean(name, known),
                          known.size() == 1 ? "is" : "are", fmt::join(known, ", ")),
              {}, 2);
}

void requireKnown(const Experiment& experiment, const std::string& name, const std::string& value, bool has_value) {
  if (name == "arm") return requireOneOf(value, namesOf(experiment.arms), "arm");
  if (name == "shot") return requireOneOf(value, namesOf(experiment.shots), "shot");
  std::vector<std::string> names = namesOf(experiment.axes);
  names.insert(names.end(), {"arm", "shot"});
  requireOneOf(name, names, "axis");
  for (const Axis& axis : experiment.axes)
    if (axis.name == name && has_value) requireOneOf(value, axis.labels, "value of " + name);
}

// Conditions between commas. A part without "=" that is not an axis belongs to the condition before it, because names
// may have commas.
std::vector<std::string> partsOf(const Experiment& experiment, const std::string& expression) {
  std::vector<std::string> parts, axes = namesOf(experiment.axes);
  for (size_t start = 0; start <= expression.size();) {
    size_t end = std::min(expression.find(',', start), expression.size());
    std::string one = expression.substr(start, end - start);
    bool begins = one.find('=') != std::string::npos || contains(axes, one);
    if (begins || parts.empty()) parts.push_back(one);
    else parts.back() += "," + one;
    start = end + 1;
  }
  return parts;
}

Conditions conditionsOf(const Experiment& experiment, const std::string& expression) {
  Conditions conditions;
  for (const std::string& one : partsOf(experiment, expression)) {
    size_t equals = one.find('=');
    bool has_value = equals != std::string::npos;
    std::string name = one.substr(0, equals), value = has_value ? one.substr(equals + 1) : "";
    requireKnown(experiment, name, value, has_value);
    std::vector<std::string>& allowed = conditions[name];
    if (has_value) allowed.push_back(value);
  }
  return conditions;
}

bool allows(const Conditions& conditions, const std::string& name, const std::string& value) {
  auto found = conditions.find(name);
  if (found == conditions.end() || found->second.empty()) return true;
  return contains(found->second, value);
}

// True if the group lies on every axis of the conditions, at an allowed value.
bool isAt(const Experiment& experiment, const Group& group, const Conditions& conditions) {
  return std::all_of(conditions.begin(), conditions.end(), [&](const auto& condition) {
    const std::string& name = condition.first;
    if (name == "arm" || name == "shot") return true;
    return std::any_of(group.at.begin(), group.at.end(), [&](const At& at) {
      const Axis& axis = experiment.axes[at.axis];
      return axis.name == name && allows(conditions, name, axis.labels[at.value]);
    });
  });
}

// Base arm of the time ratios (by default the first method), if ratios are measured and the group is the first of its
// shot with this arm.
std::optional<size_t> baseIn(const Experiment& experiment, const Group& group) {
  auto baseAmong = [&](const Group& one) -> std::optional<size_t> {
    for (size_t arm : one.arms) {
      const StudiedArm& of = experiment.arms[arm];
      if (experiment.base.empty() ? of.role == ArmRole::method : of.name == experiment.base) return arm;
    }
    return std::nullopt;
  };
  bool has_ratios = std::any_of(experiment.measures.begin(), experiment.measures.end(),
                                [](const std::string& name) { return measureNamed(name).to_base; });
  auto first = std::find_if(experiment.groups.begin(), experiment.groups.end(),
                            [&](const Group& one) { return one.shot == group.shot && baseAmong(one); });
  bool is_first = has_ratios && first != experiment.groups.end() && first->at == group.at;
  return is_first ? baseAmong(group) : std::nullopt;
}

}  // namespace

void keepOnly(Experiment& experiment, const std::string& expression) {
  Conditions conditions = conditionsOf(experiment, expression);
  auto isAsked = [&](const Group& group, size_t arm) {
    const StudiedArm& one = experiment.arms[arm];
    return allows(conditions, "shot", experiment.shots[group.shot].name) && isAt(experiment, group, conditions) &&
           (one.role != ArmRole::method || allows(conditions, "arm", one.name));
  };
  std::set<size_t> shots;  // shots with a selected point
  for (const Group& group : experiment.groups)
    for (size_t arm : group.arms)
      if (isAsked(group, arm)) shots.insert(group.shot);
  std::vector<Group> kept;
  for (Group group : experiment.groups) {
    std::optional<size_t> base = shots.count(group.shot) ? baseIn(experiment, group) : std::nullopt;
    std::erase_if(group.arms, [&](size_t arm) { return !isAsked(group, arm) && arm != base; });
    if (!group.arms.empty()) kept.push_back(group);
  }
  if (kept.empty()) throw Error(fmt::format("--only '{}': no point matches", expression), {}, 2);
  experiment.partial = true;
  experiment.groups = kept;
}

std::string describe(const Experiment& experiment, const Group& group) {
  std::vector<std::string> parts;
  for (const At& at : group.at) {
    const Axis& axis = experiment.axes[at.axis];
    parts.push_back(axis.name + " " + axis.labels[at.value]);
  }
  return fmt::format("{}", fmt::join(parts, ", "));
}

std::string listOf(const Experiment& experiment) {
  std::string text;
  size_t number = 0;
  for (const Group& group : experiment.groups) {
    std::string at = describe(experiment, group);
    for (size_t arm : group.arms)
      text += fmt::format("{}  {}{}  {}\n", ++number, experiment.shots[group.shot].name, at.empty() ? "" : "  " + at,
                          experiment.arms[arm].name);
  }
  return text;
}

}  // namespace strobe::study
