// SPDX-License-Identifier: MIT
// What an experiment file asks for (docs/writing-experiments.md says what each field means): shots, the arms that draw
// them, axes, and the points that follow. Which pipelines the arms are is no business of this code.
#pragma once

#include <map>
#include <optional>

#include "base/error.h"
#include "image/draw.h"
#include "image/tone.h"
#include "lab/batch.h"

namespace strobe::study {

enum class Role { method, floor, truth };
std::string nameOf(Role role);

// Files that results depend on: their hashes (base/inputs.h) by their names in run records.
using Inputs = std::map<std::string, std::string>;
// Adds a file that is not among them. Folders, of which a script read the names, are left out.
void addInput(Inputs& inputs, const Home& home, const Path& file);
// Renames inputs that are absolute paths to the names that `home` records. A sweep reads a copy of the home, which does
// not have names for files of the original.
void nameInputs(Inputs& inputs, const Home& home);

// Lines of the experiment: of an entry, and of the settings in it by name.
struct Written {
  Place place;
  std::map<std::string, Place> settings;
};

// What somebody else measured of an arm in a shot.
struct Published {
  double fps = 0;
  std::string shot, by;
};

struct Arm {
  std::string name, pipeline;
  Role role = Role::method;
  script::Settings sets;
  script::Settings box;            // on top of `sets` in a picture of several samples per pixel
  std::vector<std::string> lacks;  // axes, or parameters that they set, which are not given to it
  bool shown = true;               // on sheet and page; tables have every arm
  std::optional<bool> timed;       // where times are measured; without it every method is, and no truth
  std::optional<Published> published;
  Written written;
};

// A crop in pixels at the experiment's size, or the densest part of the inner blur.
using Crop = std::optional<image::Rectangle>;

struct StudiedShot {
  std::string name, title, note, attribution;
  lab::Shot shot;          // everything but pipeline and its settings
  script::Settings truth;  // on top of the settings of truth
  std::vector<Crop> crops;
  std::vector<int> frames;  // of a sequence, in their order; empty: the shot's own alone
  int picture_aa = 1;       // sub-pixel samples of what is shown; what is measured has one
  image::ToneMap tone;
  std::string shared;   // the scene's file in the shared data; "": it is none of it
  std::string missing;  // why it cannot be rendered here; "": it can
  Written written;
};

// What one value of an axis sets.
struct AxisValue {
  Json value;
  std::string label;             // the value as Lua writes it
  Json options = Json::array();  // of the shot: { name, value }
  script::Settings scene;        // parameters of the scene, as "scene.NAME"
  script::Settings sets;         // parameters of every arm that does not lack them
  script::Settings truth;
  Written written;  // settings alone
};

// How the time of a part of a frame is expected to grow along an axis (strobe bench slopes).
struct Cost {
  std::string part, arm;  // arm "": of each
  std::string grows, why;
};

struct Axis {
  std::string name, title, unit, scale, region, fixed, note, reading;
  std::string against;  // the measure that times are drawn against; "": the values
  std::vector<Cost> costs;
  std::optional<size_t> benign;  // the value at which nothing is extreme
  bool same_picture = false;     // what is seen does not depend on the value
  std::vector<AxisValue> values;
};

// A value of an axis, both by number.
struct At {
  size_t axis = 0, value = 0;
  bool operator==(const At&) const = default;
};

// Points that share one truth.
struct Group {
  size_t shot = 0;
  std::vector<At> at;
  std::vector<size_t> arms;
};

// Arm and outputs that provide the background, and the arm that shows the foreground.
struct Background {
  std::string arm, color, valid, front;
};

struct Experiment {
  std::string file, title, question, note;
  int width = 960, height = 540;            // as they are asked for now
  int file_width = 960, file_height = 540;  // as the file has them: crops follow
  std::vector<std::string> size_params;     // of the scenes: width, height
  std::vector<StudiedShot> shots;
  std::vector<Arm> arms;
  Arm truth;
  double truth_error = 0;                      // truth has more samples until its standard error is that; 0: as given
  std::optional<script::Settings> full_truth;  // settings of a second truth (measure rmse_full)
  std::vector<Axis> axes;
  std::vector<Group> groups;  // in the order of their points
  bool partial = false;       // not all points of the file are among them
  std::vector<std::string> regions, measures;
  lab::Rounds rounds;    // of frames that are timed
  bool is_step = false;  // of a search: a shot's points are timed in the same rounds, progress is left to the caller
  std::string base;      // the arm that times are ratios to; "": the first that is timed
  std::optional<Background> background;
  Json layout;
  size_t expectations = 0;
  Inputs inputs;  // scripts that it was read from

  void setSize(int width, int height);
  size_t points() const;
  // Distinct ones: values of an axis that set nothing of truth share one.
  size_t truths() const;
};

// An experiment's file, or that of a capture with `measures`, checked without a device; with `evaluate` pipelines,
// settings and scenes too. A scene "shared:FILE" is looked for in the shared data; where it is missing the shot says
// so. Throws `Error`, all mistakes at once.
Experiment readExperiment(const Home& home, const std::string& file, bool evaluate = true);

// What became of the expectations of `file`, given finished results as JSON: a list of { text, outcome, detail, shot,
// axis }.
Json judge(const Home& home, const std::string& file, const Json& results);

// The picture of an arm at a group's point, and of truth there (`more`: settings on top).
lab::Shot shotOf(const Experiment& experiment, const Group& group, const Arm& arm);
lab::Shot truthShotOf(const Experiment& experiment, const Group& group, const script::Settings& more = {});

// A picture at each frame of the studied shot's sequence, or the one. Nodes that a shot moves are at rest at the first.
std::vector<lab::Shot> sequenceOf(const StudiedShot& studied, const lab::Shot& shot);

// The command that makes a picture of a studied shot, with shared data by the variable that names its folder.
std::string commandOf(const StudiedShot& studied, const lab::Shot& shot);

// All settings, the later on top.
script::Settings joined(script::Settings base, const script::Settings& more);

}  // namespace strobe::study
