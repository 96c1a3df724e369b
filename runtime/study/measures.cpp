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
double rmse(const MeasureInput& input, const Region& in) {
  double own = input.truth->sigma.at(in.name);
  if (input.role == ArmRole::truth) return own;
  double mse = image::meanSquaredError(input.color, input.truth->color, in.mask);
  return std::sqrt(mse + (input.role == ArmRole::floor ? own * own : 0));
}

double rmseFull(const MeasureInput& input, const Region& in) {
  if (input.truth->full.empty()) return kNothing;
  return image::rootMeanSquaredError(input.color, input.truth->full, in.mask);
}

// A function of image/metrics.h, applied to the picture and truth.
template <auto kMetric>
double metric(const MeasureInput& input, const Region& in) {
  return kMetric(input.color, input.truth->color, in.mask);
}

// Error of each pixel of `mask`: the root mean square over its channels of the difference from truth.
std::vector<double> errorsOf(const MeasureInput& input, const Image& mask) {
  std::vector<double> errors;
  image::forPixels(input.color, mask, [&](int x, int y) {
    double squares = 0;
    for (int c = 0; c < 3; ++c)
      squares += std::pow(double(input.color.at(x, y, c)) - input.truth->color.at(x, y, c), 2);
    errors.push_back(std::sqrt(squares / 3));
  });
  return errors;
}

// Output `error` at each pixel of `mask`, the method's own estimate of its error; empty without this output.
std::vector<double> estimatesOf(const MeasureInput& input, const Image& mask) {
  std::vector<double> estimates;
  auto output = input.picture->frame.outputs.find("error");
  if (output == input.picture->frame.outputs.end()) return estimates;
  image::forPixels(input.color, mask, [&](int x, int y) { estimates.push_back(output->second.floats.at(x, y, 0)); });
  return estimates;
}

double flicker(const MeasureInput& input, const Region& in) {
  if (!input.before) return kNothing;
  return image::temporalError(input.before->color, input.color, input.before->truth->color, input.truth->color,
                              in.mask);
}

// ---- of the picture alone

bool isFinite(const Image& image) { return image::notFiniteIn(image).pixels == 0; }

// True if the measure has a meaningful value; `finite`: the colours of the picture and its truth are finite.
bool isDefined(const Measure& measure, const MeasureInput& input, bool finite) {
  if (measure.needs == Needs::nothing) return true;
  bool benign = measure.needs != Needs::benign || !input.benign || isFinite(*input.benign);
  bool before = measure.needs != Needs::before || !input.before ||
                (isFinite(input.before->color) && isFinite(input.before->truth->color));
  return finite && benign && before;
}

double clamped(const MeasureInput& input, const Region&) {
  uint64_t most = 0;
  for (uint64_t count : lab::countsOf(input.picture->record, "clamped")) most = std::max(most, count);
  return double(most);
}

double rays(const MeasureInput& input, const Region&) {
  std::vector<uint64_t> counts = lab::countsOf(input.picture->record, "rays_");
  return double(std::accumulate(counts.begin(), counts.end(), uint64_t{0}));
}

// Number of pixels that the output `mask` marks.
double masked(const MeasureInput& input, const Region&) {
  auto mask = input.picture->frame.outputs.find("mask");
  if (mask == input.picture->frame.outputs.end()) return kNothing;
  const std::vector<float>& values = mask->second.floats.values;
  return double(std::count_if(values.begin(), values.end(), [](float value) { return value >= 0.5f; }));
}

// ---- against the benign value

double change(const MeasureInput& input, const Region&) {
  return input.benign ? image::largestDifference(input.color, *input.benign).value : kNothing;
}

double changed(const MeasureInput& input, const Region&) {
  if (!input.benign) return kNothing;
  return image::countDifferent(input.color, *input.benign, 1e-5) / (double(input.color.width) * input.color.height);
}

double changeRms(const MeasureInput& input, const Region& in) {
  return input.benign ? image::rootMeanSquaredError(input.color, *input.benign, in.mask) : kNothing;
}

// ---- background

// Contrast of the background over the region inner, for an arm that computes the background.
struct Behind {
  double deviation = kNothing, difference = kNothing, pixels = 0;
};

Behind behind(const MeasureInput& input) {
  Behind result;
  auto inner = input.truth->masks.find("inner");
  if (!input.front || inner == input.truth->masks.end()) return {kNothing, kNothing, kNothing};
  Image back = image::threeChannels(input.picture->frame.outputs.at(input.background->color).floats);
  const Image& valid = input.picture->frame.outputs.at(input.background->valid).floats;
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
        difference += std::abs(input.front->at(x, y, c) - b);
      }
    }
  if (result.pixels == 0) return result;
  double n = result.pixels, variance = 0;
  for (size_t c = 0; c < 3; ++c) variance += std::max(0.0, squares[c] / n - sum[c] / n * (sum[c] / n));
  result.deviation = std::sqrt(variance / 3);
  result.difference = difference / (3 * n);
  return result;
}

// ---- times

double least(const std::vector<double>& values) {
  return values.empty() ? kNothing : *std::min_element(values.begin(), values.end());
}

