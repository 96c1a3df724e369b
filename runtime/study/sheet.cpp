// SPDX-License-Identifier: MIT
#include "study/sheet.h"

#include <algorithm>
#include <cmath>

#include "image/draw.h"
#include "image/tone.h"
#include "page/number.h"
#include "study/crops.h"

namespace strobe::study {

using page::shownError;
using page::shownMs;

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

void drawCrops(Image& cell, const ShotSummary& shot, double scale) {
  for (size_t i = 0; i < shot.crops.size(); ++i)
    image::outline(cell, scaled(shot.crops[i], scale), kCropColours[i % kCropColours.size()], 2);
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

// The sheet of some results.
class Layout {
 public:
  Layout(const Results& results, double gain, size_t columns)
      : results_(results), gain_(gain), sheet_(2 * kMargin + int(columns) * (kCell + kGap) - kGap) {}

  Image sheet(const std::vector<Gallery>& galleries);

 private:
  void labels(const Gallery& gallery);
  void pictures(const Gallery& gallery);
  void crop(const Gallery& gallery, size_t index);
  void differences(const Gallery& gallery);
  void shot(const Gallery& gallery);
  Image truthNote(const Point& truth, int width, int height) const;

  const Results& results_;
  double gain_;
  Sheet sheet_;
};

void Layout::labels(const Gallery& gallery) {
  for (size_t i = 0; i < gallery.shown.size(); ++i) sheet_.at(cellX(i), gallery.shown[i].point->arm, 27, kCell, kInk);
  sheet_.skip(36);
  for (size_t i = 0; i < gallery.shown.size(); ++i)
    sheet_.at(cellX(i), numbersOf(results_, *gallery.shown[i].point), 17, kCell, kSoft);
  sheet_.skip(26);
}

void Layout::pictures(const Gallery& gallery) {
  int height = 0;
  for (size_t i = 0; i < gallery.shown.size(); ++i) {
    double scale = 1;
    Image cell = cellPicture(gallery.shown[i].shown, gallery.shot->tone, scale);
    drawCrops(cell, *gallery.shot, scale);
    sheet_.picture(cellX(i), cell);
    height = std::max(height, cell.height);
  }
  sheet_.skip(height + kGap);
}

void Layout::crop(const Gallery& gallery, size_t index) {
  int height = 0;
  for (size_t i = 0; i < gallery.shown.size(); ++i) {
    Image part = image::toneMap(image::crop(gallery.shown[i].shown, gallery.shot->crops[index]), gallery.shot->tone);
    Image cell = grown(part, kCell);
    image::outline(cell, {0, 0, cell.width, cell.height}, kCropColours[index % kCropColours.size()], 3);
    sheet_.picture(cellX(i), cell);
    height = std::max(height, cell.height);
  }
  sheet_.skip(height + kGap);
}

// Truth has no difference from itself; its place says what its own error is.
Image Layout::truthNote(const Point& truth, int width, int height) const {
  Image cell = image::filled(width, height, kEmpty);
  int y = height / 2 - 66;
  drawFitted(cell, 20, y, "the reference", 24, width - 40, kInk);
  y += 8;
  for (const std::string& region : results_.regions)
    drawFitted(cell, 20, y += 24,
               fmt::format("its standard error, {}: {}", region, shownError(truth.value("rmse", region))), 16,
               width - 40, kSoft);
  return cell;
}

void Layout::differences(const Gallery& gallery) {
  int height = 0;
  for (size_t i = 0; i < gallery.shown.size(); ++i) {
    Image difference = gallery.difference(gallery.shown[i], gain_);
    int width = std::min(difference.width, kCell);
    Image cell = grown(shrunk(difference, width, std::max(1, difference.height * width / difference.width)), kCell);
    drawCrops(cell, *gallery.shot, double(cell.width) / difference.width);
    height = std::max(height, cell.height);
    bool truth = gallery.shown[i].isTruth();
    sheet_.picture(cellX(i), truth ? truthNote(*gallery.shown[i].point, cell.width, cell.height) : cell);
  }
  sheet_.skip(height + kGap);
}

void Layout::shot(const Gallery& gallery) {
  const ShotSummary& shot = *gallery.shot;
  sheet_.skip(kMargin);
  sheet_.line(shot.title, 38);
  if (!shot.missing.empty()) return sheet_.line("skipped: " + shot.missing, 21, kSoft);
  sheet_.line(describeShot(results_, shot) + (shot.note.empty() ? "" : ". " + shot.note), 21, kSoft);
  sheet_.skip(12);
  labels(gallery);
  pictures(gallery);
  for (size_t i = 0; i < shot.crops.size(); ++i) {
    int factor = std::max(1, kCell / shot.crops[i].width);
    sheet_.line(fmt::format("crop at {},{}, {} times as large", shot.crops[i].x, shot.crops[i].y, factor), 17, kSoft);
    crop(gallery, i);
  }
  sheet_.line(fmt::format("|difference from truth| × {:g}, linear values, one sample per pixel", gain_), 17, kSoft);
  differences(gallery);
  if (!shot.attribution.empty()) sheet_.line(shot.attribution, 17, kSoft);
}

Image Layout::sheet(const std::vector<Gallery>& galleries) {
  sheet_.skip(kMargin);
  sheet_.line(results_.title, 46);
  if (!results_.note.empty()) sheet_.line(results_.note, 21, kSoft);
  for (const Gallery& gallery : galleries) shot(gallery);
  sheet_.skip(kMargin / 2);
  sheet_.line("Strobe " + results_.strobe + " on " + describeDevice(results_), 17, kSoft);
  return sheet_.finished();
}

}  // namespace

Image sheetOf(const Results& results, const std::vector<Gallery>& galleries) {
  size_t most = 1;
  for (const Gallery& gallery : galleries) most = std::max(most, gallery.shown.size());
  return Layout(results, picturesOf(results.layout).value_or(PicturesLayout()).difference_gain, most).sheet(galleries);
}

}  // namespace strobe::study
