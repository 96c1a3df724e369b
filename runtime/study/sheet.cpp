// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "base/lists.h"
#include "figure/figure.h"
#include "page/number.h"
#include "study/report.h"

namespace strobe::study {

using figure::FigureCell;
using image::Colour;
using page::shownError;

namespace {

const std::vector<Colour> kCropColours = {{1.0f, 0.76f, 0.03f}, {0.1f, 0.75f, 0.95f}, {0.95f, 0.3f, 0.75f}};

// Versions of a picture: as shown, as measured.
enum SheetVersion { kShown, kMeasured };

std::string numbersOf(const Results& results, const Point& point) {
  std::vector<std::string> parts;
  if (point.role == ArmRole::truth) {
    for (const std::string& region : results.regions)
      parts.push_back(fmt::format("{} {}", region, shownError(point.value("rmse", region))));
    return fmt::format("its standard error: {}", fmt::join(parts, ", "));
  }
  for (const std::string region : {"inner", "whole"})
    if (contains(results.regions, region))
      parts.push_back(fmt::format("RMSE {} {}", region, shownError(point.value("rmse", region))));
  if (double ms = point.value("ms"); !std::isnan(ms))
    parts.push_back(page::shownMs(ms) + (results.software ? " (software)" : ""));
  return fmt::format("{}", fmt::join(parts, ", "));
}

// Rows and cells of the figure, shot by shot.
class Sheet {
 public:
  explicit Sheet(const Results& results) : results_(results) {
    figure_.title = results.title, figure_.note = results.note;
    figure_.note += fmt::format("\nStrobe {} on {}", results.strobe, describeDevice(results));
    figure_.width = results.width, figure_.height = results.height;
    figure_.cell_width = 480, figure_.text_size = 24, figure_.gap = 10, figure_.margin = 28;
    for (const ArmSummary& arm : results.arms)
      if (arm.shown) figure_.columns.push_back(arm.name);
  }

  void add(const Gallery& gallery) {
    const ShotSummary& shot = *gallery.shot;
    std::string why = shot.missing.empty() ? "not drawn" : "skipped: " + shot.missing;
    if (gallery.shown.empty()) return addRow("", {shot.title, {{.text = why}}});
    std::string note = describeShot(results_, shot) + (shot.note.empty() ? "" : ". " + shot.note);
    addRow("", {shot.title, {{.text = note}}});
    addCells(gallery, [&](FigureCell& cell, const ShownPoint& one) {
      cell.caption = {{.text = numbersOf(results_, *one.point)}};
      frame(cell, shot);
    });
    for (size_t i = 0; i < shot.crops.size(); ++i) {
      const image::Rectangle& area = shot.crops[i];
      addRow(fmt::format("crop at {},{}", area.x, area.y), {});
      addCells(gallery, [&](FigureCell& cell, const ShownPoint&) {
        cell.crop = areaOf(area), cell.frame = kCropColours[i % kCropColours.size()];
      });
    }
    if (gallery.shown.size() == 1) return;  // truth only
    addRow("difference", {});
    addCells(gallery, [&](FigureCell& cell, const ShownPoint& one) {
      if (one.isTruth()) return figure_.cells.pop_back();
      cell.step = kMeasured, cell.against = gallery.truth().point->arm, cell.difference = "channels";
      cell.gain = results_.layout.pictures.value_or(PicturesLayout()).difference_gain;
      frame(cell, shot);
    });
  }

  const figure::FigureData& figure() const { return figure_; }

 private:
  static figure::Area areaOf(const image::Rectangle& area) {
    return {double(area.x), double(area.y), double(area.width), double(area.height), ""};
  }

  void addRow(const std::string& label, figure::RowHeading heading) {
    figure_.rows.push_back(label);
    figure_.headings.push_back(std::move(heading));
  }

  // Adds a cell for each picture to the last row; `complete` fills in the cell.
  template <class Complete>
  void addCells(const Gallery& gallery, const Complete& complete) {
    for (const ShownPoint& one : gallery.shown) {
      auto column = std::find(figure_.columns.begin(), figure_.columns.end(), one.point->arm);
      FigureCell& cell = figure_.cells.emplace_back();
      cell.row = int(figure_.rows.size()) - 1, cell.column = int(column - figure_.columns.begin());
      cell.shot = gallery.shot->name, cell.arm = one.point->arm, cell.kind = "colour", cell.step = kShown;
      complete(cell, one);
    }
  }

  static void frame(FigureCell& cell, const ShotSummary& shot) {
    for (size_t i = 0; i < shot.crops.size(); ++i) {
      figure::FigureMark& box = cell.marks.emplace_back();
      box.area = areaOf(shot.crops[i]), box.colour = kCropColours[i % kCropColours.size()], box.width = 2;
    }
  }

  const Results& results_;
  figure::FigureData figure_;
};

figure::Taken takenOf(const ShotSummary& shot, const ShownPoint& one, int step) {
  auto picture = std::make_shared<lab::Picture>();
  picture->frame.outputs["color"].floats = step == kShown ? one.shown : one.measured;
  if (!shot.attribution.empty()) picture->record["scene"]["attribution"]["copyright"] = shot.attribution;
  return {shot.name, one.point->arm, step, std::move(picture), shot.tone, {}, {}};
}

}  // namespace

image::Image sheetOf(const Results& results, const std::vector<Gallery>& galleries) {
  Sheet sheet(results);
  std::map<std::tuple<std::string, std::string, int>, figure::Taken> all;
  for (const Gallery& gallery : galleries) {
    sheet.add(gallery);
    for (const ShownPoint& one : gallery.shown)
      for (int step : {kShown, kMeasured})
        all[{gallery.shot->name, one.point->arm, step}] = takenOf(*gallery.shot, one, step);
  }
  auto find = [&](const std::string& shot, const std::string& arm, int step) -> const figure::Taken& {
    return all.at({shot, arm, step});
  };
  return figure::pixelsOf(figure::layoutOf(sheet.figure(), find, ""));
}

}  // namespace strobe::study
