// SPDX-License-Identifier: MIT
// What an experiment gave, as a value that goes to JSON and back. Reports are made of it alone and of the pictures it
// names, so that a report on disk can be laid out again.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "base/files.h"
#include "base/json.h"
#include "image/draw.h"
#include "image/tone.h"
#include "study/measures.h"

namespace strobe::study {

// Milliseconds of one pass in the frames that were timed: median and quartiles over the rounds.
struct PassTime {
  std::string pass;  // name of its node
  double ms = 0, low = 0, high = 0;
};

// One arm at the values of a group.
struct Point {
  std::string key;  // content of all that makes it but its times, by which its files are named; "": it cannot be drawn
  std::string arm;
  Role role = Role::method;
  Values values;
  std::vector<PassTime> passes;     // in the order of execution; empty: it was not timed
  std::vector<std::string> limits;  // that were met: "NODE: COUNT WHAT"
  std::string command;              // makes the picture again
  std::string image;                // hash of its color
  std::string preset;               // of its pipeline; "": it has none
  std::string failed;               // why it could not be drawn; "": it was
  // Beside the results, "" where none was written: linear colour as measured and as shown (OpenEXR), and for people.
  std::string measured, shown, picture, record;
  std::map<std::string, std::string> files;  // hashes of all files written for it, by name below the results' folder
  std::string times;                         // what decides its times: rounds, and what they are ratios to

  bool isMissing() const { return values.empty() && failed.empty(); }  // not drawn yet
  // "failed", "not drawn", "2 px not finite": why values are missing that the point should have; "": none are.
  std::string lack() const;
  // NaN where it was not measured. `region` has no meaning for what is not per region.
  double value(const std::string& measure, const std::string& region = "whole") const;
};

// All points that share a truth, which is the first of them.
struct PointGroup {
  std::string shot, anchor;
  std::vector<std::pair<std::string, Json>> at;  // value of each axis
  std::vector<Point> points;

  const Point& truth() const { return points.front(); }
  // `Point::lack`, of truth where that is the reason; `point` is one of the group.
  std::string lackOf(const Point& point) const;
  const Point* floor() const;  // nullptr: there is none
  const Point* find(const std::string& arm) const;
};

struct ArmSummary {
  std::string name, pipeline;
  Role role = Role::method;
  bool shown = true;
};

struct ShotSummary {
  std::string name, title, note, attribution;
  std::string missing;  // why it was not rendered; "": it was
  double fps = 0, exposure = 0;
  std::vector<image::Rectangle> crops;
  image::ToneMap tone;
};

struct AxisSummary {
  std::string name, title, unit, scale, region, fixed, note, reading;
  bool same_picture = false;
  std::optional<size_t> benign;
  std::vector<Json> values;
  std::vector<std::string> labels;  // the values as Lua writes them

  bool hasCurves() const { return !region.empty() && !scale.empty() && benign.has_value(); }
};

struct Expectation {
  std::string text, shot, axis;
  std::string outcome;  // "holds", "fails", "does not apply"
  std::string detail;
  std::string known;  // why it is known to fail; "": it is not

  // Not what the experiment says: it fails and is not known to, or holds although it is.
  bool contradicts() const { return outcome == (known.empty() ? "fails" : "holds"); }
};

struct Results {
  std::string strobe, title, question, note, command;
  std::string device, driver;
  bool software = false;
  bool partial = false;  // not all points were asked for
  int width = 0, height = 0;
  std::vector<std::string> regions, measures;  // as the experiment asks for them
  std::vector<ArmSummary> arms;                // truth last
  std::vector<ShotSummary> shots;
  std::vector<AxisSummary> axes;
  Json layout;
  std::vector<PointGroup> groups;
  std::vector<Expectation> expectations;
  Inputs inputs;  // files that the points depend on; empty: not recorded

  const ArmSummary& arm(const std::string& name) const;
  const ShotSummary& shot(const std::string& name) const;
  std::vector<std::string> contradicted() const;  // expectations, in words
  std::vector<std::string> failed() const;        // points, with their reasons
  size_t missing() const;                         // points that are not drawn yet: the sweep was interrupted
  std::string missingText() const;                // "3 of 8 points, 1 of 2 truths" that are not drawn yet; "": none
};

Json toJson(const Point& point);
Point pointFrom(const Json& json, const std::string& file);  // throws `Error` naming the file

// What is said of a point that failed.
std::string describe(const PointGroup& group, const Point& point);

// "samples 4, tile 10": the values of a group, without those of one axis.
std::string describe(const PointGroup& group, const std::string& without = "");

// Numbers with nine significant digits: as exact as the pictures, and the same on a rerun.
Json toJson(const Results& results);
// Throws `Error` naming the file if it is not a result of an experiment, or has names or numbers that cannot be laid
// out.
Results resultsFrom(const Json& json, const std::string& file);

// Results as a file, with the sum by which damage is noticed; the same from a file, with or without sum.
std::string textOf(const Results& results);
Results resultsIn(const Path& file);

// Everything that is known before a picture is drawn: texts, arms, shots, axes, layout.
Results outlineOf(const Experiment& experiment);

// Puts what becomes of the expectations of `file` into its results.
void judgeResults(const Home& home, Results& results, const std::string& file);

// Puts the experiment's texts and layout over those of its results, and judges its expectations.
void retell(const Home& home, Results& results, const Experiment& experiment);

// A row per point and region: point, arm, shot, region, each axis, each measure, truth_error (standard error of truth's
// RMSE in the region), pipeline, preset; if a point lacks values it should have, also `note`, which says why. All after
// the axes is empty for a point that is not drawn yet.
std::string csvOf(const Results& results);
// A row per point that was timed and pass: point, arm, shot, pass, each axis, ms, ms_low, ms_high; "" without times.
std::string passesCsvOf(const Results& results);

}  // namespace strobe::study
