// SPDX-License-Identifier: MIT
// Layout of an experiment's report: pictures, curves, tables.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/json.h"

namespace strobe::study {

// Settings of the pictures in a report: crop size in pixels, and gain of the difference images.
struct PicturesLayout {
  int crop_width = 120, crop_height = 68;  // px at the experiment's size
  double difference_gain = 4;
};

// Curves of every axis with region, scale and benign value.
struct CurvesLayout {
  double factor = 2;
};

// One table per axis; without axes, one table of all points.
struct TableLayout {
  std::string title, note;
  std::vector<std::string> axes;
  std::vector<std::string> cells;  // measures of each shot, joined in one cell
  std::vector<std::string> once;   // measures of the axis' first shot
  bool share = false;              // errors as a share of the contrast of truth
};

// Measure y over measure x, with a mark for each method and value, in one chart per shot. `together`: one chart for all
// shots, with the line y = x in place of the Pareto front.
struct FrontLayout {
  std::string title, note;
  std::string x = "ms", y = "rmse", region = "whole";
  bool together = false;
};

// Layout of a report, with the parts that the experiment has. Without parts: a table of all points.
struct ReportLayout {
  std::optional<PicturesLayout> pictures;
  std::optional<CurvesLayout> curves;
  std::optional<FrontLayout> front;
  std::optional<TableLayout> table = TableLayout();
  Json json = Json::object();  // as written in the experiment file and in results
};

// Takes the value of a field, if there is such a field.
template <class Value>
void take(const Json& from, const char* name, Value& into) {
  if (from.contains(name)) into = from.at(name).get<Value>();
}

// Throws an exception of the JSON library for a field of another type.
ReportLayout layoutFrom(const Json& json);

}  // namespace strobe::study
