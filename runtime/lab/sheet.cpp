// SPDX-License-Identifier: MIT
#include "lab/sheet.h"

#include <algorithm>
#include <cmath>

#include "image/false_colour.h"
#include "lab/figures.h"

namespace strobe::lab {

using image::Colour;
using image::Image;

namespace {

constexpr int kCell = 480;  // widest picture, px
constexpr int kGap = 10, kMargin = 28;
constexpr Colour kPaper = {1, 1, 1}, kInk = {0.1f, 0.1f, 0.12f}, kSoft = {0.38f, 0.38f, 0.42f},
                 kEmpty = {0.94f, 0.94f, 0.95f};
const std::vector<Colour> kCropColours = {{1.0f, 0.76f, 0.03f}, {0.1f, 0.75f, 0.95f}, {0.95f, 0.3f, 0.75f}};

// Smaller text where it would not fit, cut where even that does not.
void drawFitted(Image& onto, int x, int y, std::string text, float size_px, int width, const Colour& colour) {
  while (size_px > 11 && image::textWidth(text, size_px) > width) size_px -= 1;
  if (image::textWidth(text, size_px) > width) {
    while (!text.empty() && image::textWidth(text + "…", size_px) > width) {
      while (text.size() > 1 && (text.back() & 0xc0) == 0x80) text.pop_back();
      text.pop_back();
    }
    text += "…";
  }
  image::drawText(onto, x, y, text, size_px, colour);
}

// Fits a display image into a cell: large ones were shrunk before, small ones grow by whole factors.
Image grown(const Image& picture, int width) { return image::magnify(picture, std::max(1, width / picture.width)); }

// A growing sheet with a pen that moves down.
class Sheet {
 public:
  Sheet(int width) : width_(width), pixels_(image::filled(width, 1, kPaper)) {}

  int y() const { return y_; }
  void skip(int px) { need(y_ += px); }

  void line(const std::string& text, float size_px, const Colour& colour = kInk) {
    need(y_ + int(size_px * 1.3f));
    drawFitted(pixels_, kMargin, y_, text, size_px, width_ - 2 * kMargin, colour);
    y_ += int(size_px * 1.3f);
  }
  void at(int x, const std::string& text, float size_px, int width, const Colour& colour) {
    need(y_ + int(size_px * 1.3f));
    drawFitted(pixels_, x, y_, text, size_px, width, colour);
  }
  void picture(int x, const Image& what) {
    need(y_ + what.height);
    image::paste(pixels_, what, x, y_);
  }
  Image finished() {
    need(y_ + kMargin);
    return image::crop(pixels_, {0, 0, width_, y_ + kMargin});
  }

 private:
  void need(int height) {
    if (height <= pixels_.height) return;
    Image larger = image::filled(width_, height + 1000, kPaper);
    std::copy(pixels_.values.begin(), pixels_.values.end(), larger.values.begin());
    pixels_ = std::move(larger);
  }

