// SPDX-License-Identifier: MIT
#include "figure/panel.h"

#include <algorithm>
#include <cmath>

#include "figure/captions.h"
#include "image/draw.h"
#include "image/false_colour.h"
#include "image/flip.h"
#include "lab/record.h"

namespace strobe::figure {

namespace {

using image::Image;
using image::Rectangle;
using LegendKind = image::Legend::Kind;

// Content of a cell in full size: linear colour with a tone map, or a display image.
struct CellSource {
  Image pixels;
  std::optional<image::ToneMap> tone;
  image::Legend legend;

  // Part of the content, reduced to 1 / shrink of its size.
  Image cut(const Rectangle& area, double shrink = 1) const {
    Image part = image::crop(pixels, area);
    auto side = [&](int length) { return std::max(1, int(length / shrink + 1e-9)); };
    if (shrink > 1) part = image::shrunk(part, side(part.width), side(part.height));
    return tone ? image::toneMap(part, *tone) : part;
  }
};

const Image* colorImageOf(const Taken& taken) {
  auto found = taken.picture->frame.outputs.find("color");
  return found == taken.picture->frame.outputs.end() ? nullptr : &found->second.floats;
}

bool isColour(const graph::ReadImage& image, const FigureCell& cell, const Image& color) {
  std::string kind = cell.kind == "auto" ? lab::automaticKind(image, cell.view) : cell.kind;
  bool sum = cell.view.substr(cell.view.rfind('.') + 1).starts_with("sum");
  return kind == "colour" && !sum && image.floats.channels >= 3 && image.floats.width == color.width &&
         image.floats.height == color.height;
}

CellSource viewOf(const FigureCell& cell, const Taken& taken, const graph::ReadImage& image, const Image& color) {
  image::ToneMap tone = taken.tone;
  if (cell.stops) tone.stops = float(*cell.stops);
  if (isColour(image, cell, color)) return {image::threeChannels(image.floats), tone, {}};
  lab::ViewOptions options;
  options.kind = cell.kind, options.low = cell.low, options.high = cell.high;
  options.exposure_stops = tone.stops;
  auto divide = taken.divides.find(cell.view);
  CellSource source;
  source.pixels = lab::shown(image, cell.view, divide == taken.divides.end() ? 1 : divide->second, color.width,
                             color.height, options, &color, &source.legend);
  return source;
}

CellSource flipOf(const Image& a, const Image& b) {
  return {image::heatMap(image::ldrFlip(a, b), 0, 1), {}, {LegendKind::bar, 0, 1, "FLIP"}};
}

std::optional<CellSource> differenceOf(const FigureCell& cell, const Taken& taken, const Taken& other,
                                       Problems& problems) {
  const graph::ReadImage* a = findImage(taken, cell.view, cell.place, problems);
  const graph::ReadImage* b = findImage(other, cell.view, cell.place, problems);
  if (!a || !b) return {};
  if (a->floats.empty() || !image::sameSize(a->floats, b->floats)) {
    problems.add(cell.place, fmt::format("'{}' of '{}' and of '{}' are not numeric images of the same size", cell.view,
                                         taken.arm, other.arm));
    return {};
  }
  Image first = image::threeChannels(a->floats), second = image::threeChannels(b->floats);
  if (cell.difference == "flip") return flipOf(first, second);
  if (cell.difference == "channels")
    return CellSource{image::absoluteDifference(first, second, float(cell.gain)),
                      {},
                      {LegendKind::words, 0, 0, fmt::format("|difference from {}| × {:g}", other.arm, cell.gain)}};
  image::Legend legend{LegendKind::bar, 0, 1 / cell.gain, fmt::format("|difference from {}|", other.arm)};
  return CellSource{image::differenceHeat(first, second, float(cell.gain)), {}, legend};
}

Rectangle scaled(const Area& area, dvec2 scale) {
  auto at = [](double value, double s) { return int(std::lround(value * s)); };
  return {at(area.x, scale.x), at(area.y, scale.y), std::max(1, at(area.width, scale.x)),
          std::max(1, at(area.height, scale.y))};
}

// Crop in a picture, pixels of the picture; the whole picture without a crop. Empty if the crop lies outside of the
// picture.
std::optional<Rectangle> areaOf(const std::optional<Area>& crop, const Image& picture, dvec2 scale, const Place& place,
                                Problems& problems) {
  if (!crop) return Rectangle{0, 0, picture.width, picture.height};
  int width = int(std::lround(picture.width / scale.x)), height = int(std::lround(picture.height / scale.y));
  if (crop->x + crop->width > width || crop->y + crop->height > height) {
    problems.add(place, fmt::format("the crop {}x{} at {},{} lies outside the picture of {}x{}", crop->width,
                                    crop->height, crop->x, crop->y, width, height));
    return {};
  }
  Rectangle area = scaled(*crop, scale);
  area.x = std::min(area.x, picture.width - 1), area.y = std::min(area.y, picture.height - 1);
  area.width = std::min(area.width, picture.width - area.x);
  area.height = std::min(area.height, picture.height - area.y);
  return area;
}

// Makes one block.
class Maker {
 public:
  Maker(const FigureData& figure, const FigureCell& cell, const FindTaken& find, int step, Problems& problems)
      : figure_(figure),
        cell_(cell),
        find_(find),
        step_(cell.step.value_or(step)),
        problems_(problems),
        scale_(figure.scale()) {}

