// SPDX-License-Identifier: MIT
// Pictures of a shot, read from the files that its results name, and texts for these pictures.
#pragma once

#include "study/results.h"

namespace strobe::study {

// Rendered images of one arm in linear colour, as measured and as shown, with the arm and its measured point.
struct ShownPoint {
  const Point* point = nullptr;
  const ArmSummary* arm = nullptr;
  image::Image measured, shown;  // linear colour

  bool isTruth() const { return point->role == ArmRole::truth; }
};

// Shown arms of a shot at its first point, in the order of the results' arms (truth last).
struct Gallery {
  const ShotSummary* shot = nullptr;
  const PointGroup* group = nullptr;
  std::vector<ShownPoint> shown;

  const ShownPoint& truth() const;
  // |difference from truth| times `gain` in linear values, displayed without tone mapping. Pixels that are not finite
  // are marked.
  image::Image difference(const ShownPoint& point, double gain) const;
};

// Groups of a shot, in the order of the results.
std::vector<const PointGroup*> groupsOf(const Results& results, const ShotSummary& shot);

// Leaves out pictures that are missing in `folder` or differ from their hash. Pixels of `shown` that are not finite are
// marked as in the window.
Gallery galleryOf(const Results& results, const ShotSummary& shot, const Path& folder);

// Title with unit: "time, ms"; with the region, if the measure has a value per region: "RMSE, inner".
std::string headOf(const Measure& measure, const std::string& region = "");
// Value of a measure, formatted for its unit.
std::string shownValue(const Measure& measure, double value);

// `shown`, or the reason for a missing value: "failed", "2 px not finite".
std::string orLack(const std::string& shown, double value, const PointGroup& group, const Point& point);

// Point of a method, with two measures.
struct FrontPoint {
  const PointGroup* group;
  const Point* point;
  double x, y;
};
// Points of the methods in a shot with a finite `y`.
std::vector<FrontPoint> frontPoints(const Results& results, const ShotSummary& shot, const FrontLayout& layout);
// Their Pareto front, or the points with the best `y` if no point has a finite `x`.
std::vector<FrontPoint> frontOf(const std::vector<FrontPoint>& points, const FrontLayout& layout);

// Size, exposure, anchor and motion of a shot.
std::string describeShot(const Results& results, const ShotSummary& shot);
// Contrast of the background; "" if not measured.
std::string describeBackground(const PointGroup& group);
// Device, driver, and whether milliseconds are GPU times.
std::string describeDevice(const Results& results);

}  // namespace strobe::study