  int width_, y_ = 0;
  Image pixels_;
};

std::vector<const Entry*> shownEntries(const Group& group) {
  std::vector<const Entry*> shown;
  for (const Entry& entry : group.entries)
    if (entry.column->shown) shown.push_back(&entry);
  return shown;
}

int cellX(size_t column) { return kMargin + int(column) * (kCell + kGap); }

// A picture at cell size, and how many of the sheet's pixels one of its own became.
Image cellPicture(const Image& linear, const image::ToneMap& tone, double& scale) {
  int width = std::min(linear.width, kCell);
  int height = std::max(1, int(std::lround(double(linear.height) * width / linear.width)));
  Image cell = grown(image::toneMap(shrunk(linear, width, height), tone), kCell);
  scale = double(cell.width) / linear.width;
  return cell;
}

image::Rectangle scaled(const image::Rectangle& area, double scale) {
  return {int(area.x * scale), int(area.y * scale), std::max(3, int(std::ceil(area.width * scale))),
          std::max(3, int(std::ceil(area.height * scale)))};
}

void drawCrops(Image& cell, const ShotResult& result, double scale) {
  for (size_t i = 0; i < result.crops.size(); ++i)
    image::outline(cell, scaled(result.crops[i], scale), kCropColours[i % kCropColours.size()], 2);
}

std::string numbersOf(const Demo& demo, const Exhibition& exhibition, const Entry& entry) {
  std::vector<std::string> parts;
  if (entry.column->role == DemoColumn::Role::truth) {
    if (entry.errors.count("whole")) parts.push_back("standard error " + shownError(entry.errors.at("whole").rmse));
    return fmt::format("{}", fmt::join(parts, ", "));
  }
  for (const char* region : {"inner", "whole"})
    if (entry.errors.count(region))
      parts.push_back(fmt::format("RMSE {} {}", region, shownError(entry.errors.at(region).rmse)));
  if (demo.measures.count("ms") && entry.ms)
    parts.push_back(shownMs(entry) + (exhibition.device.software ? " (software)" : ""));
  return fmt::format("{}", fmt::join(parts, "   "));
}

void addLabels(Sheet& sheet, const Exhibition& exhibition, const std::vector<const Entry*>& entries) {
  for (size_t i = 0; i < entries.size(); ++i) sheet.at(cellX(i), entries[i]->column->label, 27, kCell, kInk);
  sheet.skip(36);
  for (size_t i = 0; i < entries.size(); ++i)
    sheet.at(cellX(i), numbersOf(*exhibition.demo, exhibition, *entries[i]), 17, kCell, kSoft);
  sheet.skip(26);
}

void addPictures(Sheet& sheet, const ShotResult& result, const std::vector<const Entry*>& entries) {
  int height = 0;
  for (size_t i = 0; i < entries.size(); ++i) {
    double scale = 1;
    Image cell = cellPicture(entries[i]->shown, result.shot->tone, scale);
    drawCrops(cell, result, scale);
    sheet.picture(cellX(i), cell);
    height = std::max(height, cell.height);
  }
  sheet.skip(height + kGap);
}

void addCrop(Sheet& sheet, const ShotResult& result, const std::vector<const Entry*>& entries, size_t index) {
  int height = 0;
  for (size_t i = 0; i < entries.size(); ++i) {
    Image part = image::toneMap(image::crop(entries[i]->shown, result.crops[index]), result.shot->tone);
    Image cell = grown(part, kCell);
    image::outline(cell, {0, 0, cell.width, cell.height}, kCropColours[index % kCropColours.size()], 3);
    sheet.picture(cellX(i), cell);
    height = std::max(height, cell.height);
  }
  sheet.skip(height + kGap);
}

// Truth has no difference from itself; its place says what its own error is.
Image truthNote(const Demo& demo, const Entry& truth, int width, int height) {
  Image cell = image::filled(width, height, kEmpty);
  int y = height / 2 - 66;
  drawFitted(cell, 20, y, "the reference", 24, width - 40, kInk);
  y += 8;
  for (const std::string& region : demo.regions)
    drawFitted(cell, 20, y += 24,
               fmt::format("its standard error, {}: {}", region, shownError(truth.errors.at(region).rmse)), 16,
               width - 40, kSoft);
  return cell;
}

void addDifferences(Sheet& sheet, const Exhibition& exhibition, const ShotResult& result,
                    const std::vector<const Entry*>& entries) {
  const Group& group = result.groups.front();
  double gain = exhibition.demo->difference_gain;
  int height = 0;
  for (size_t i = 0; i < entries.size(); ++i) {
    Image difference = differenceFromTruth(*entries[i], group, gain);
    int width = std::min(difference.width, kCell);
    Image cell = grown(shrunk(difference, width, std::max(1, difference.height * width / difference.width)), kCell);
    drawCrops(cell, result, double(cell.width) / difference.width);
    height = std::max(height, cell.height);
    bool truth = entries[i]->column->role == DemoColumn::Role::truth;
    sheet.picture(cellX(i), truth ? truthNote(*exhibition.demo, *entries[i], cell.width, cell.height) : cell);
  }
  sheet.skip(height + kGap);
}

void addShot(Sheet& sheet, const Exhibition& exhibition, const ShotResult& result) {
  sheet.skip(kMargin);
  sheet.line(result.shot->title, 38);
  if (!result.shot->missing.empty()) return sheet.line("skipped: " + result.shot->missing, 21, kSoft);
  sheet.line(describeShot(result) + (result.shot->note.empty() ? "" : ". " + result.shot->note), 21, kSoft);
  sheet.skip(12);
  std::vector<const Entry*> entries = shownEntries(result.groups.front());
  addLabels(sheet, exhibition, entries);
  addPictures(sheet, result, entries);
  for (size_t i = 0; i < result.crops.size(); ++i) {
    int factor = std::max(1, kCell / result.crops[i].width);
    sheet.line(fmt::format("crop at {},{}, {} times as large", result.crops[i].x, result.crops[i].y, factor), 17,
               kSoft);
    addCrop(sheet, result, entries, i);
  }
  sheet.line(fmt::format("|difference from truth| × {:g}, linear values, one sample per pixel",
                         exhibition.demo->difference_gain),
             17, kSoft);
  addDifferences(sheet, exhibition, result, entries);
  if (!result.attribution.empty()) sheet.line(result.attribution, 17, kSoft);
}

}  // namespace

Image differenceFromTruth(const Entry& entry, const Group& group, double gain) {
  return image::absoluteDifference(entry.color, group.truth().color, float(gain));
}

Image shrunk(const Image& linear, int width, int height) {
  width = std::clamp(width, 1, linear.width);
  height = std::clamp(height, 1, linear.height);
  if (width == linear.width && height == linear.height) return linear;
  Image result(width, height, linear.channels);
  for (int y = 0; y < height; ++y) {
    int top = int(int64_t(y) * linear.height / height),
        bottom = std::max(top + 1, int(int64_t(y + 1) * linear.height / height));
    for (int x = 0; x < width; ++x) {
      int left = int(int64_t(x) * linear.width / width),
          right = std::max(left + 1, int(int64_t(x + 1) * linear.width / width));
      for (int c = 0; c < linear.channels; ++c) {
        double sum = 0;
        for (int sy = top; sy < bottom; ++sy)
          for (int sx = left; sx < right; ++sx) sum += linear.at(sx, sy, c);
        result.at(x, y, c) = float(sum / ((bottom - top) * (right - left)));
      }
    }
  }
  return result;
}

Image sheetOf(const Exhibition& exhibition) {
  size_t most = 1;
  for (const ShotResult& result : exhibition.shots)
    if (!result.groups.empty()) most = std::max(most, shownEntries(result.groups.front()).size());
  Sheet sheet(2 * kMargin + int(most) * (kCell + kGap) - kGap);
  sheet.skip(kMargin);
  sheet.line(exhibition.demo->title, 46);
  if (!exhibition.demo->note.empty()) sheet.line(exhibition.demo->note, 21, kSoft);
  for (const ShotResult& result : exhibition.shots) addShot(sheet, exhibition, result);
  sheet.skip(kMargin / 2);
  sheet.line("Strobe " STROBE_VERSION " on " + describeDevice(exhibition), 17, kSoft);
  return sheet.finished();
}

}  // namespace strobe::lab
