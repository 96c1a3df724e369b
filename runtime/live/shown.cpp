// SPDX-License-Identifier: MIT
#include "live/shown.h"

#include <algorithm>
#include <cmath>

#include "image/metrics.h"

namespace strobe::live {

static const char* const kErrorName = "mean |x - truth|";
static const char* const kDifferenceName = "mean |A - B|";
static const int kFlickerFrames = 12;  // window frames for each side

const std::vector<std::string>& modeNames() {
  static const std::vector<std::string> names = {"single", "wipe", "flicker", "difference", "error"};
  return names;
}

Mode modeNamed(const std::string& name) {
  auto found = std::find(modeNames().begin(), modeNames().end(), name);
  if (found == modeNames().end()) throw Error(fmt::format("unknown mode '{}'{}", name, didYouMean(name, modeNames())));
  return Mode(found - modeNames().begin());
}

bool comparesWithB(Mode mode) { return mode == Mode::Wipe || mode == Mode::Flicker || mode == Mode::Difference; }

const Side& Shown::side() const {
  bool of_b = look_.mode == Mode::Flicker  ? window_frame_ / kFlickerFrames % 2 != 0
              : look_.mode == Mode::Single ? look_.single_b
                                           : false;
  return of_b && b_ ? *b_ : a_;
}

// True if A and B share the picture. The sizes differ after B refused a value or a frame could not be drawn; then the
// picture is not divided.
bool Shown::isDivided() const {
  if (!b_ || (look_.mode != Mode::Wipe && look_.mode != Mode::Error)) return false;
  const lab::Shot &of_a = a_.session->shot(), &of_b = b_->session->shot();
  return of_a.width == of_b.width && of_a.height == of_b.height && !a_.color.empty() && !b_->color.empty();
}

bool Shown::isDifference() const {
  return look_.mode == Mode::Difference && b_ && !a_.color.empty() && image::sameSize(a_.color, b_->color);
}

bool Shown::hasError(const Side& side) const {
  return look_.mode == Mode::Error && !side.color.empty() && image::sameSize(side.color, truth_.mean());
}

const Side& Shown::sideAt(int x) const {
  if (!isDivided()) return side();
  return x < lab::wipedFrom(look_.wipe, a_.session->shot().width) ? a_ : *b_;
}

// ---- values

template <class Pixels>
static void takeTexel(PixelValue& value, const Pixels& image, int divide, const lab::Shot& shot, int x, int y) {
  value.x = divide > 0 ? x / divide : x * image.width / shot.width;
  value.y = divide > 0 ? y / divide : y * image.height / shot.height;
  bool inside = value.x < image.width && value.y < image.height;
  for (int c = 0; c < image.channels && inside; ++c) value.values.push_back(double(image.at(value.x, value.y, c)));
}

static char letterOf(bool of_b) { return of_b ? 'B' : 'A'; }

std::optional<PixelValue> Shown::imageAt(const Side& side, int x, int y) const {
  const graph::ReadImage* read = side.image();
  if (!read) return {};
  const lab::Shot& of = side.session->shot();
  int divide = lab::divideOf(side.session->plan(), side.drawn_port);
  PixelValue value{letterOf(&side == b_), side.drawn_port, read->format};
  value.integers = read->isUint();
  if (value.integers) takeTexel(value, read->uints, divide, of, x, y);
  else takeTexel(value, read->floats, divide, of, x, y);
  if (value.values.empty()) return {};
  return value;
}

PixelValue Shown::colourAt(const Side& side, int x, int y) const {
  PixelValue value{letterOf(&side == b_), "color", side.frame.outputs.at("color").format, x, y};
  for (int c = 0; c < 3; ++c) value.values.push_back(double(side.color.at(x, y, c)));
  return value;
}

// Mean absolute difference of a pixel over its channels, as in the picture.
static PixelValue differenceAt(char side, const char* name, const image::Image& one, const image::Image& other, int x,
                               int y) {
  double sum = 0;
  for (int c = 0; c < 3; ++c) sum += std::abs(double(one.at(x, y, c)) - other.at(x, y, c));
  return {side, name, "", x, y, {sum / 3}};
}

std::vector<PixelValue> Shown::valuesAt(int x, int y) const {
  const Side& side = sideAt(x);
  const lab::Shot& of = side.session->shot();
  if (x < 0 || y < 0 || x >= of.width || y >= of.height) return {};
  if (isDifference())
    return {differenceAt(' ', kDifferenceName, a_.color, b_->color, x, y), colourAt(a_, x, y), colourAt(*b_, x, y)};
  if (hasError(side))
    return {differenceAt(letterOf(&side == b_), kErrorName, side.color, truth_.mean(), x, y), colourAt(side, x, y)};
  std::optional<PixelValue> value = imageAt(side, x, y);
  return value ? std::vector<PixelValue>{*value} : std::vector<PixelValue>();
}

// ---- the picture

image::Image Shown::shown(const Side& side, image::Legend& legend) const {
  if (hasError(side)) return lab::difference(side.color, truth_.mean(), look_.gain, kErrorName, &legend);
  const lab::Shot& of = side.session->shot();
  const graph::ReadImage* read = side.image();
  if (!read) return image::Image(of.width, of.height, 3);
  return lab::shown(*read, side.drawn_port, lab::divideOf(side.session->plan(), side.drawn_port), of.width, of.height,
                    look_.view, side.color.empty() ? nullptr : &side.color, &legend);
}

image::Image Shown::compose(std::array<image::Legend, 2>& legends) const {
  legends = {};
  if (isDifference()) return lab::difference(a_.color, b_->color, look_.gain, kDifferenceName, &legends[0]);
  if (!isDivided()) return shown(side(), legends[0]);
  image::Image both = lab::wiped(shown(a_, legends[0]), shown(*b_, legends[1]), look_.wipe);
  if (legends[0] == legends[1]) legends[1] = {};
  return both;
}

}  // namespace strobe::live
