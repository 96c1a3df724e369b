// SPDX-License-Identifier: MIT
#include "study/sheet.h"

#include <algorithm>
#include <cmath>

#include "image/crops.h"
#include "image/tone.h"
#include "page/number.h"
#include "page/sheet.h"

namespace strobe::study {

using page::Ink;
using page::Sheet;
using page::SheetLine;
using page::shownError;
using page::shownMs;

using image::Colour;
using image::Image;

namespace {

const std::vector<Colour> kCropColours = {{1.0f, 0.76f, 0.03f}, {0.1f, 0.75f, 0.95f}, {0.95f, 0.3f, 0.75f}};

void addFrames(page::SheetCell& cell, const ShotSummary& shot) {
  for (size_t i = 0; i < shot.crops.size(); ++i)
    cell.frames.push_back({shot.crops[i], kCropColours[i % kCropColours.size()], 2});
}

std::string numbersOf(const Results& results, const Point& point) {
  auto has = [&](const std::string& region) {
    return std::find(results.regions.begin(), results.regions.end(), region) != results.regions.end();
  };
  if (point.role == Role::truth) return has("whole") ? "standard error " + shownError(point.value("rmse")) : "";
  std::vector<std::string> parts;
  for (const char* region : {"inner", "whole"})
    if (has(region)) parts.push_back(fmt::format("RMSE {} {}", region, shownError(point.value("rmse", region))));
  if (double ms = point.value("ms"); !std::isnan(ms))
    parts.push_back(shownMs(ms) + (results.software ? " (software)" : ""));
  return fmt::format("{}", fmt::join(parts, "   "));
}

void addLabels(Sheet& sheet, const Results& results, const Gallery& gallery) {
  std::vector<std::string> names, numbers;
  for (const ShownPoint& one : gallery.shown) {
    names.push_back(one.point->arm);
    numbers.push_back(numbersOf(results, *one.point));
  }
  for (Sheet::Part part : std::vector<Sheet::Part>{page::SheetLabels{names, 27}, page::SheetGap{1},
                                                   page::SheetLabels{numbers, 17, Ink::soft}, page::SheetGap{4}})
    sheet.parts.push_back(std::move(part));
}

void addPictures(Sheet& sheet, const Gallery& gallery) {
  page::SheetRow row;
  for (const ShownPoint& one : gallery.shown) {
    const Image& linear = one.shown;
    int width = std::min(linear.width, page::kSheetColumn);
    int height = std::max(1, int(std::lround(double(linear.height) * width / linear.width)));
    row.cells.push_back({image::toneMap(image::shrunk(linear, width, height), gallery.shot->tone), {}, linear.width});
    addFrames(row.cells.back(), *gallery.shot);
  }
  sheet.parts.push_back(std::move(row));
}

void addCrop(Sheet& sheet, const Gallery& gallery, size_t index) {
  const image::Rectangle& area = gallery.shot->crops[index];
  int factor = std::max(1, page::kSheetColumn / area.width);
  sheet.parts.push_back(
      SheetLine{fmt::format("crop at {},{}, {} times as large", area.x, area.y, factor), 17, Ink::soft});
  page::SheetRow row;
  for (const ShownPoint& one : gallery.shown) {
    Image part = image::toneMap(image::crop(one.shown, area), gallery.shot->tone);
    page::SheetFrame frame{{0, 0, part.width, part.height}, kCropColours[index % kCropColours.size()], 3};
    row.cells.push_back({std::move(part), {frame}});
  }
  sheet.parts.push_back(std::move(row));
}

// Truth has no difference from itself; its place says what its own error is.
std::vector<std::string> truthNote(const Results& results, const Point& truth) {
  std::vector<std::string> texts = {"the reference"};
  for (const std::string& region : results.regions)
    texts.push_back(fmt::format("its standard error, {}: {}", region, shownError(truth.value("rmse", region))));
  return texts;
}

void addDifferences(Sheet& sheet, const Results& results, const Gallery& gallery, double gain) {
  sheet.parts.push_back(SheetLine{
      fmt::format("|difference from truth| × {:g}, linear values, one sample per pixel", gain), 17, Ink::soft});
  page::SheetRow row;
  for (const ShownPoint& one : gallery.shown) {
    Image difference = gallery.difference(one, gain);
    int width = std::min(difference.width, page::kSheetColumn);
    int height = std::max(1, difference.height * width / difference.width);
    row.cells.push_back({image::shrunk(difference, width, height), {}, difference.width});
    addFrames(row.cells.back(), *gallery.shot);
    if (one.isTruth()) row.cells.back().texts = truthNote(results, *one.point);
  }
  sheet.parts.push_back(std::move(row));
}

void addShot(Sheet& sheet, const Results& results, const Gallery& gallery, double gain) {
  const ShotSummary& shot = *gallery.shot;
  sheet.parts.push_back(page::SheetGap{28});
  sheet.parts.push_back(SheetLine{shot.title, 38});
  if (!shot.missing.empty()) return sheet.parts.push_back(SheetLine{"skipped: " + shot.missing, 21, Ink::soft});
  if (gallery.shown.empty()) return sheet.parts.push_back(SheetLine{"not drawn", 21, Ink::soft});
  std::string note = shot.note.empty() ? "" : ". " + shot.note;
  sheet.parts.push_back(SheetLine{describeShot(results, shot) + note, 21, Ink::soft});
  sheet.parts.push_back(page::SheetGap{12});
  addLabels(sheet, results, gallery);
  addPictures(sheet, gallery);
  for (size_t i = 0; i < shot.crops.size(); ++i) addCrop(sheet, gallery, i);
  addDifferences(sheet, results, gallery, gain);
  if (!shot.attribution.empty()) sheet.parts.push_back(SheetLine{shot.attribution, 17, Ink::soft});
}

}  // namespace

Image sheetOf(const Results& results, const std::vector<Gallery>& galleries) {
  double gain = picturesOf(results.layout).value_or(PicturesLayout()).difference_gain;
  Sheet sheet;
  sheet.parts.push_back(SheetLine{results.title, 46});
  if (!results.note.empty()) sheet.parts.push_back(SheetLine{results.note, 21, Ink::soft});
  for (const Gallery& gallery : galleries) addShot(sheet, results, gallery, gain);
  sheet.parts.push_back(page::SheetGap{14});
  sheet.parts.push_back(SheetLine{"Strobe " + results.strobe + " on " + describeDevice(results), 17, Ink::soft});
  return page::imageOf(sheet);
}

}  // namespace strobe::study
