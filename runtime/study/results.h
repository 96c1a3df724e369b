// SPDX-License-Identifier: MIT
// Results of an experiment as a value, with conversion to JSON and back. Reports are made only from results and the
// pictures that they name, so that a report can be made again from disk.
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
  std::string pass;  // name of the node
  double ms = 0, low = 0, high = 0;
};

// Result of one arm at the values of a group.
struct Point {
  std::string key;  // hash of all that determines the values, except times; names the files; "": cannot be drawn
  std::string arm;
  ArmRole role = ArmRole::method;
  Values values;
  std::vector<PassTime> passes;     // in the order of execution; empty: not timed
  std::vector<std::string> limits;  // limits that the picture met: "NODE: COUNT WHAT"
  std::string command;              // draws the picture again
  std::string image;                // hash of the output `color`
  std::string preset;               // preset of the pipeline; "": no preset
  std::string failed;               // reason of a failure; "": no failure. With values, only the times failed
  // Files beside the results, "" if not written: linear colour as measured and as shown (OpenEXR), display picture,
  // record.
  std::string measured, shown, picture, record;
  std::map<std::string, std::string> files;  // hashes of all files of the point, by name below the results' folder
  std::string times;                         // conditions of the times: rounds, and the base of ratios
  std::string device, driver;                // of the picture and the times; "": the device of the results
  std::vector<std::string> tries;            // reasons of failed tries, only in the point's own file
  // Only of a truth, and only in its own file, because results have these once per shot: the crops of the shot, and the
  // author of its scene.
  std::vector<image::Rectangle> crops;
  std::string attribution;

  bool isDrawn() const { return !values.empty(); }                     // drawn and measured, perhaps without times
  bool isMissing() const { return values.empty() && failed.empty(); }  // not drawn yet
  // Reason for missing values: "failed", "not drawn", "2 px not finite"; "" if no values are missing.
  std::string lack() const;
  // NaN if not measured. `region` is ignored for a measure that is not per region.
  double value(const std::string& measure, const std::string& region = "whole") const;
};

// Points that share a truth; truth is the first point.
struct PointGroup {
  std::string shot, anchor;
  std::vector<std::pair<std::string, Json>> at;  // value of each axis
  std::vector<Point> points;

  const Point& truth() const { return points.front(); }
  // `Point::lack` of a point of the group, or of truth if only truth lacks values: "truth: failed".
  std::string lackOf(const Point& point) const;
  const Json* valueOn(const std::string& axis) const;  // nullptr if the group is not on the axis
  const Point* floor() const;                          // nullptr without a floor
  const Point* find(const std::string& arm) const;
};

// Expected outcome in an experiment, its test on the results (holds, fails, does not apply), and the reason of a
// known failure.
struct Expectation {
  std::string text, shot, axis;
  std::string outcome;  // "holds", "fails", "does not apply"
  std::string detail;
  std::string known;  // reason of a known failure; "": not known to fail

  // True if the expectation fails without a known reason, or holds although a failure is known.
  bool contradicts() const { return outcome == (known.empty() ? "fails" : "holds"); }
};

// Results of an experiment: device, arms, shots, axes, measured points by group, and tested expectations.
struct Results : ExperimentSummary {
  std::string strobe, command;
  std::string device, driver;
  bool software = false;
  std::vector<ArmSummary> arms;  // truth last
  std::vector<ShotSummary> shots;
  std::vector<AxisSummary> axes;
  std::vector<PointGroup> groups;
  std::vector<Expectation> expectations;

  const ArmSummary& arm(const std::string& name) const;
  const ShotSummary& shot(const std::string& name) const;
  std::vector<std::string> contradicted() const;  // expectations, in words
  std::vector<std::string> failed() const;        // points, with their reasons
  size_t points() const;                          // number of points without truths
  size_t missing() const;                         // number of these that are not drawn yet
  size_t truths(bool missing = false) const;      // number of distinct truths; `missing`: only those not drawn yet
  std::string missingText() const;                // not drawn yet: "3 of 8 points, 1 of 2 truths"; "": none

  // Device and driver of a point: "NAME, DRIVER".
  std::string deviceOf(const Point& point) const;
  // Devices of the points with times, in the order of the points. Times of two devices are not comparable.
  std::vector<std::string> timedDevices() const;
  // Results of the points of one device, with their truths and without expectations.
  Results onDevice(const std::string& device) const;
};

// Number with nine significant digits; null if not finite.
Json numberJson(double value);

// Sets the text fields from JSON; a missing field becomes "".
void takeTexts(const Json& json, AxisSummary& axis);
void takeTexts(const Json& json, ShotSummary& shot);

Json toJson(const std::vector<image::Rectangle>& crops);
std::vector<image::Rectangle> cropsFrom(const Json& json);

Json toJson(const Point& point);
Point pointFrom(const Json& json, const std::string& file);  // throws `Error` naming the file

// `text` after a comma; "" for "".
std::string afterComma(const std::string& text);

// Text for a failed point: shot, values, arm and reason.
std::string describe(const PointGroup& group, const Point& point);

// Values of a group, except of the axis `without`: "samples 4, tile 10".
std::string describe(const PointGroup& group, const std::string& without = "");

// Numbers have nine significant digits: as exact as the pictures, and equal on a rerun.
Json toJson(const Results& results);
// Throws `Error` naming the file if the JSON is not a result of an experiment, or has names or numbers that no report
// can use.
Results resultsFrom(const Json& json, const std::string& file);

// Text of a results file, with a checksum that detects damage. `resultsIn` reads files with and without checksum.
std::string textOf(const Results& results);
Results resultsIn(const Path& file);

// Results before a picture is drawn: texts, arms, shots, axes, layout.
Results outlineOf(const Experiment& experiment);

// Evaluates the expectations of `file` and stores the outcomes in the results.
void judgeResults(const Home& home, Results& results, const std::string& file);

// Replaces texts and layout of the results by the texts and layout of the experiment, and evaluates its expectations.
void relabel(const Home& home, Results& results, const Experiment& experiment);

// One row per point and region: point, arm, shot, region, each axis, each measure, truth_error (standard error of
// truth's RMSE in the region), pipeline, preset. If times come from several devices, also `device`. If values are
// missing, also `note` with the reason. Fields after the axes are empty for a point that is not drawn yet.
std::string csvOf(const Results& results);
// One row per timed point and pass: point, arm, shot, pass, each axis, ms, ms_low, ms_high, and `device`
// if there are several; "" without times.
std::string passesCsvOf(const Results& results);

}  // namespace strobe::study
