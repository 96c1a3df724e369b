// SPDX-License-Identifier: MIT
#include "live/sweep_file.h"

#include <algorithm>

#include "live/shot_text.h"
#include "script/lua_text.h"

namespace strobe::live {

using script::field, script::luaOf, script::quoted, script::tableOf;

namespace {

bool isSwept(const SavedSweep& sweep, const std::string& name) {
  return std::any_of(sweep.axes.begin(), sweep.axes.end(),
                     [&](const SweepAxis& axis) { return axis.declaration.name == name; });
}

std::string shotText(const SavedSweep& sweep) {
  std::vector<std::string> fields = {field("name", quoted(Path(sweep.shot.scene).stem().string())),
                                     field("scene", quoted(sweep.shot.scene))};
  auto is_swept = [&](const std::string& name) { return isSwept(sweep, name); };
  for (const std::string& option : optionFields(sweep.shot, sweep.suggested, is_swept)) fields.push_back(option);
  for (const std::string& set : settingFields(sweep.shot.sets, true, is_swept)) fields.push_back(set);
  return tableOf(fields);
}

std::string armText(const SavedSweep& sweep) {
  std::vector<std::string> fields = {field("name", quoted(Path(sweep.shot.pipeline).stem().string())),
                                     field("pipeline", quoted(sweep.shot.pipeline))};
  std::vector<std::string> sets =
      settingFields(sweep.shot.sets, false, [&](const std::string& name) { return isSwept(sweep, name); });
  if (!sets.empty()) fields.push_back(field("set", tableOf(sets)));
  return tableOf(fields);
}

bool grows(const SweepAxis& axis) {
  return hasRange(axis.declaration) && std::is_sorted(axis.values.begin(), axis.values.end());
}

std::string axisText(const SweepAxis& axis, const lab::Shot& shot) {
  std::vector<std::string> fields = {field("name", quoted(axis.declaration.name))}, values;
  if (!axis.declaration.unit.empty()) fields.push_back(field("unit", quoted(axis.declaration.unit)));
  if (grows(axis)) fields.push_back(field("scale", axis.logarithmic ? "\"log\"" : "\"linear\""));
  for (const plan::Value& value : axis.values) values.push_back(luaOf(value));
  fields.push_back(field("values", tableOf(values)));
  std::string size;
  if (axis.declaration.name == "width") size = fmt::format("{{ value, {} }}", shot.height);
  if (axis.declaration.name == "height") size = fmt::format("{{ {}, value }}", shot.width);
  if (!size.empty()) fields.push_back(fmt::format("at = function(value) return {{ size = {} }} end", size));
  return "experiment.list " + tableOf(fields);
}

// Names of the axes: "a", or "a and b".
std::string namesOf(const SavedSweep& sweep) {
  std::vector<std::string> names;
  for (const SweepAxis& axis : sweep.axes) names.push_back(axis.declaration.name);
  return fmt::format("{}", fmt::join(names, " and "));
}

std::string truthText(const SavedSweep& sweep) {
  std::vector<std::string> fields = {field("pipeline", quoted(sweep.truth))}, sets;
  for (const auto& [name, value] : sweep.truth_sets) sets.push_back(field(name, luaOf(value)));
  if (!sets.empty()) fields.push_back(field("set", tableOf(sets)));
  return tableOf(fields);
}

}  // namespace

std::string experimentText(const SavedSweep& sweep) {
  std::string names = namesOf(sweep), axes;
  for (const SweepAxis& axis : sweep.axes) axes += "    " + axisText(axis, sweep.shot) + ",\n";
  std::string text = "-- Saved from a sweep in the window. Command of one picture:\n-- " + lab::commandOf(sweep.shot) +
                     "\nlocal experiment = require \"strobe.experiment\"\n\nreturn experiment {\n";
  auto line = [&text](const char* name, const std::string& value) {
    text += fmt::format("  {:<8} = {},\n", name, value);
  };
  line("title", quoted(fmt::format("{} of {}", names, Path(sweep.shot.pipeline).stem().string())));
  line("question", quoted(fmt::format("How do error and time follow {}?", names)));
  line("size", fmt::format("{{ {}, {} }}", sweep.shot.width, sweep.shot.height));
  line("shots", tableOf({shotText(sweep)}));
  line("arms", tableOf({armText(sweep)}));
  line("truth", truthText(sweep));
  line("vary", "{\n" + axes + "  }");
  line("rounds", "5");
  line("regions", sweep.regions ? R"({ "whole", "inner", "outer" })" : R"({ "whole" })");
  line("measures", R"({ "rmse", "flip", "ms", "ms_ratio" })");
  line("layout", R"({ front = { x = "ms_ratio", y = "rmse" }, table = {} })");
  return text + "}\n";
}

}  // namespace strobe::live
