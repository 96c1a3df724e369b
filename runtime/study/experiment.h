// SPDX-License-Identifier: MIT
// Experiment file (docs/writing-experiments.md describes each field): shots, arms, axes, and the points that follow
// from them. This code does not depend on particular pipelines.
#pragma once

#include <map>
#include <optional>
#include <set>

#include "base/error.h"
#include "image/draw.h"
#include "image/tone.h"
#include "lab/batch.h"
#include "lab/shot_data.h"
#include "study/layout.h"

namespace strobe::study {

// Role of an arm: a method under test, the floor (ground truth with a method's sample count), or ground truth.
enum class ArmRole { method, floor, truth };
std::string nameOf(ArmRole role);

// Hashes (base/inputs.h) of the files that results depend on, by the names of the files in run records.
using Inputs = std::map<std::string, std::string>;
// Adds a file unless it is present. Ignores folders; a script may have read the names in a folder.
void addInput(Inputs& inputs, const Home& home, const Path& file);
// Replaces absolute paths by the names that `home` records. A sweep reads a copy of the home, and the copy has no names
// for files of the original.
void nameInputs(Inputs& inputs, const Home& home);

// Source lines of an entry of the experiment, and of its settings by name.
struct Written {
  Place place;
  std::map<std::string, Place> settings;
};

// Published frame rate of an arm in a shot.
struct Published {
  double fps = 0;
  std::string shot, by;  // `by`: authors of the measurement
};

// Part of an arm that results keep; a file of results does not have the settings.
struct ArmSummary : lab::Arm {
  ArmRole role = ArmRole::method;
  bool shown = true;  // on sheet and page; tables have every arm
};

// Arm of an experiment: a pipeline with its settings, the axes that do not apply to it, and its place in the file.
struct StudiedArm : ArmSummary {
  script::Settings box;            // added to `sets` for a picture with several samples per pixel
  std::vector<std::string> lacks;  // axes, or parameters set by axes, that do not apply to the arm
  std::optional<bool> timed;       // times are measured; empty: true for all pipelines except truth
  std::optional<Published> published;
  Written written;
};

// Crop in pixels at the size in the file; empty: the densest part of the region inner.
using Crop = std::optional<image::Rectangle>;

// Part of a shot that results keep.
struct ShotSummary {
  std::string name, title, note, attribution;
  std::string missing;           // reason why the shot cannot be rendered here; "": none
  double fps = 0, exposure = 0;  // of drawn frames
  std::vector<image::Rectangle> crops;
  image::ToneMap tone;
};

// Shot of an experiment: scene, frames, crops, tone mapping, and settings of its ground truth.
struct StudiedShot : ShotSummary {
  lab::Shot shot;          // without pipeline and settings of the pipeline
  script::Settings truth;  // added to the settings of truth
  std::vector<Crop> wanted_crops;
  std::vector<int> frames;  // frames of a sequence, in order; empty: the frame of `shot`
  int picture_aa = 1;       // samples per pixel of shown pictures; measured pictures have one
  std::string shared;       // scene file in the shared data; "": not in the shared data
  Written written;
};

// Settings of one value of an axis.
struct AxisValue {
  Json options = Json::array();  // options of the shot: { name, value }
  script::Settings scene;        // parameters of the scene, named "scene.NAME"
  script::Settings sets;         // parameters of every arm that does not lack them
  script::Settings truth;
  Written written;  // settings only
};

// Expected growth of the time of a part of a frame along an axis (strobe bench slopes).
struct Cost {
  std::string part, arm;  // arm "": every arm
  std::string grows, why;
};

// Part of an axis that results keep.
struct AxisSummary {
  std::string name, title, unit, scale, region, fixed, note, reading;
  bool same_picture = false;     // the exact picture does not depend on the value
  std::optional<size_t> benign;  // index of the reference value, where the quantity causes no error
  std::vector<Json> values;
  std::vector<std::string> labels;  // the values in Lua syntax