// ---- entries of the registry

Measure perRegion(const char* name, const char* title, const char* doc, Measure::OfPicture of,
                  const MeasureTraits& traits = {}) {
  return {traits, name, title, doc, true, of, nullptr};
}
Measure ofPicture(const char* name, const char* title, const char* doc, Measure::OfPicture of,
                  const MeasureTraits& traits = {}) {
  return {traits, name, title, doc, false, of, nullptr};
}
Measure ofTimes(const char* name, const char* title, const char* doc, Measure::OfTimes of,
                const MeasureTraits& traits = {}) {
  return {traits, name, title, doc, false, nullptr, of};
}

}  // namespace

const Image& MeasureInput::flip() const {
  if (flip_.empty()) flip_ = image::ldrFlip(color, truth->color);
  return flip_;
}

const Image& MeasureInput::hdrFlip() const {
  if (hdr_flip_.empty()) hdr_flip_ = image::hdrFlip(color, truth->color, truth->exposures).map;
  return hdr_flip_;
}

std::vector<std::string> regionNames() { return {"whole", "inner", "hidden", "outer", "self", "moving", "edge"}; }

const std::vector<Measure>& measures() {
  using In = const MeasureInput&;
  using At = const Region&;
  using Times = const TimesInput&;
  constexpr Better kNeither = Better::neither, kHigher = Better::higher;
  static const std::vector<Measure> all = {
      perRegion("rmse", "RMSE", "root mean square of the difference from truth, linear values", rmse),
      perRegion("mse", "MSE", "mean square of the difference from truth, linear values",
                [](In in, At at) { return std::pow(rmse(in, at), 2); }),
      perRegion("flip", "FLIP", "mean of the FLIP map against truth, at 67 pixels per degree",
                [](In in, At at) { return image::meanOf(in.flip(), at.mask); }),
      perRegion("hdr_flip", "HDR-FLIP", "mean of the HDR-FLIP map against truth",
                [](In in, At at) { return image::meanOf(in.hdrFlip(), at.mask); }),
      perRegion("flip_max", "largest FLIP", "largest value of the FLIP map",
                [](In in, At at) { return image::largestOf(in.flip(), at.mask); }),
      perRegion("hdr_flip_max", "largest HDR-FLIP", "largest value of the HDR-FLIP map",
                [](In in, At at) { return image::largestOf(in.hdrFlip(), at.mask); }),
      perRegion("rmse_full", "RMSE, full shading", "RMSE against the second truth (`full`)", rmseFull),
      perRegion(
          "p999", "99.9th percentile",
          "error that one pixel in a thousand exceeds; the error of a pixel is the root mean square over its channels",
          [](In in, At at) { return quantile(errorsOf(in, at.mask), 0.999); }),
      perRegion("error_mean", "mean error",
                "mean over the pixels of the root mean square over the channels of the difference from truth",
                [](In in, At at) { return mean(errorsOf(in, at.mask)); }),
      perRegion("error_estimate", "estimated error",
                "mean of the output `error`, the method's own estimate of its error; only for methods with this output",
                [](In in, At at) { return mean(estimatesOf(in, at.mask)); }, {.better = kNeither}),
      perRegion("estimate_rank", "rank correlation",
                "Spearman's rank correlation over the pixels of the output `error` with the error against truth",
                [](In in, At at) { return rankCorrelation(estimatesOf(in, at.mask), errorsOf(in, at.mask)); },
                {.better = kHigher}),
      perRegion("relmse", "relMSE", "mean of the squared difference divided by squared truth + 0.01",
                metric<image::relativeMse>),
      perRegion("relmse_trimmed", "relMSE, trimmed", "relMSE without the worst thousandth of the pixels",
                metric<image::trimmedRelativeMse>),
      perRegion("smape", "SMAPE", "mean of the absolute difference divided by the sum of both magnitudes + 0.01",
                metric<image::smape>),
      perRegion("psnr", "PSNR", "peak signal-to-noise ratio of the clamped, sRGB-encoded values", metric<image::psnr>,
                {.unit = "dB", .better = kHigher}),
      perRegion("ssim", "SSIM", "structural similarity (Wang et al. 2004) of the clamped, sRGB-encoded values",
                [](In in, At at) { return image::ssim(in.color, in.truth->color, at.mask).value_or(kNothing); },
                {.better = kHigher}),
      ofPicture("ms_ssim", "MS-SSIM",
                "multi-scale structural similarity (Wang, Simoncelli, Bovik 2003) of the whole picture; no value if a "
                "side is below 176 px",
                [](In in, At) { return image::multiScaleSsim(in.color, in.truth->color).value_or(kNothing); },
                {.better = kHigher}),
      perRegion("flicker", "flicker",
                "mean absolute difference between the picture's change from frame to frame and truth's change", flicker,
                {.needs = Needs::before}),
      ofTimes("ms", "time", "median time of a frame on the device, without the first frame",
              [](Times times) { return median(times.frame_ms); }, {.unit = "ms"}),
      ofTimes("ms_least", "least time", "least time of a frame on the device",
              [](Times times) { return least(times.frame_ms); }, {.unit = "ms"}),
      ofTimes("ms_low", "lower quartile", "25th percentile of the times of a frame",
              [](Times times) { return quantile(times.frame_ms, 0.25); }, {.unit = "ms", .better = kNeither}),
      ofTimes("ms_high", "upper quartile", "75th percentile of the times of a frame",
              [](Times times) { return quantile(times.frame_ms, 0.75); }, {.unit = "ms", .better = kNeither}),
      ofTimes("ms_ratio", "time ratio",
              "median over the rounds of a frame's time divided by the base's time in the same round",
              [](Times times) { return median(ratiosOf(times.frame_ms, times.base_ms)); }, {.to_base = true}),
      ofTimes("ms_own", "own time", "median time of the passes of a frame that the pipeline without blur does not have",
              [](Times times) { return median(times.own_ms); }, {.unit = "ms"}),
      ofTimes("own_ratio", "own time ratio",
              "median over the rounds of `ms_own` divided by the `ms_own` of the base in the same round",
              [](Times times) { return median(ratiosOf(times.own_ms, times.own_base_ms)); }, {.to_base = true}),
      ofPicture("memory", "memory", "memory of all images that a frame holds at once",
                [](In in, At) { return double(in.bytes) / (1 << 20); }, {.unit = "MiB", .needs = Needs::nothing}),
      ofPicture("bytes", "bytes per pixel", "memory of all images that a frame holds at once, per pixel of the picture",
                [](In in, At) { return double(in.bytes) / (double(in.color.width) * in.color.height); },
                {.unit = "B", .needs = Needs::nothing}),
      ofPicture("rays", "rays", "rays traced for the picture: for disoccluded surfaces, shadows and truth", rays,
                {.needs = Needs::nothing}),
      ofPicture("masked", "masked", "pixels of the output `mask`: pixels where the method needs a background", masked,
                {.unit = "px", .needs = Needs::nothing}),
      ofPicture("clamped", "clamped", "pixels whose displacement was shortened to the limit", clamped,
                {.unit = "px", .needs = Needs::nothing}),
      ofPicture("broken", "not finite", "pixels with a colour that is not a finite number",
                [](In in, At) { return double(image::notFiniteIn(in.color).pixels); },
                {.unit = "px", .needs = Needs::nothing}),
      perRegion("pixels", "pixels", "pixels of the region",
                [](In in, At at) { return double(image::countedPixels(in.color, at.mask)); },
                {.unit = "px", .better = kNeither, .needs = Needs::nothing}),
      ofPicture("contrast", "contrast", "standard deviation of the colours: root mean square over the channels",
                [](In in, At) { return image::contrast(in.color); }, {.better = kNeither}),
      ofPicture("displacement", "displacement", "median length of the displacement over the moving pixels",
                [](In in, At) { return lab::displacementOf(*in.picture); },
                {.unit = "px", .better = kNeither, .needs = Needs::nothing}),
      ofPicture("change", "largest change",
                "largest difference of any channel from the same arm's picture at the benign value", change,
                {.needs = Needs::benign}),
      ofPicture("changed", "changed pixels",
                "share of the pixels that differ from the picture at the benign value by more than 1e-5", changed,
                {.needs = Needs::benign}),
      perRegion("change_rms", "change", "RMS of the difference from the picture at the benign value", changeRms,
                {.needs = Needs::benign}),
      ofPicture("background_deviation", "deviation of the background",
                "standard deviation of the background in the inner blur, from the arm that computes the background",
                [](In in, At) { return behind(in).deviation; }, {.better = kNeither}),
      ofPicture("background_difference", "difference of the background",
                "mean difference of the background from the foreground in the inner blur",
                [](In in, At) { return behind(in).difference; }, {.better = kNeither}),
      ofPicture("background_pixels", "known background", "pixels of the inner blur with a known background",
                [](In in, At) { return behind(in).pixels; }, {.unit = "px", .better = kNeither}),
  };
  return all;
}

std::vector<std::string> measureNames() { return namesOf(measures()); }

const Measure& measureNamed(const std::string& name) {
  auto found = std::find_if(measures().begin(), measures().end(), [&](const Measure& m) { return m.name == name; });
  STROBE_ASSERT(found != measures().end(), "{}", name);
  return *found;
}

Values measured(const MeasureInput& input, const std::vector<std::string>& names,
                const std::vector<std::string>& regions) {
  Values values;
  const bool finite = isFinite(input.color) && (!input.truth || isFinite(input.truth->color));
  for (const std::string& name : names) {
    const Measure& measure = measureNamed(name);
    if (measure.isTime()) continue;
    const bool is_defined = isDefined(measure, input, finite);
    auto put = [&](const Region& in) {
      double value = is_defined ? measure.of_picture(input, in) : kNothing;
      if (!is_defined || !std::isnan(value)) values[name][in.name] = value;
    };
    if (!measure.per_region) put({"all", {}});
    for (const std::string& region : measure.per_region ? regions : std::vector<std::string>())
      put({region, input.truth->masks.at(region)});
  }
  return values;
}

}  // namespace strobe::study
