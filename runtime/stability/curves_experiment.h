// SPDX-License-Identifier: MIT
// What an experiment of extremes asks for (scripts/strobe/extremes.lua says what each field means): methods, and axes
// along each of which one thing grows to an extreme. Which pipelines these are is no business of this code.
#pragma once

#include "lab/shot.h"
#include "stability/curves_report.h"

namespace strobe::stability::curves {

// What one value of an axis sets.
struct AxisPoint {
  double value = 0;
  std::string label;          // the value as Lua writes it
  script::Settings scene;     // parameters of the scene, as "scene.NAME"
  script::Settings pipeline;  // of every pipeline that does not lack them
  script::Settings truth, floor;
  script::Settings shot;  // options of the shot by name
};

struct Axis {
  std::string name, title, unit, scale, region, scene, fixed, note, reading;
  double benign = 0;
  bool same_picture = false;
  std::vector<AxisPoint> points;

  size_t benignIndex() const;
};

struct Method {
  std::string label, pipeline;
  script::Settings sets;
  std::vector<std::string> lacks;
};

bool lacks(const Method& method, const std::string& setting);

// A choice parameter whose values are compared.
struct Variant {
  std::string name, title, reference, reading;
  std::vector<std::string> values;
};

// A scene in which they are.
struct Case {
  std::string label, scene;
  script::Settings sets;  // as "scene.NAME"
};

struct Experiment {
  std::string title, note;
  int width = 320, height = 180;
  std::vector<std::string> size_params;  // of the scenes: width, height
  double factor = 2;
  Method truth, floor;
  std::vector<Method> methods;
  std::vector<Axis> axes;
  std::vector<Variant> variants;
  std::vector<Case> cases;

  // Of the axes, and "variants". Throws `Error` (exit code 2) with the nearest name.
  void keepOnly(const std::string& axis);
  // Of truth, on every axis.
  void setTruthSamples(int samples);
};

// Evaluates the file and checks what can be checked without a device: pipelines, settings, scenes. Throws `Error`.
Experiment readExperiment(const Home& home, const std::string& file);

// The picture of a method (or truth or floor) at a point.
lab::Shot shotOf(const Experiment& experiment, const Axis& axis, const AxisPoint& point, const Method& method);

// The same in a case, with `name` set to `value` unless it is "".
lab::Shot shotOf(const Experiment& experiment, const Case& in, const Method& method, const std::string& name = "",
                 const std::string& value = "");

// Puts the experiment's texts over those of a report of it.
void retell(Report& report, const Experiment& experiment);

}  // namespace strobe::stability::curves
