// SPDX-License-Identifier: MIT
// What an experiment of extremes measured. Page, tables and text are made of this alone, so that a report on disk
// (`toJson`) says all that its page says.
#pragma once

#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "base/json.h"

namespace strobe::stability::curves {

inline const std::array<std::string, 4> kRegions = {"whole", "inner", "hidden", "outer"};
using PerRegion = std::array<double, 4>;  // NaN: the region has no pixels

// A picture against truth.
struct Measured {
  PerRegion rmse{};                 // linear values; of a floor with truth's own variance in it
  std::vector<std::string> limits;  // that were met: "NODE: COUNT WHAT"
  uint64_t broken = 0;              // values that are no finite number
  std::string command;              // makes the picture again
};

struct ReportPoint {
  double value = 0;
  std::string label;
  std::array<uint64_t, 4> pixels{};
  PerRegion sigma{};  // truth's standard error
  // Truth here against truth at the benign value: the largest difference, and the share of pixels that differ by more
  // than 1e-5.
  double drift = 0, drifted = 0;
  std::string command;  // of truth
  Measured floor;
  std::vector<Measured> methods;
};

struct ReportAxis {
  std::string name, title, unit, scale, region, fixed, note, reading;
  double benign = 0;
  bool same_picture = false;
  double contrast = 0;  // standard deviation of truth at the benign value, over the picture and its channels
  std::vector<ReportPoint> points;

  size_t benignIndex() const;
  size_t regionIndex() const;
  // Errors in the axis' own region, as a share of the contrast.
  double error(size_t method, size_t point) const;
  double floor(size_t point) const;
  double sigma(size_t point) const;
};

// One value of a variant with one method.
struct VariantRow {
  std::string method, value;
  double mib = 0;               // of all images a frame holds at once
  double ms = 0, least_ms = 0;  // median and least of frames drawn in turn with the other values
  std::vector<double> errors;   // by case: root mean square against truth, of the picture's contrast
  std::vector<double> changes;  // largest difference from the reference value's picture
  std::vector<std::vector<std::string>> limits;
};

struct ReportVariant {
  std::string name, title, reference, reading;
  std::vector<VariantRow> rows;
};

struct Report {
  std::string strobe, title, note, command;
  std::string device, driver;
  bool software = false;
  int width = 0, height = 0;
  double factor = 2;
  std::string truth, floor;  // labels
  std::vector<std::string> methods;
  std::vector<ReportAxis> axes;
  std::vector<std::string> cases;  // of the variants
  std::vector<ReportVariant> variants;
};

// Why a method is not to be trusted at a point.
enum class Doubt { none, error, limit, broken };

// What an error is held against: `factor` times the floor; or that or `factor` times the method's own at the benign
// value, whichever is larger. Three standard errors of truth are always allowed.
enum class Measure { floor, own };
Doubt doubtOf(const Report& report, const ReportAxis& axis, size_t method, size_t point, Measure measure);

// The points about the benign one at which a method is trusted; empty where it is not trusted there.
struct Trusted {
  size_t first = 0, count = 0;
  Doubt below = Doubt::none, above = Doubt::none;  // what ends it on either side

  bool holds(size_t point) const { return point >= first && point < first + count; }
};
Trusted trustedOf(const Report& report, const ReportAxis& axis, size_t method, Measure measure);

// Numbers with six significant digits: enough to copy, and the same on a rerun.
Json toJson(const Report& report);
// Throws `Error` naming the file for what is no report.
Report reportFrom(const Json& json, const std::string& file);

}  // namespace strobe::stability::curves