  bool hasCurves() const { return !region.empty() && !scale.empty() && benign.has_value(); }
};

// Variable of an experiment: its values, with the settings of each, and the expected growth of times along it.
struct Axis : AxisSummary {
  std::string against;  // measure on the x axis of times; "": the values
  std::vector<Cost> costs;
  std::vector<AxisValue> settings;  // by value
};

// Value of an axis, both as indices.
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

// Arm and outputs that provide the background, and the arm that renders the foreground.
struct Background {
  std::string arm, color, valid, front;
};

// Part `index` of `of` parts, from 1.
struct Share {
  size_t index = 1, of = 1;
  bool isWhole() const { return of == 1; }
  std::string text() const { return isWhole() ? "" : fmt::format("{}/{}", index, of); }
};

// Part of an experiment that results keep.
struct ExperimentSummary {
  std::string title, question, note;
  bool partial = false;                        // only some points of the file
  int width = 0, height = 0;                   // size of the pictures
  std::vector<std::string> regions, measures;  // as the experiment requests them
  ReportLayout layout;
  Inputs inputs;  // scripts that define the experiment; in results, all files that points depend on
};

// Experiment as a value: shots, arms, ground truth, axes, and the groups of points to render and measure.
struct Experiment : ExperimentSummary {
  std::string file;
  int file_width = 960, file_height = 540;  // size in the file; crops are in its pixels
  std::vector<std::string> size_params;     // scene parameters for width and height
  std::vector<StudiedShot> shots;
  std::vector<StudiedArm> arms;
  StudiedArm truth;
  double truth_error = 0;                      // upper bound of truth's standard error, met by more samples; 0: none
  std::optional<script::Settings> full_truth;  // settings of a second truth (measure rmse_full)
  std::vector<Axis> axes;
  std::vector<Group> groups;  // in the order of their points
  lab::Rounds rounds;         // rounds of timed frames
  bool is_step = false;       // search step: points of a shot are timed in the same rounds; the caller reports progress
  Share share;                // part of the points that this program draws
  std::string base;           // base arm of time ratios; "": the first timed arm
  std::optional<Background> background;
  size_t expectations = 0;

  size_t points() const;
  size_t truths() const;  // distinct; values of an axis that do not affect truth share one truth
};

// Names of arms, shots, axes or measures.
template <class Named>
std::vector<std::string> namesOf(const std::vector<Named>& all) {
  std::vector<std::string> names;
  for (const Named& one : all) names.push_back(one.name);
  return names;
}

// Number of truths with different contents, by the commands that draw them. "": cannot be drawn. A key of a point of
// truth also has the measures.
size_t countTruths(const std::set<std::string>& commands);

// Share of each group, from 1 to `of`: groups with the same truth are in one share, and shares have about equal numbers
// of points. Depends on the experiment only, not on the device.
std::vector<size_t> sharesOf(const Experiment& experiment, size_t of);

// Reads an experiment file, or a capture file with `measures`. Checks it without a device, and with `evaluate` also
// pipelines, settings and scenes. A scene "shared:FILE" is read from the shared data; if the scene is missing, the
// shot's `missing` has the reason. Throws one `Error` with all mistakes.
Experiment readExperiment(const Home& home, const std::string& file, bool evaluate = true);

// Outcomes of the expectations of `file` for finished results as JSON: a list of { text, outcome, detail, shot, axis }.
Json judge(const Home& home, const std::string& file, const Json& results);

// Shot of an arm, and of truth, at a group's point (`more`: additional settings).
lab::Shot shotOf(const Experiment& experiment, const Group& group, const StudiedArm& arm);
lab::Shot truthShotOf(const Experiment& experiment, const Group& group, const script::Settings& more = {});

// One shot per frame of the studied shot's sequence, or `shot` alone. Nodes that a shot moves are at rest at the first
// frame.
std::vector<lab::Shot> sequenceOf(const StudiedShot& studied, const lab::Shot& shot);

// Command that renders a picture of a studied shot; shared data is at $STROBE_DATA.
std::string commandOf(const StudiedShot& studied, const lab::Shot& shot);

// All settings; later settings take precedence.
script::Settings joined(script::Settings base, const script::Settings& more);

}  // namespace strobe::study
