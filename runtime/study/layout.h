// SPDX-License-Identifier: MIT
// Layout of an experiment's report: pictures, curves, tables. Read from the checked `layout` of the experiment
// file.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/json_fwd.h"

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

std::optional<PicturesLayout> picturesLayoutOf(const Json& layout);
std::optional<CurvesLayout> curvesOf(const Json& layout);
std::optional<FrontLayout> frontOf(const Json& layout);
// An empty layout gives a table of all points.
std::optional<TableLayout> tableOf(const Json& layout);

}  // namespace strobe::study
