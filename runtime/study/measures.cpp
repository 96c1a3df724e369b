// SPDX-License-Identifier: MIT
#include "study/measures.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "image/metrics.h"
#include "image/regions.h"
#include "lab/against_truth.h"
#include "math/statistics.h"

namespace strobe::study {

namespace {

using image::Image;

constexpr double kNothing = std::numeric_limits<double>::quiet_NaN();

// ---- against truth

// RMSE of truth is its own standard error. RMSE of a floor includes truth's variance, so that no method seems better
// than the floor.
double rmse(const Sight& sight, const Region& in) {
  double own = sight.truth->sigma.at(in.name);
  if (sight.role == ArmRole::truth) return own;
  double mse = image::meanSquaredError(sight.color, sight.truth->color, in.mask);
  return std::sqrt(mse + (sight.role == ArmRole::floor ? own * own : 0));
}

double rmseFull(const Sight& sight, const Region& in) {
  if (sight.truth->full.empty()) return kNothing;
  return image::rootMeanSquaredError(sight.color, sight.truth->full, in.mask);
}

double flip(const Sight& sight, const Region& in) { return image::meanOf(sight.flip(), in.mask); }
double hdrFlip(const Sight& sight, const Region& in) { return image::meanOf(sight.hdrFlip(), in.mask); }

double relmse(const Sight& sight, const Region& in) {
  return image::relativeMse(sight.color, sight.truth->color, in.mask);
}
double mse(const Sight& sight, const Region& in) { return std::pow(rmse(sight, in), 2); }
double relmseTrimmed(const Sight& sight, const Region& in) {
  return image::trimmedRelativeMse(sight.color, sight.truth->color, in.mask);
}
double msSsim(const Sight& sight, const Region&) {
  return image::multiScaleSsim(sight.color, sight.truth->color).value_or(kNothing);
}
double flipMax(const Sight& sight, const Region& in) { return image::largestOf(sight.flip(), in.mask); }
double hdrFlipMax(const Sight& sight, const Region& in) { return image::largestOf(sight.hdrFlip(), in.mask); }
double smape(const Sight& sight, const Region& in) { return image::smape(sight.color, sight.truth->color, in.mask); }
double psnr(const Sight& sight, const Region& in) { return image::psnr(sight.color, sight.truth->color, in.mask); }
double ssim(const Sight& sight, const Region& in) {
  return image::ssim(sight.color, sight.truth->color, in.mask).value_or(kNothing);
}

// Error of each pixel of `mask`: the root mean square over its channels of the difference from truth.
std::vector<double> errorsOf(const Sight& sight, const Image& mask) {
  std::vector<double> errors;
  image::forPixels(sight.color, mask, [&](int x, int y) {
    double squares = 0;
    for (int c = 0; c < 3; ++c)
      squares += std::pow(double(sight.color.at(x, y, c)) - sight.truth->color.at(x, y, c), 2);
    errors.push_back(std::sqrt(squares / 3));
  });
  return errors;
}

// Output `error` at each pixel of `mask`, the method's own estimate of its error; empty without this output.
std::vector<double> estimatesOf(const Sight& sight, const Image& mask) {
  std::vector<double> estimates;
  auto output = sight.picture->frame.outputs.find("error");
  if (output == sight.picture->frame.outputs.end()) return estimates;
  image::forPixels(sight.color, mask, [&](int x, int y) { estimates.push_back(output->second.floats.at(x, y, 0)); });
  return estimates;
}

double p999(const Sight& sight, const Region& in) { return quantile(errorsOf(sight, in.mask), 0.999); }

double errorMean(const Sight& sight, const Region& in) { return mean(errorsOf(sight, in.mask)); }
double errorEstimate(const Sight& sight, const Region& in) { return mean(estimatesOf(sight, in.mask)); }
double estimateRank(const Sight& sight, const Region& in) {
  return rankCorrelation(estimatesOf(sight, in.mask), errorsOf(sight, in.mask));
}

double flicker(const Sight& sight, const Region& in) {
  if (!sight.before) return kNothing;
  return image::temporalError(sight.before->color, sight.color, sight.before->truth->color, sight.truth->color,
                              in.mask);
}

double pixels(const Sight& sight, const Region& in) { return double(image::countedPixels(sight.color, in.mask)); }

double msRatio(const Sight& sight, const Region&) { return median(ratiosOf(sight.times_ms, sight.base_ms)); }
double ownRatio(const Sight& sight, const Region&) { return median(ratiosOf(sight.own_ms, sight.own_base_ms)); }

// ---- of the picture alone

double contrast(const Sight& sight, const Region&) { return image::contrast(sight.color); }

double broken(const Sight& sight, const Region&) { return double(image::notFiniteIn(sight.color).pixels); }

bool isFinite(const Image& image) { return image::notFiniteIn(image).pixels == 0; }

// True if the measure has a meaningful value; `finite`: the colours of the picture and its truth are finite.
bool isDefined(const Measure& measure, const Sight& sight, bool finite) {
  if (measure.of_any || measure.is_time) return true;
  bool benign = !measure.is_change || !sight.benign || isFinite(*sight.benign);
  bool before =
      !measure.of_sequence || !sight.before || (isFinite(sight.before->color) && isFinite(sight.before->truth->color));
  return finite && benign && before;
}

// Entry of the registry for a measure that does not use colours.
Measure ofAny(Measure measure) {
  measure.of_any = true;
  return measure;
}

double clamped(const Sight& sight, const Region&) {
  uint64_t most = 0;
  for (uint64_t count : lab::countsOf(sight.picture->record, "clamped")) most = std::max(most, count);
  return double(most);
}

double rays(const Sight& sight, const Region&) {
  std::vector<uint64_t> counts = lab::countsOf(sight.picture->record, "rays_");
  return double(std::accumulate(counts.begin(), counts.end(), uint64_t{0}));
}

// Number of pixels that the output `mask` marks.
double masked(const Sight& sight, const Region&) {
  auto mask = sight.picture->frame.outputs.find("mask");
  if (mask == sight.picture->frame.outputs.end()) return kNothing;
  const std::vector<float>& values = mask->second.floats.values;
  return double(std::count_if(values.begin(), values.end(), [](float value) { return value >= 0.5f; }));
}

double displacement(const Sight& sight, const Region&) { return lab::displacementOf(*sight.picture); }

// ---- against the benign value

double change(const Sight& sight, const Region&) {
  return sight.benign ? image::largestDifference(sight.color, *sight.benign).value : kNothing;
}

double changed(const Sight& sight, const Region&) {
  if (!sight.benign) return kNothing;
  return image::countDifferent(sight.color, *sight.benign, 1e-5) / (double(sight.color.width) * sight.color.height);
}

double changeRms(const Sight& sight, const Region& in) {
  return sight.benign ? image::rootMeanSquaredError(sight.color, *sight.benign, in.mask) : kNothing;
}

// ---- background

// Contrast of the background over the region inner, for an arm that computes the background.
struct Behind {
  double deviation = kNothing, difference = kNothing, pixels = 0;
};

Behind behind(const Sight& sight) {
  Behind result;
  auto inner = sight.truth->masks.find("inner");
  if (!sight.front || inner == sight.truth->masks.end()) return {kNothing, kNothing, kNothing};
  Image back = image::threeChannels(sight.picture->frame.outputs.at(sight.background->color).floats);
  const Image& valid = sight.picture->frame.outputs.at(sight.background->valid).floats;
  std::array<double, 3> sum{}, squares{};
  double difference = 0;
  for (int y = 0; y < back.height; ++y)
    for (int x = 0; x < back.width; ++x) {
      if (valid.at(x, y, 0) < 0.5f || inner->second.at(x, y, 0) < 0.5f) continue;
      ++result.pixels;
      for (int c = 0; c < 3; ++c) {
        double b = back.at(x, y, c);
        sum[size_t(c)] += b;
        squares[size_t(c)] += b * b;
        difference += std::abs(sight.front->at(x, y, c) - b);
      }
    }
  if (result.pixels == 0) return result;
  double n = result.pixels, variance = 0;
  for (size_t c = 0; c < 3; ++c) variance += std::max(0.0, squares[c] / n - sum[c] / n * (sum[c] / n));
  result.deviation = std::sqrt(variance / 3);
  result.difference = difference / (3 * n);
  return result;
}

// ---- cost

double least(const std::vector<double>& values) {
  return values.empty() ? kNothing : *std::min_element(values.begin(), values.end());
}

}  // namespace

const Image& Sight::flip() const {
  if (flip_.empty()) flip_ = image::ldrFlip(color, truth->color);
  return flip_;
}

const Image& Sight::hdrFlip() const {
  if (hdr_flip_.empty()) hdr_flip_ = image::hdrFlip(color, truth->color, truth->exposures).map;
  return hdr_flip_;
}

std::vector<std::string> regionNames() { return {"whole", "inner", "hidden", "outer", "self", "moving", "edge"}; }

const std::vector<Measure>& measures() {
  constexpr Better kLower = Better::lower, kNeither = Better::neither;
  static const std::vector<Measure> all = {
      {"rmse", "RMSE", "", kLower, true, "root mean square of the difference from truth, linear values", rmse},
      {"mse", "MSE", "", kLower, true, "mean square of the difference from truth, linear values", mse},
      {"flip", "FLIP", "", kLower, true, "mean of the FLIP map against truth, at 67 pixels per degree", flip},
      {"hdr_flip", "HDR-FLIP", "", kLower, true, "mean of the HDR-FLIP map against truth", hdrFlip},
      {"flip_max", "largest FLIP", "", kLower, true, "largest value of the FLIP map", flipMax},
      {"hdr_flip_max", "largest HDR-FLIP", "", kLower, true, "largest value of the HDR-FLIP map", hdrFlipMax},
      {"rmse_full", "RMSE, full shading", "", kLower, true, "RMSE against the second truth (`full`)", rmseFull},
      {"p999", "99.9th percentile", "", kLower, true,
       "error that one pixel in a thousand exceeds; the error of a pixel is the root mean square over its channels",
       p999},
      {"error_mean", "mean error", "", kLower, true,
       "mean over the pixels of the root mean square over the channels of the difference from truth", errorMean},
      {"error_estimate", "estimated error", "", kNeither, true,
       "mean of the output `error`, the method's own estimate of its error; only for methods with this output",
       errorEstimate},
      {"estimate_rank", "rank correlation", "", Better::higher, true,
       "Spearman's rank correlation over the pixels of the output `error` with the error against truth", estimateRank},
      {"relmse", "relMSE", "", kLower, true, "mean of the squared difference divided by squared truth + 0.01", relmse},
      {"relmse_trimmed", "relMSE, trimmed", "", kLower, true, "relMSE without the worst thousandth of the pixels",
       relmseTrimmed},
      {"smape", "SMAPE", "", kLower, true,
       "mean of the absolute difference divided by the sum of both magnitudes + 0.01", smape},
      {"psnr", "PSNR", "dB", Better::higher, true, "peak signal-to-noise ratio of the clamped, sRGB-encoded values",
       psnr},
      {"ssim", "SSIM", "", Better::higher, true,
       "structural similarity (Wang et al. 2004) of the clamped, sRGB-encoded values", ssim},
      {"ms_ssim", "MS-SSIM", "", Better::higher, false,
       "multi-scale structural similarity (Wang, Simoncelli, Bovik 2003) of the whole picture; no value if a side is "
       "below 176 px",
       msSsim},
      {"flicker", "flicker", "", kLower, true,
       "mean absolute difference between the picture's change from frame to frame and truth's change", flicker, false,
       false, false, true},
      {"ms", "time", "ms", kLower, false, "median time of a frame on the device, without the first frame",
       [](const Sight& s, const Region&) { return median(s.times_ms); }, true},
      {"ms_least", "least time", "ms", kLower, false, "least time of a frame on the device",
       [](const Sight& s, const Region&) { return least(s.times_ms); }, true},
      {"ms_low", "lower quartile", "ms", kNeither, false, "25th percentile of the times of a frame",
       [](const Sight& s, const Region&) { return quantile(s.times_ms, 0.25); }, true},
      {"ms_high", "upper quartile", "ms", kNeither, false, "75th percentile of the times of a frame",
       [](const Sight& s, const Region&) { return quantile(s.times_ms, 0.75); }, true},
      {"ms_ratio", "time ratio", "", kLower, false,
       "median over the rounds of a frame's time divided by the base's time in the same round", msRatio, true, false,
       true},
      {"ms_own", "own time", "ms", kLower, false,
       "median time of the passes of a frame that the pipeline without blur does not have",
       [](const Sight& s, const Region&) { return median(s.own_ms); }, true},
      {"own_ratio", "own time ratio", "", kLower, false,
       "median over the rounds of `ms_own` divided by the `ms_own` of the base in the same round", ownRatio, true,
       false, true},
      ofAny({"memory", "memory", "MiB", kLower, false, "memory of all images that a frame holds at once",
             [](const Sight& s, const Region&) { return double(s.bytes) / (1 << 20); }}),
      ofAny({"bytes", "bytes per pixel", "B", kLower, false,
             "memory of all images that a frame holds at once, per pixel of the picture",
             [](const Sight& s, const Region&) { return double(s.bytes) / (double(s.color.width) * s.color.height); }}),
      ofAny({"rays", "rays", "", kLower, false,
             "rays traced for the picture: for disoccluded surfaces, shadows and truth", rays}),
      ofAny({"masked", "masked", "px", kLower, false,
             "pixels of the output `mask`: pixels where the method needs a background", masked}),
      ofAny(
          {"clamped", "clamped", "px", kLower, false, "pixels whose displacement was shortened to the limit", clamped}),
      ofAny({"broken", "not finite", "px", kLower, false, "pixels with a colour that is not a finite number", broken}),
      ofAny({"pixels", "pixels", "px", kNeither, true, "pixels of the region", pixels}),
      {"contrast", "contrast", "", kNeither, false,
       "standard deviation of the colours: root mean square over the channels", contrast},
      ofAny({"displacement", "displacement", "px", kNeither, false,
             "median length of the displacement over the moving pixels", displacement}),
      {"change", "largest change", "", kLower, false,
       "largest difference of any channel from the same arm's picture at the benign value", change, false, true},
      {"changed", "changed pixels", "", kLower, false,
       "share of the pixels that differ from the picture at the benign value by more than 1e-5", changed, false, true},
      {"change_rms", "change", "", kLower, true, "RMS of the difference from the picture at the benign value",
       changeRms, false, true},
      {"background_deviation", "deviation of the background", "", kNeither, false,
       "standard deviation of the background in the inner blur, from the arm that computes the background",
       [](const Sight& s, const Region&) { return behind(s).deviation; }},
      {"background_difference", "difference of the background", "", kNeither, false,
       "mean difference of the background from the foreground in the inner blur",
       [](const Sight& s, const Region&) { return behind(s).difference; }},
      {"background_pixels", "known background", "px", kNeither, false,
       "pixels of the inner blur with a known background",
       [](const Sight& s, const Region&) { return behind(s).pixels; }},
  };
  return all;
}

std::vector<std::string> measureNames() {
  std::vector<std::string> names;
  for (const Measure& measure : measures()) names.push_back(measure.name);
  return names;
}

const Measure& measureNamed(const std::string& name) {
  auto found = std::find_if(measures().begin(), measures().end(), [&](const Measure& m) { return m.name == name; });
  STROBE_ASSERT(found != measures().end(), "{}", name);
  return *found;
}

Values measured(const Sight& sight, const std::vector<std::string>& names, const std::vector<std::string>& regions) {
  Values values;
  const bool finite = isFinite(sight.color) && (!sight.truth || isFinite(sight.truth->color));
  for (const std::string& name : names) {
    const Measure& measure = measureNamed(name);
    const bool is_defined = isDefined(measure, sight, finite);
    auto put = [&](const Region& in) {
      double value = is_defined ? measure.of(sight, in) : kNothing;
      if (!is_defined || !std::isnan(value)) values[name][in.name] = value;
    };
    if (!measure.per_region) put({"all", {}});
    for (const std::string& region : measure.per_region ? regions : std::vector<std::string>())
      put({region, sight.truth->masks.at(region)});
  }
  return values;
}

}  // namespace strobe::study
