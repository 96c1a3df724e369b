// SPDX-License-Identifier: MIT
#include "study/gallery.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "image/comparison.h"
#include "image/false_colour.h"
#include "page/number.h"

namespace strobe::study {

const ShownPoint& Gallery::truth() const {
  for (const ShownPoint& one : shown)
    if (one.isTruth()) return one;
  STROBE_ASSERT(false, "pictures without truth");
  std::abort();
}

image::Image Gallery::difference(const ShownPoint& point, double gain) const {
  return image::absoluteDifference(point.measured, truth().measured, float(gain));
}

std::vector<const PointGroup*> groupsOf(const Results& results, const ShotSummary& shot) {
  std::vector<const PointGroup*> groups;
  for (const PointGroup& group : results.groups)
    if (group.shot == shot.name) groups.push_back(&group);
  return groups;
}

Gallery galleryOf(const Results& results, const ShotSummary& shot, const Path& folder) {
  Gallery gallery;
  gallery.shot = &shot;
  std::vector<const PointGroup*> groups = groupsOf(results, shot);
  if (groups.empty()) return gallery;
  gallery.group = groups.front();
  for (const ArmSummary& arm : results.arms) {
    const Point* point = gallery.group->find(arm.name);
    if (!point || !arm.shown || point->measured.empty()) continue;
    // Results that travel without their pictures are laid out without them.
    if (!std::filesystem::exists(folder / point->measured) || !std::filesystem::exists(folder / point->shown)) continue;
    ShownPoint one{point, &arm, image::readPicture(folder / point->measured).linear, {}};
    bool same = point->shown == point->measured;
    one.shown = same ? one.measured : image::readPicture(folder / point->shown).linear;
    gallery.shown.push_back(std::move(one));
  }
  bool has_truth = std::any_of(gallery.shown.begin(), gallery.shown.end(),
                               [](const ShownPoint& one) { return one.arm->role == Role::truth; });
  if (!has_truth) gallery.shown.clear();
  return gallery;
}

std::string headOf(const Measure& measure) {
  return measure.unit.empty() ? measure.title : measure.title + ", " + measure.unit;
}

std::string shownValue(const Measure& measure, double value) {
  if (std::isnan(value)) return page::kNotMeasured;
  if (measure.unit == "ms") return page::shownMs(value);
  if (measure.unit == "MiB") return fmt::format("{:.2f}", value);
  if (measure.unit == "B") return fmt::format("{:.1f}", value);
  if (value == std::floor(value) && std::abs(value) < 1e15) return fmt::format("{:.0f}", value);
  if (measure.unit == "px") return page::shownPixels(value);
  return measure.name.starts_with("change") ? fmt::format("{:.3g}", value) : page::shownError(value);
}

std::string describeShot(const Results& results, const ShotSummary& shot) {
  const PointGroup& group = *groupsOf(results, shot).front();
  std::string text = fmt::format("{}x{}, exposure {:g} of 1/{:g} s, anchor {}", results.width, results.height,
                                 shot.exposure, shot.fps, group.anchor);
  double displacement = group.truth().value("displacement");
  if (std::isnan(displacement)) return text;
  return text +
         fmt::format(", median displacement of what moves {} px over the exposure", page::shownPixels(displacement));
}

std::string describeBackground(const PointGroup& group) {
  for (const Point& point : group.points) {
    double pixels = point.value("background_pixels");
    if (!(pixels > 0)) continue;
    double deviation = point.value("background_deviation"), difference = point.value("background_difference");
    return fmt::format(
        "Background in the region inner ({:.0f} px): standard deviation {:.4f}, mean difference from the foreground "
        "{:.4f} (ratio {:.2f}; the higher the ratio, the more a blur that invents the background errs).",
        pixels, deviation, difference, deviation / difference);
  }
  return "";
}

std::string describeDevice(const Results& results) {
  std::string text = fmt::format("{}, {}", results.device, results.driver);
  return text + (results.software ? "; a software device: its milliseconds are not a GPU's" : "; clocks not locked");
}

}  // namespace strobe::study
