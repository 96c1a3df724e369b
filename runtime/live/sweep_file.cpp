// SPDX-License-Identifier: MIT
#include "live/sweep_file.h"

#include <algorithm>
#include <cctype>

namespace strobe::live {

namespace {

std::string quoted(const std::string& text) {
  std::string result = "\"";
  for (char c : text) {
    if (c == '"' || c == '\\') result += '\\';
    result += c == '\n' ? ' ' : c;
  }
  return result + "\"";
}

std::string luaOf(const plan::Value& value) {
  if (const auto* text = std::get_if<std::string>(&value)) return quoted(*text);
  return plan::textOf(value);
}

std::string luaOf(const Json& json) {
  if (json.is_string()) return quoted(json.get<std::string>());
  if (!json.is_array()) return json.dump();
  std::string list;
  for (const Json& one : json) list += fmt::format("{}{}", list.empty() ? "" : ", ", luaOf(one));
  return fmt::format("{{ {} }}", list);
}

std::string keyOf(const std::string& name) {
  bool plain = !name.empty() && !std::isdigit(static_cast<unsigned char>(name[0])) &&
               std::all_of(name.begin(), name.end(), [](unsigned char c) { return std::isalnum(c) || c == '_'; });
  return plain ? name : fmt::format("[{}]", quoted(name));
}

// "{ a = 1, b = 2 }".
std::string tableOf(const std::vector<std::string>& fields) { return fmt::format("{{ {} }}", fmt::join(fields, ", ")); }

std::string field(const std::string& name, const std::string& text) { return keyOf(name) + " = " + text; }

// "NODE=x,y,z" of the command line as a field.
std::string motion(const std::string& text) {
  size_t at = text.rfind('=');
  if (at == std::string::npos) return field(text, "{}");
  std::string numbers;
  for (char c : text.substr(at + 1)) numbers += c == ',' ? ", " : std::string(1, c);
  return field(text.substr(0, at), fmt::format("{{ {} }}", numbers));
}

bool isSwept(const SavedSweep& sweep, const std::string& name) {
  return std::any_of(sweep.axes.begin(), sweep.axes.end(),
                     [&](const SweepAxis& axis) { return axis.declaration.name == name; });
}

// Settings of the scene, or of the pipeline; the last of a name counts.
std::vector<std::string> settings(const SavedSweep& sweep, bool of_scene) {
  std::map<std::string, plan::Value> last;
  for (const script::Setting& set : sweep.shot.sets)
    if (lab::isOfScene(set) == of_scene && !isSwept(sweep, set.first)) last[set.first] = set.second;
  std::vector<std::string> fields;
  for (const auto& [name, value] : last) fields.push_back(field(name, luaOf(value)));
  return fields;
}

std::string optionText(const lab::ShotOption& option, const lab::Shot& shot) {
  Json value = lab::jsonOf(option, shot);
  if (option.name != "move" && option.name != "spin") return luaOf(value);
  std::vector<std::string> nodes;
  for (const Json& one : value) nodes.push_back(motion(one.get<std::string>()));
  return tableOf(nodes);
}

std::string shotText(const SavedSweep& sweep) {
  std::vector<std::string> fields = {field("name", quoted(Path(sweep.shot.scene).stem().string())),
                                     field("scene", quoted(sweep.shot.scene))};
  for (const lab::ShotOption& option : lab::shotOptions()) {
    bool alike = lab::jsonOf(option, sweep.shot) == lab::jsonOf(option, sweep.suggested);
    bool elsewhere = option.name == "scene" || option.name == "size" || option.is(lab::ShotOption::kNoPicture);
    if (!alike && !elsewhere && !isSwept(sweep, option.name))
      fields.push_back(field(option.name, optionText(option, sweep.shot)));
  }
  for (const std::string& set : settings(sweep, true)) fields.push_back(set);
  return tableOf(fields);
}

std::string armText(const SavedSweep& sweep) {
  std::vector<std::string> fields = {field("name", quoted(Path(sweep.shot.pipeline).stem().string())),
                                     field("pipeline", quoted(sweep.shot.pipeline))};
  std::vector<std::string> sets = settings(sweep, false);
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

// "a", "a and b".
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
  std::string text = "-- A sweep in the window, saved. One of its pictures:\n-- " + lab::commandOf(sweep.shot) +
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
