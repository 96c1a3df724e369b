// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "base/lists.h"
#include "image/draw.h"
#include "image/png.h"
#include "lab/shot_data.h"
#include "page/number.h"
#include "study/report.h"

namespace strobe::study {

namespace {

using image::Image;

page::TableCell cellOf(const Measure& measure, const PointGroup& group, const Point& point, const std::string& region) {
  double value = point.value(measure.name, region);
  return {value, orLack(measure.unit == "ms" ? page::shownMs(value) : page::shownError(value), value, group, point)};
}

// Name of a row. Floor and truth are not methods.
page::TableCell nameCell(const Point& point) {
  if (point.role == ArmRole::truth)
    return {point.arm + " ±", page::Emphasis::faint, "truth; its numbers are its own standard error"};
  if (point.role == ArmRole::floor)
    return {point.arm == "floor" ? "floor" : point.arm + " (floor)", page::Emphasis::faint,
            "sampling floor: truth at the sample times of a method"};
  return {point.arm};
}

// Column of a table: a measure in a region.
struct PictureColumn {
  const Measure* measure;
  std::string region, title;
};

std::vector<PictureColumn> columnsOf(const Results& results) {
  std::vector<PictureColumn> columns;
  for (const Measure& measure : measures()) {
    if (!contains(results.measures, measure.name) || !measure.per_region) continue;
    bool whole = measure.name == "rmse_full";  // one column only
    for (const std::string& region : whole ? std::vector<std::string>{"whole"} : results.regions)
      columns.push_back({&measure, region, whole ? "RMSE whole, full shading" : measure.title + " " + region});
  }
  if (contains(results.measures, std::string("ms")))
    columns.push_back({&measureNamed("ms"), "", results.software ? "time (software)" : "time"});
  return columns;
}

// Points of a group, in the order of the arms of the results.
std::vector<const Point*> rowsOf(const Results& results, const PointGroup& group) {
  std::vector<const Point*> rows;
  for (const ArmSummary& arm : results.arms)
    if (const Point* point = group.find(arm.name)) rows.push_back(point);
  return rows;
}

// Mark the smallest (or largest) value bold. Truth's noise shifts each RMSE by at most its own RMSE, `sigma` (triangle
// inequality), so errors that differ by more than 2 sigma are in the right order, and others are not ranked.
void rank(page::Table& table, size_t column, const PictureColumn& shown, const PointGroup& group) {
  if (!shown.measure->per_region || shown.measure->better == Better::neither) return;
  double sigma = shown.measure->name == "rmse" ? group.truth().value("rmse", shown.region) : 0;
  std::vector<page::TableCell*> cells;
  for (page::Row& row : table.rows)
    if (row[column].mark == page::Emphasis::none && std::isfinite(row[column].value)) cells.push_back(&row[column]);
  auto less = [](const page::TableCell* a, const page::TableCell* b) { return a->value < b->value; };
  std::sort(cells.begin(), cells.end(), less);
  auto near = [&](const page::TableCell* cell) { return cell->value < cells.front()->value + 2 * sigma; };
  auto end = std::partition_point(cells.begin(), cells.end(), near);
  bool alike = end == cells.begin() || (*(end - 1))->value == cells.front()->value;
  if (alike) return page::markBest(table, column, shown.measure->better == Better::higher);
  for (auto cell = cells.begin(); cell != end; ++cell) (*cell)->text += "?";
  if (table.notes.empty())
    table.notes.push_back(
        "?: errors that differ by less than two standard errors of truth; their order may be truth's noise.");
}

page::Table errorTable(const Results& results, const PointGroup& group) {
  page::Table table;
  std::vector<PictureColumn> columns = columnsOf(results);
  table.columns = {"method"};
  for (const PictureColumn& shown : columns) table.columns.push_back({shown.title, true});
  table.columns.push_back({"clamped px", true});
  for (const Point* point : rowsOf(results, group)) {
    page::Row row = {nameCell(*point)};
    page::Emphasis mark = point->role == ArmRole::method ? page::Emphasis::none : page::Emphasis::faint;
    for (const PictureColumn& shown : columns) {
      const bool of_itself = point->role == ArmRole::truth && shown.measure->per_region &&
                             !shown.measure->name.starts_with("rmse");  // RMSE of truth is its standard error
      row.push_back(of_itself ? page::TableCell("–") : cellOf(*shown.measure, group, *point, shown.region));
      row.back().mark = mark;
    }
    row.push_back(page::TableCell(page::shownCount(point->value("clamped")), mark));
    table.add(std::move(row));
  }
  for (size_t i = 0; i < columns.size(); ++i) rank(table, i + 1, columns[i], group);
  return table;
}

std::string regionsText(const Results& results, const PointGroup& group) {
  std::vector<std::string> parts;
  for (const std::string& region : results.regions)
    parts.push_back(fmt::format("{} {} px", region, page::shownCount(group.truth().value("pixels", region))));
  return fmt::format("anchor {}; {}", group.anchor, fmt::join(parts, ", "));
}

// `quality`: quality of a JPEG; 0: PNG.
page::PagePicture pictureOf(const std::string& caption, const Image& display, const std::string& name = "",
                            int quality = 0) {
  std::string file = quality > 0 ? image::encodeJpeg(display, quality) : image::encodePng(display);
  return {std::move(file), display.width, display.height, caption, "", name};
}

std::string armNameOf(const Gallery& gallery, const ShownPoint& one) {
  return lab::fileNameOf(gallery.shot->name + " " + one.point->arm);
}

// Comparison of all arms with truth. Shows the last method first, because the page is usually about this method.
page::PictureComparison wipeOf(const Gallery& gallery) {
  page::PictureComparison wipe;
  wipe.reference = armNameOf(gallery, gallery.truth());
  for (const ShownPoint& one : gallery.shown) {
    if (!one.isTruth()) wipe.others.push_back(armNameOf(gallery, one));
    if (one.point->role == ArmRole::method) wipe.chosen = wipe.others.back();
  }
  return wipe;
}

page::Pictures picturesOf(const Gallery& gallery, const PictureSize& size) {
  page::Pictures pictures;
  for (const ShownPoint& one : gallery.shown) {
    Image smaller = image::shrunk(one.shown, one.shown.width / size.divisor, one.shown.height / size.divisor);
    pictures.pictures.push_back(
        pictureOf(one.point->arm, image::toneMap(smaller, gallery.shot->tone), armNameOf(gallery, one), size.quality));
  }
  return pictures;
}

page::Pictures cropsOf(const Gallery& gallery, const image::Rectangle& area) {
  page::Pictures crops;
  crops.pixels = true;
  for (const ShownPoint& one : gallery.shown)
    crops.pictures.push_back(
        pictureOf(one.point->arm, image::toneMap(image::crop(one.shown, area), gallery.shot->tone)));
  return crops;
}

page::Pictures differencesOf(const Gallery& gallery, double gain) {
  page::Pictures differences;
  for (const ShownPoint& one : gallery.shown) {
    if (one.isTruth()) continue;
    Image difference = gallery.difference(one, gain);
    int divisor = std::max(1, difference.width / 480);
    differences.pictures.push_back(
        pictureOf(one.point->arm, image::shrunk(difference, difference.width / divisor, difference.height / divisor)));
  }
  return differences;
}

void addPictures(const Results& results, const Gallery& gallery, const PictureSize& size, Parts& parts) {
  double gain = results.layout.pictures->difference_gain;
  parts.push_back(heading("Pictures", 3, "", ReportPart::kPage));
  parts.push_back({picturesOf(gallery, size), ReportPart::kPage});
  for (const image::Rectangle& area : gallery.shot->crops) {
    parts.push_back(
        heading(fmt::format("Crop {}x{} at {},{}", area.width, area.height, area.x, area.y), 3, "", ReportPart::kPage));
    parts.push_back({cropsOf(gallery, area), ReportPart::kPage});
  }
  if (gallery.shown.size() == 1) return;  // truth only
  parts.push_back(
      heading(fmt::format("|Difference from truth| × {:g}, linear values", gain), 3, "", ReportPart::kPage));
  parts.push_back({differencesOf(gallery, gain), ReportPart::kPage});
}

void addShot(const Results& results, const Gallery& gallery, const std::optional<PictureSize>& size, Parts& parts) {
  const ShotSummary& shot = *gallery.shot;
  parts.push_back(heading(shot.title, 2, shot.name));
  if (!gallery.group)
    return parts.push_back(text("skipped: " + (shot.missing.empty() ? "not selected" : shot.missing) + "."));
  parts.push_back(text(shot.note, Tone::plain, ReportPart::kRead));
  parts.push_back(text(describeShot(results, shot) + ".", Tone::soft));
  bool pictures = size && !gallery.shown.empty();
  bool compares = pictures && gallery.shown.size() > 1;
  if (compares) parts.push_back({wipeOf(gallery), ReportPart::kPage});
  for (const PointGroup* group : groupsOf(results, shot)) {
    parts.push_back(
        heading("Errors, anchor " + group->anchor + afterComma(describe(*group, "anchor")), 3, "", ReportPart::kPage));
    parts.push_back(text("Regions: " + regionsText(results, *group) + afterComma(describe(*group, "anchor")) + ".",
                         Tone::soft, ReportPart::kTerminal | ReportPart::kDocument));
    parts.push_back({errorTable(results, *group)});
  }
  parts.push_back(
      text("±: standard error of truth. Floor: ground truth with as many samples per pixel as a method. A method that "
           "also reuses neighbouring pixels can be below it.",
           Tone::soft, ReportPart::kPage));
  parts.push_back(text(describeBackground(*gallery.group), Tone::soft));
  append(parts, expectationParts(results, shot.name, ""));
  if (pictures) addPictures(results, gallery, *size, parts);
  parts.push_back(text(shot.attribution, Tone::soft, ReportPart::kRead));
}

std::string describe(const PictureSize& size) {
  std::string smaller = size.divisor == 1 ? "" : fmt::format(", scaled to 1/{} of their width", size.divisor);
  return fmt::format(
      "Pictures here are JPEG of quality {}{}, to keep the page small; crops, differences and the files "
      "beside this page are exact.",
      size.quality, smaller);
}

}  // namespace

Parts pictureParts(const Results& results, const std::vector<Gallery>& galleries,
                   const std::optional<PictureSize>& size) {
  Parts parts;
  for (const Gallery& gallery : galleries) addShot(results, gallery, size, parts);
  parts.push_back(text(
      "RMSE of linear values over all channels; FLIP at 67 pixels per degree; one sample per pixel at its centre, for "
      "methods and truth alike. Regions are computed from truth. Inner: pixels that show a farther surface at another "
      "time of the exposure. Hidden: surfaces that are visible only at another time. Outer: pixels that show a nearer "
      "surface at another time.",
      Tone::soft, ReportPart::kPage));
  if (size && size->quality > 0) parts.push_back(text(describe(*size), Tone::soft, ReportPart::kPage));
  return parts;
}

}  // namespace strobe::study
