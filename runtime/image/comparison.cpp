// SPDX-License-Identifier: MIT
#include "image/comparison.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "base/error.h"
#include "image/exr.h"
#include "image/metrics.h"
#include "image/png.h"
#include "image/regions.h"
#include "image/tone.h"

namespace strobe::image {

enum class FileKind { png, exr };

static FileKind kindOf(const Path& file) {
  std::vector<uint8_t> bytes = readBytes(file);
  if (bytes.size() >= 8 && std::memcmp(bytes.data(), "\x89PNG\r\n\x1a\n", 8) == 0) return FileKind::png;
  if (bytes.size() >= 4 && std::memcmp(bytes.data(), "\x76\x2f\x31\x01", 4) == 0) return FileKind::exr;
  throw Error("is neither a PNG nor an OpenEXR file", {file.string()});
}

static void requireFinite(const Image& image, const Path& file) {
  const NotFinite found = notFiniteIn(image);
  if (found.pixels > 0)
    throw Error(fmt::format("pixel {},{} is not finite ({})", found.x, found.y, found.value), {file.string()});
}

static Rectangle boundsOf(const Rectangle& a, const Rectangle& b) {
  int x = std::min(a.x, b.x), y = std::min(a.y, b.y);
  return {x, y, std::max(a.x + a.width, b.x + b.width) - x, std::max(a.y + a.height, b.y + b.height) - y};
}

static size_t areaOf(const Rectangle& window) { return size_t(window.width) * size_t(window.height); }

static std::string windowsOf(const ComparedPicture& picture) {
  auto text = [](const Rectangle& w) {
    return fmt::format("{},{} to {},{}", w.x, w.y, w.x + w.width - 1, w.y + w.height - 1);
  };
  return fmt::format("data window {} in the display window {}", text(picture.data), text(picture.display));
}

static bool fillsDisplay(const ComparedPicture& picture) {
  return areaOf(overlap(picture.data, picture.display)) == areaOf(picture.display) &&
         areaOf(picture.data) == areaOf(picture.display);
}

// Copies `image` from the window `from` to the window `to`. Pixels outside of `from` are 0.
static Image cutTo(const Image& image, const Rectangle& from, const Rectangle& to) {
  Image cut(to.width, to.height, image.channels);
  Rectangle common = overlap(from, to);
  for (int y = common.y; y < common.y + common.height && common.width > 0; ++y)
    std::copy_n(image.pixel(common.x - from.x, y - from.y), size_t(common.width) * size_t(image.channels),
                cut.pixel(common.x - to.x, y - to.y));
  return cut;
}

static ComparedPicture placed(Image image, const Rectangle& data, const Rectangle& display, bool hdr) {
  ComparedPicture picture;
  picture.linear = std::move(image);
  picture.hdr = hdr, picture.data = data, picture.display = display;
  return picture;
}

static ComparedPicture pngPicture(Image image) {
  Rectangle whole{0, 0, image.width, image.height};
  return placed(std::move(image), whole, whole, false);
}

static ComparedPicture exrPicture(const ExrFile& content, Image image) {
  return placed(std::move(image), {content.x, content.y, content.width, content.height},
                {0, 0, content.display_width, content.display_height}, true);
}

ComparedPicture readPicture(const Path& file, const std::string& layer) {
  if (kindOf(file) == FileKind::exr) {
    ExrFile content = readExrLayer(file, layer);
    ComparedPicture picture = exrPicture(content, colourOf(content, layer, file));
    requireFinite(picture.linear, file);
    bool converts = content.primaries && !content.primaries->areRec709();
    if (converts) picture.notes.push_back(convertStated(picture.linear, *content.primaries));
    return picture;
  }
  if (!layer.empty()) throw Error(fmt::format("is a PNG and has no layer '{}'", layer), {file.string()});
  LinearPng png = readLinearPng(file);
  ComparedPicture picture = pngPicture(std::move(png.linear));
  picture.notes = std::move(png.notes);
  return picture;
}

static Image firstChannel(const Image& image) {
  Image first(image.width, image.height, 1);
  for (size_t i = 0; i < first.values.size(); ++i) first.values[i] = image.values[i * size_t(image.channels)];
  return first;
}

ComparedPicture readMask(const Path& file) {
  if (kindOf(file) == FileKind::png) return pngPicture(firstChannel(readPng(file)));
  ExrFile content = readExrLayer(file, "");
  return exrPicture(content, firstChannel(colourOf(content, "", file)));
}

static std::string sizeOf(const ComparedPicture& picture) {
  std::string windows = fillsDisplay(picture) ? "" : fmt::format(" ({})", windowsOf(picture));
  return fmt::format("{}x{} pixels{}", picture.display.width, picture.display.height, windows);
}

// Crops or extends a picture to `area`, a part of the display window.
static void placeIn(const Rectangle& area, ComparedPicture& picture) {
  size_t shown = areaOf(overlap(picture.data, picture.display)), hidden = areaOf(picture.data) - shown;
  if (hidden > 0)
    picture.notes.push_back(
        fmt::format("{} pixels outside of the display window are not compared: {}", hidden, windowsOf(picture)));
  if (size_t lacking = areaOf(area) - shown; lacking > 0)
    picture.notes.push_back(
        fmt::format("{} of the compared pixels are outside of its data window and count as black: {}", lacking,
                    windowsOf(picture)));
  picture.linear = cutTo(picture.linear, picture.data, area);
}

void alignPictures(ComparedPicture& test, ComparedPicture& reference, ComparedPicture& mask) {
  auto refuse = [&](const char* what, const ComparedPicture& other) {
    throw Error(fmt::format("the {} has {}, but the test image has {}", what, sizeOf(other), sizeOf(test)));
  };
  auto sameSize = [](const Rectangle& a, const Rectangle& b) { return a.width == b.width && a.height == b.height; };
  if (!sameSize(test.display, reference.display)) refuse("reference", reference);
  Rectangle area = test.data;
  if (test.data != reference.data) {
    area = boundsOf(overlap(test.data, test.display), overlap(reference.data, reference.display));
    for (const ComparedPicture* one : {&test, &reference})
      if (areaOf(overlap(one->data, one->display)) == 0) refuse("reference", reference);
    placeIn(area, test), placeIn(area, reference);
  }
  bool covers = mask.linear.empty() || (fillsDisplay(mask) && sameSize(mask.display, area));
  if (covers) return;
  if (!sameSize(test.display, mask.display)) refuse("mask", mask);
  mask.linear = cutTo(mask.linear, mask.data, area);
}

// JSON has no infinity, and null means "not measured".
static Json number(const std::optional<double>& value) {
  if (!value || std::isnan(*value)) return nullptr;
  if (std::isinf(*value)) return *value > 0 ? "inf" : "-inf";
  return *value;
}

ImageComparison compareImages(const Image& test, const Image& reference, const Image& mask,
                              const CompareOptions& options) {
  const size_t pixels = countedPixels(test, mask);
  if (pixels == 0) throw Error("the mask is empty: all its pixels are below 0.5");
  const double mse = meanSquaredError(test, reference, mask);
  Image map = ldrFlip(test, reference, options.pixels_per_degree);
  Json numbers = {{"mse", number(mse)},
                  {"rmse", number(std::sqrt(mse))},
                  {"psnr", number(psnr(test, reference, mask))},
                  {"relmse", number(relativeMse(test, reference, mask))},
                  {"relmse_trimmed", number(trimmedRelativeMse(test, reference, mask))},
                  {"smape", number(smape(test, reference, mask))},
                  {"ssim", number(ssim(test, reference, mask))},
                  {"ms_ssim", mask.empty() ? number(multiScaleSsim(test, reference)) : Json()},
                  {"ldr_flip", number(meanOf(map, mask))},
                  {"ldr_flip_max", number(largestOf(map, mask))},
                  {"hdr_flip", nullptr},
                  {"hdr_flip_max", nullptr}};
  if (options.hdr) {
    HdrFlip hdr = hdrFlip(test, reference, options.exposures, options.pixels_per_degree);
    numbers["hdr_flip"] = number(meanOf(hdr.map, mask));
    numbers["hdr_flip_max"] = number(largestOf(hdr.map, mask));
    numbers["hdr_flip_start"] = hdr.exposures.start;
    numbers["hdr_flip_stop"] = hdr.exposures.stop;
    numbers["hdr_flip_exposures"] = hdr.exposures.count;
    numbers["hdr_flip_source"] = exposureSourceName(hdr.exposures.source);
    map = std::move(hdr.map);
  }
  numbers["pixels"] = pixels;
  return {std::move(numbers), std::move(map)};
}

}  // namespace strobe::image
