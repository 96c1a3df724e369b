// SPDX-License-Identifier: MIT
#include "figure/captions.h"

#include <cmath>

#include "image/flip.h"
#include "image/metrics.h"
#include "lab/against_truth.h"
#include "page/number.h"

namespace strobe::figure {

namespace {

using image::Image;

std::string written(double value, const CaptionPart& part, const std::string& otherwise) {
  if (std::isnan(value)) return page::kNotMeasured;
  if (part.style == 'f') return fmt::format("{:.{}f}", value, part.digits);
  if (part.style == 'g') return fmt::format("{:.{}g}", value, part.digits);
  return otherwise;
}

struct CaptionMeasure {
  const char* name;
  double (*of)(const Image& color, const Image& truth, const Image& mask);
  std::string (*written)(double value);
};

std::string decibels(double value) { return fmt::format("{:.2f} dB", value); }
std::string similarity(double value) { return fmt::format("{:.4f}", value); }

// The same measures as in experiments (study/measures.h).
constexpr CaptionMeasure kMeasures[] = {
    {"rmse", image::rootMeanSquaredError, page::shownError},
    {"mse", image::meanSquaredError, page::shownError},
    {"relmse", image::relativeMse, page::shownError},
    {"smape", image::smape, page::shownError},
    {"psnr", image::psnr, decibels},
    {"ssim", [](const Image& c, const Image& t, const Image& m) { return image::ssim(c, t, m).value_or(NAN); },
     similarity},
    {"flip", [](const Image& c, const Image& t, const Image& m) { return image::meanOf(image::ldrFlip(c, t), m); },
     page::shownError},
};

Image colorOf(const Taken& taken) {
  auto found = taken.picture->frame.outputs.find("color");
  if (found == taken.picture->frame.outputs.end())
    throw Error(fmt::format("shot '{}' drawn by '{}' has no colour to measure", taken.shot, taken.arm));
  return image::threeChannels(found->second.floats);
}

std::string measured(const CaptionPart& part, const Taken& taken, const Taken* truth) {
  if (!truth) throw Error(fmt::format("'{}' is measured against truth, but the capture has no truth", part.measure));
  Image mask = regionOf(*truth, part.region);
  if (!mask.empty() && image::countedPixels(mask, mask) == 0) return page::kNotMeasured;
  if (part.measure == "standard_error") {
    double value = lab::sigmaOf(*truth->picture, mask);
    return written(value, part, page::shownError(value));
  }
  if (part.measure == "displacement") {
    double value = lab::displacementOf(*truth->picture);
    return written(value, part, fmt::format("{:.1f} px", value));
  }
  for (const CaptionMeasure& measure : kMeasures) {
    if (part.measure != measure.name) continue;
    Image color = colorOf(taken), reference = colorOf(*truth);
    if (!image::sameSize(color, reference))
      throw Error(fmt::format("'{}' and '{}' differ in size", taken.arm, truth->arm));
    double value = measure.of(color, reference, mask);
    return written(value, part, std::isnan(value) ? page::kNotMeasured : measure.written(value));
  }
  throw Error(fmt::format("unknown measure '{}'", part.measure));
}

std::string textOf(const Json& value, const CaptionPart& part) {
  if (value.is_string()) return value.get<std::string>();
  if (value.is_boolean()) return value.get<bool>() ? "true" : "false";
  if (value.is_number()) return written(value.get<double>(), part, fmt::format("{:.9g}", value.get<double>()));
  std::vector<std::string> texts;
  for (const Json& one : value) texts.push_back(textOf(one, part));
  return fmt::format("{}", fmt::join(texts, part.option == "size" ? "x" : ", "));
}

const Json* memberOf(const Json* table, const std::string& name) {
  return table && table->is_object() && table->contains(name) ? &table->at(name) : nullptr;
}

// Value of "set.PARAM" or "set.NODE.PARAM" of the pipeline, or of "scene.PARAM" that the shot sets; null if it is
// missing.
const Json* settingOf(const Json& record, const std::string& setting) {
  std::string name = setting.substr(setting.find('.') + 1);
  if (setting.starts_with("scene.")) return memberOf(memberOf(memberOf(&record, "shot"), "set"), setting);
  const Json* pipeline = memberOf(&record, "pipeline");
  size_t dot = name.find('.');
  if (dot == std::string::npos) {
    if (name == "preset") return memberOf(pipeline, name);
    return memberOf(memberOf(pipeline, "values"), name);
  }
  return memberOf(memberOf(memberOf(pipeline, "nodes"), name.substr(0, dot)), name.substr(dot + 1));
}

std::string filledIn(const CaptionPart& part, const Taken& taken, const std::function<const Taken*()>& truth) {
  if (!part.measure.empty()) return measured(part, taken, truth());
  const Json& record = taken.picture->record;
  if (!part.option.empty()) {
    const Json* value = memberOf(memberOf(&record, "shot"), part.option);
    if (!value) throw Error(fmt::format("shot '{}' has no '{}' in its record", taken.shot, part.option));
    return textOf(*value, part);
  }
  if (!part.setting.empty()) {
    const Json* value = settingOf(record, part.setting);
    if (!value) throw Error(fmt::format("the picture of '{}' has no '{}'", taken.arm, part.setting));
    return textOf(*value, part);
  }
  if (part.word == "shot") return taken.shot;
  if (part.word == "arm") return taken.arm;
  if (part.word == "step") return std::to_string(taken.step);
  return part.text;
}

}  // namespace

Image regionOf(const Taken& truth, const std::string& region) {
  try {
    return lab::maskOf(*truth.picture, region);
  } catch (const Error& error) {
    throw Error(error.message() + ", or its file does not store it: see `layers`");
  }
}

std::string captionOf(const std::vector<CaptionPart>& parts, const Taken& taken,
                      const std::function<const Taken*()>& truth, const Place& place, Problems& problems) {
  std::string caption;
  for (const CaptionPart& part : parts) {
    try {
      caption += filledIn(part, taken, truth);
    } catch (const Error& error) {
      problems.add(place, fmt::format("caption: {}", error.message()));
    }
  }
  return caption;
}

}  // namespace strobe::figure
