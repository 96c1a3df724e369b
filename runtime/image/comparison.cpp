// SPDX-License-Identifier: MIT
#include "image/comparison.h"

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

Picture readPicture(const Path& file, const std::string& layer) {
  if (kindOf(file) == FileKind::exr) {
    Image linear = colourOf(readExrLayer(file, layer), layer, file);
    requireFinite(linear, file);
    return {linear, true};
  }
  if (!layer.empty()) throw Error(fmt::format("is a PNG and has no layer '{}'", layer), {file.string()});
  return {decodeSrgb(threeChannels(readPng(file))), false};
}

Image readMask(const Path& file) {
  Image colour = kindOf(file) == FileKind::exr ? colourOf(readExrLayer(file, ""), "", file) : readPng(file);
  Image mask(colour.width, colour.height, 1);
  for (size_t i = 0; i < mask.values.size(); ++i) mask.values[i] = colour.values[i * colour.channels];
  return mask;
}

static void requireComparable(const Image& test, const Image& reference, const Image& mask) {
  auto refuse = [&](const char* what, const Image& other) {
    throw Error(fmt::format("the {} has {}x{} pixels, the test image {}x{}", what, other.width, other.height,
                            test.width, test.height));
  };
  if (!sameSize(reference, test)) refuse("reference", reference);
  if (mask.empty()) return;
  if (!sameSize(mask, test)) refuse("mask", mask);
  if (countedPixels(test, mask) == 0) throw Error("the mask is empty: no pixel of it is 0.5 or more");
}

Comparison compareImages(const Image& test, const Image& reference, const Image& mask, const CompareOptions& options) {
  requireComparable(test, reference, mask);
  Comparison result;
  result.pixels = countedPixels(test, mask);
  result.mse = meanSquaredError(test, reference, mask);
  result.rmse = std::sqrt(result.mse);
  result.psnr = psnr(test, reference, mask);
  result.relmse = relativeMse(test, reference, mask);
  result.relmse_trimmed = trimmedRelativeMse(test, reference, mask);
  result.smape = smape(test, reference, mask);
  result.ssim = ssim(test, reference, mask);
  if (mask.empty()) result.ms_ssim = multiScaleSsim(test, reference);

  result.ldr_map = ldrFlip(test, reference, options.flip.pixels_per_degree);
  result.ldr_flip = meanOf(result.ldr_map, mask);
  result.ldr_flip_max = largestOf(result.ldr_map, mask);
  if (!options.hdr) return result;
  HdrFlip hdr = hdrFlip(test, reference, options.flip);
  result.hdr_flip = meanOf(hdr.map, mask);
  result.hdr_flip_max = largestOf(hdr.map, mask);
  result.exposures = hdr.exposures;
  result.hdr_map = std::move(hdr.map);
  return result;
}

// JSON has no infinity, and null means "not measured".
static Json number(const std::optional<double>& value) {
  if (!value || std::isnan(*value)) return nullptr;
  if (std::isinf(*value)) return *value > 0 ? "inf" : "-inf";
  return *value;
}

Json comparisonJson(const Comparison& comparison) {
  const Comparison& c = comparison;
  const std::pair<const char*, std::optional<double>> values[] = {{"mse", c.mse},
                                                                  {"rmse", c.rmse},
                                                                  {"psnr", c.psnr},
                                                                  {"relmse", c.relmse},
                                                                  {"relmse_trimmed", c.relmse_trimmed},
                                                                  {"smape", c.smape},
                                                                  {"ssim", c.ssim},
                                                                  {"ms_ssim", c.ms_ssim},
                                                                  {"ldr_flip", c.ldr_flip},
                                                                  {"ldr_flip_max", c.ldr_flip_max},
                                                                  {"hdr_flip", c.hdr_flip},
                                                                  {"hdr_flip_max", c.hdr_flip_max}};
  Json json;
  for (const auto& [name, value] : values) json[name] = number(value);
  if (comparison.hdr_flip) {
    json["hdr_flip_start"] = comparison.exposures.start;
    json["hdr_flip_stop"] = comparison.exposures.stop;
    json["hdr_flip_exposures"] = comparison.exposures.count;
    json["hdr_flip_source"] = exposureSourceName(comparison.exposures.source);
  }
  json["pixels"] = comparison.pixels;
  return json;
}

}  // namespace strobe::image
