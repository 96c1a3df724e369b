// SPDX-License-Identifier: MIT
// What a demo file asks for: shots of scenes, columns of pipelines, regions and measures (scripts/strobe/demo.lua says
// what each field means). Which pipelines these are is no business of this code; one column is the truth.
#pragma once

#include <optional>
#include <set>

#include "image/draw.h"
#include "image/tone.h"
#include "lab/shot.h"

namespace strobe::lab {

struct DemoColumn {
  std::string label, pipeline;
  script::Settings sets;
  script::Settings warm;  // on top of `sets` for the run before the one that is timed
  script::Settings box;   // on top of `sets` for a picture of several samples per pixel
  enum class Role { method, truth, floor } role = Role::method;
  std::string own_anchor;  // measured against truth of this anchor as well; "": no
  bool shown = true;       // on sheet and page; the tables have every column
};

// A crop in pixels at the demo's size, or the densest part of the inner blur.
using DemoCrop = std::optional<image::Rectangle>;

struct DemoShot {
  std::string title, note, attribution;
  Shot shot;                                     // everything but pipeline and its settings
  script::Settings truth;                        // on top of the settings of the truth column
  std::optional<script::Settings> full_shading;  // as above, for truth printed beside
  std::vector<DemoCrop> crops;
  image::ToneMap tone;
  std::string missing;  // why it cannot be rendered here; "": it can
};

// Names of columns and of two of a column's outputs: what lies behind, and where that is known.
struct DemoBackground {
  std::string column, color, valid, front;
};

// "column has in region at most share of each baseline's RMSE, and at most floor times the sampling floor's, wherever
// the background's deviation is at least contrast of its mean difference from what is in front"
struct DemoExpectation {
  std::string column, region;
  std::vector<std::string> baselines;
  double share = 0, floor = 0, contrast = 0;
};

struct Demo {
  std::string title, note;
  int width = 960, height = 540;
  uint32_t seed = 0;
  std::vector<DemoShot> shots;
  std::vector<DemoColumn> columns;
  std::vector<std::string> regions;  // of "whole" and the names of the truth's masks
  std::set<std::string> measures;
  double difference_gain = 4;
  int crop_width = 120, crop_height = 68;
  std::optional<DemoBackground> background;
  std::optional<DemoExpectation> expectation;
  std::vector<script::Dependency> dependencies;

  const DemoColumn& truth() const;
};

// Evaluates the file and checks what can be checked without a device: pipelines, settings, scenes, sizes. A scene
// "shared:FILE" is looked for in the shared data; where it is missing the shot says so. Throws `Error`.
Demo readDemo(const Home& home, const std::string& file);

// The settings `from` has by this name, as strobe.demo lists them: { { name, value }, ... } or nothing.
script::Settings settingsOf(const Json& from, const char* name);

// As much of `label` as makes a good file name: "UE4-style" becomes "ue4_style".
std::string fileNameOf(const std::string& label);

// All settings, the later on top.
script::Settings joined(script::Settings base, const script::Settings& more);

}  // namespace strobe::lab