  Block make(const std::string& truth_arm) {
    truth_arm_ = truth_arm;
    block_.row = cell_.row, block_.column = cell_.column;
    std::optional<Taken> taken = found(cell_.arm);
    if (!taken) return block_;
    const Image* color = colorImageOf(*taken);
    if (!color) {
      findImage(*taken, "color", cell_.place, problems_);
      return block_;
    }
    if (std::optional<CellSource> source = sourceOf(*taken, *color)) show(*source, *taken);
    auto filled = [&](const std::vector<CaptionPart>& parts) {
      return captionOf(
          parts, *taken, [this] { return truth(); }, cell_.place, problems_);
    };
    block_.caption = filled(cell_.caption);
    auto of_row = [&](const FigureCell& other) { return other.row == cell_.row; };
    bool first = &*std::find_if(figure_.cells.begin(), figure_.cells.end(), of_row) == &cell_;
    if (first && size_t(cell_.row) < figure_.headings.size())
      block_.above = filled(figure_.headings[size_t(cell_.row)].note);
    block_.attribution = lab::attributionOf(taken->picture->record);
    return block_;
  }

 private:
  // Returns a copy, because a later search may invalidate the found picture.
  std::optional<Taken> found(const std::string& arm) {
    try {
      return find_(cell_.shot, arm, step_);
    } catch (const Error& error) {
      problems_.add(cell_.place, error.what());
      return {};
    }
  }

  const Taken* truth() {
    if (!truth_ && !truth_arm_.empty()) truth_ = found(truth_arm_);
    return truth_ ? &*truth_ : nullptr;
  }

  // Rectangle of an area. An area with a region becomes the rectangle with most of the region.
  std::optional<Area> placed(const Area& area, const Place& place) {
    if (area.region.empty()) return area;
    try {
      if (!truth())
        throw Error(fmt::format("the region '{}' is computed from truth, but the capture has no truth", area.region));
      Image mask = regionOf(*truth(), area.region);
      Rectangle size = {0, 0, int(area.width), int(area.height)};
      size = image::scaledCrop(size, scale_.x, scale_.y, mask);
      Rectangle at = image::densestCrop(mask, size.width, size.height);
      return Area{at.x / scale_.x, at.y / scale_.y, at.width / scale_.x, at.height / scale_.y, ""};
    } catch (const Error& error) {
      problems_.add(place, error.what());
      return {};
    }
  }

  // Crop of a picture, pixels of the picture; the whole picture without a crop.
  std::optional<Rectangle> cropped(const std::optional<Area>& crop, const Image& picture, const Place& place) {
    std::optional<Area> in_pixels = crop ? placed(*crop, place) : crop;
    if (crop && !in_pixels) return {};
    return areaOf(in_pixels, picture, scale_, place, problems_);
  }

  std::vector<FigureShape> shapes(std::vector<FigureMark> marks, const Taken& taken, const Lens& lens) {
    for (FigureMark& mark : marks)
      if (mark.kind == FigureMark::Kind::box) mark.area = placed(mark.area, mark.place).value_or(Area());
    return shapesOf(marks, taken, lens, figure_.size(), problems_);
  }

  std::optional<CellSource> sourceOf(const Taken& taken, const Image& color) {
    if (!cell_.against.empty()) {
      std::optional<Taken> other = found(cell_.against);
      if (!other) return {};
      return differenceOf(cell_, taken, *other, problems_);
    }
    const graph::ReadImage* image = findImage(taken, cell_.view, cell_.place, problems_);
    if (!image) return {};
    return viewOf(cell_, taken, *image, color);
  }

  void show(const CellSource& source, const Taken& taken) {
    std::optional<Rectangle> area = cropped(cell_.crop, source.pixels, cell_.place);
    if (!area) return;
    double shrink = cell_.shrink;
    int zoom = cell_.zoom;
    if (int width = figure_.cell_width; width > 0)
      shrink = std::max(1.0, double(area->width) / width), zoom = std::max(1, width / area->width);
    block_.main.display = image::magnify(source.cut(*area, shrink), zoom);
    block_.main.frame = cell_.frame;
    if (cell_.key) block_.legend = source.legend;
    Lens lens(scale_, *area, zoom / shrink);
    for (const Inset& inset : cell_.insets) add(inset, source, taken, lens);
    std::vector<FigureShape> own = shapes(cell_.marks, taken, lens);
    block_.main.shapes.insert(block_.main.shapes.end(), own.begin(), own.end());
  }

  // Adds an inset, and a frame around its crop in the picture.
  void add(const Inset& inset, const CellSource& source, const Taken& taken, const Lens& outer) {
    std::optional<Rectangle> area = cropped(inset.crop, source.pixels, inset.place);
    if (!area) return;
    Panel panel{image::magnify(source.cut(*area), inset.zoom), {}, inset.frame, inset.at};
    panel.shapes = shapes(inset.marks, taken, Lens(scale_, *area, inset.zoom));
    block_.insets.push_back(std::move(panel));
    FigureShape frame{FigureShape::Kind::box,
                      outer.inFigure({area->x, area->y}),
                      outer.inFigure({area->x + area->width, area->y + area->height}),
                      0,
                      2 * figure_.size(),
                      inset.frame,
                      ""};
    block_.main.shapes.push_back(frame);
  }

  const FigureData& figure_;
  const FigureCell& cell_;
  const FindTaken& find_;
  const int step_;
  Problems& problems_;
  const dvec2 scale_;
  std::string truth_arm_;
  std::optional<Taken> truth_;
  Block block_;
};

}  // namespace

Block blockOf(const FigureData& figure, const FigureCell& cell, const FindTaken& find, const std::string& truth_arm,
              int step, Problems& problems) {
  return Maker(figure, cell, find, step, problems).make(truth_arm);
}

}  // namespace strobe::figure
