// SPDX-License-Identifier: MIT
// The pictures of a shot as its results name them, read back from disk, and what is said of them.
#pragma once

#include "study/layout.h"
#include "study/results.h"

namespace strobe::study {

struct ShownPoint {
  const Point* point = nullptr;
  const ArmSummary* arm = nullptr;
  image::Image measured, shown;  // linear

  bool isTruth() const { return point->role == Role::truth; }
};

// The arms of a shot that are shown, in the order of the results' arms (truth last), at the shot's first point.
struct Gallery {
  const ShotSummary* shot = nullptr;
  const PointGroup* group = nullptr;
  std::vector<ShownPoint> shown;

  const ShownPoint& truth() const;
  // |difference from truth| times `gain`, in linear values, to be shown as it is. Pixels that are not finite are
  // marked.
  image::Image difference(const ShownPoint& point, double gain) const;
};

// Groups of a shot, the first of them first.
std::vector<const PointGroup*> groupsOf(const Results& results, const ShotSummary& shot);

// Pictures that are not below `folder` as they were written are left out. Pixels of `shown` that are not finite are
// marked as in the window.
Gallery galleryOf(const Results& results, const ShotSummary& shot, const Path& folder);

// "time, ms"
std::string headOf(const Measure& measure);
// A value of a measure with its unit.
std::string shownValue(const Measure& measure, double value);

// `shown`, or the reason for a missing value: "failed", "2 px not finite".
std::string orLack(const std::string& shown, double value, const PointGroup& group, const Point& point);

// What was taken how: size, exposure, anchor, motion.
std::string describeShot(const Results& results, const ShotSummary& shot);
// Contrast of the background; "" where it was not measured.
std::string describeBackground(const PointGroup& group);
// The device, and whether milliseconds are a GPU's.
std::string describeDevice(const Results& results);

}  // namespace strobe::study
