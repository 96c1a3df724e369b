// SPDX-License-Identifier: MIT
#include "study/gallery.h"

#include <algorithm>
#include <cmath>

#include "image/exr.h"
#include "image/false_colour.h"
#include "math/statistics.h"
#include "page/number.h"
#include "study/store.h"

namespace strobe::study {

const ShownPoint& Gallery::truth() const {
  for (const ShownPoint& one : shown)
    if (one.isTruth()) return one;
  STROBE_ASSERT(false, "pictures without truth");
  std::abort();
}

image::Image Gallery::difference(const ShownPoint& point, double gain) const {
  image::Image difference = image::absoluteDifference(point.measured, truth().measured, float(gain));
  image::markNotFinite(difference, difference);
  return difference;
}

std::vector<const PointGroup*> groupsOf(const Results& results, const ShotSummary& shot) {
  std::vector<const PointGroup*> groups;
  for (const PointGroup& group : results.groups)
    if (group.shot == shot.name) groups.push_back(&group);
  return groups;
}

// Linear colour of an OpenEXR file.
static image::Image linearIn(const Path& file) { return image::colourOf(image::readExrLayer(file, ""), "", file); }

static std::optional<ShownPoint> shownPoint(const Point& point, const ArmSummary& arm, const Path& folder) {
  // Results without their picture files are laid out without pictures.
  const PointFiles files(folder);
  for (const std::string& name : {point.measured, point.shown})
    if (!checkedFile(point, files, name)) return std::nullopt;
  try {
    ShownPoint one{&point, &arm, linearIn(folder / point.measured), {}};
    one.shown = point.shown == point.measured ? one.measured : linearIn(folder / point.shown);
    image::markNotFinite(one.shown, one.shown);
    return one;
  } catch (const Error&) {  // damaged file of results without hashes
    return std::nullopt;
  }
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
    if (std::optional<ShownPoint> one = shownPoint(*point, arm, folder)) gallery.shown.push_back(std::move(*one));
  }
  auto truth =
      std::find_if(gallery.shown.begin(), gallery.shown.end(), [](const ShownPoint& one) { return one.isTruth(); });
  image::Image reference = truth == gallery.shown.end() ? image::Image() : truth->measured;
  std::erase_if(gallery.shown, [&](const ShownPoint& one) { return !image::sameSize(one.measured, reference); });
  return gallery;
}

std::string headOf(const Measure& measure, const std::string& region) {
  std::string head = measure.unit.empty() ? measure.title : measure.title + ", " + measure.unit;
  return region.empty() || !measure.per_region ? head : head + ", " + region;
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

std::string orLack(const std::string& shown, double value, const PointGroup& group, const Point& point) {
  std::string lack = std::isnan(value) ? group.lackOf(point) : "";
  return lack.empty() ? shown : lack;
}

std::vector<FrontPoint> frontPoints(const Results& results, const ShotSummary& shot, const FrontLayout& layout) {
  std::vector<FrontPoint> points;
  for (const PointGroup* group : groupsOf(results, shot))
    for (const Point& point : group->points) {
      double x = point.value(layout.x, layout.region), y = point.value(layout.y, layout.region);
      if (point.role == ArmRole::method && std::isfinite(y)) points.push_back({group, &point, x, y});
    }
  return points;
}

std::vector<FrontPoint> frontOf(const std::vector<FrontPoint>& points, const FrontLayout& layout) {
  auto cost = [](const std::string& measure, double value) {
    return measureNamed(measure).better == Better::higher ? -value : value;
  };
  bool has_x = std::any_of(points.begin(), points.end(), [](const FrontPoint& one) { return std::isfinite(one.x); });
  std::vector<std::pair<double, double>> costs;
  for (const FrontPoint& one : points) costs.emplace_back(has_x ? cost(layout.x, one.x) : 0, cost(layout.y, one.y));
  std::vector<FrontPoint> front;
  for (size_t i : paretoFront(costs)) front.push_back(points[i]);
  return front;
}

std::string describeShot(const Results& results, const ShotSummary& shot) {
  const PointGroup& group = *groupsOf(results, shot).front();
  std::string text = fmt::format("{}x{}, exposure {:g} of 1/{:g} s, anchor {}", results.width, results.height,
                                 shot.exposure, shot.fps, group.anchor);
  double displacement = group.truth().value("displacement");
  if (std::isnan(displacement)) return text;
  return text +
         fmt::format(", median displacement of moving pixels {} px over the exposure", page::shownPixels(displacement));
}

std::string describeBackground(const PointGroup& group) {
  for (const Point& point : group.points) {
    double pixels = point.value("background_pixels");
    if (!(pixels > 0)) continue;
    double deviation = point.value("background_deviation"), difference = point.value("background_difference");
    return fmt::format(
        "Background in the region inner ({:.0f} px): standard deviation {:.4f}, mean difference from the foreground "
        "{:.4f} (ratio {:.2f}; the higher the ratio, the larger the error of a blur that invents the background).",
        pixels, deviation, difference, deviation / difference);
  }
  return "";
}

std::string describeDevice(const Results& results) {
  std::string text = fmt::format("{}, {}", results.device, results.driver);
  return text + (results.software ? "; a software device: its milliseconds are not a GPU's" : "; clocks not locked");
}

}  // namespace strobe::study
