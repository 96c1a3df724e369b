// SPDX-License-Identifier: MIT
// Measures of a picture. A measure is one entry of the registry in measures.cpp; its name, unit and tables, reports and
// checks of experiment files follow from the entry.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "image/flip.h"
#include "lab/workbench.h"
#include "study/experiment.h"

namespace strobe::study {

// "whole", masks that truth computes, and masks that follow from the raster image.
std::vector<std::string> regionNames();

// Data of a truth for the measures of all its points.
struct TruthPicture {
  image::Image color;
  std::map<std::string, image::Image> masks;  // by region; "whole" is empty
  std::map<std::string, double> sigma;        // truth's standard error by region
  image::Image full;                          // colour of the second truth; empty without a second truth
  image::Exposures exposures;                 // for HDR-FLIP
};

// Input of a measure of a picture: the picture and the pictures for comparison.
struct MeasureInput {
  ArmRole role = ArmRole::method;
  const TruthPicture* truth = nullptr;
  const lab::Picture* picture = nullptr;  // outputs and record
  image::Image color;
  const MeasureInput* before = nullptr;  // previous frame of a sequence, or null
  const image::Image* benign = nullptr;  // picture of the same arm at the benign value, or null
  const image::Image* front = nullptr;   // foreground picture; null unless the arm provides the background
  const Background* background = nullptr;
  uint64_t bytes = 0;  // memory of all images that a frame holds at once

  // Error maps, computed on first use.
  const image::Image& flip() const;
  const image::Image& hdrFlip() const;

 private:
  mutable image::Image flip_, hdr_flip_;
};

// Input of a measure of times: milliseconds by round, after one warm-up frame.
struct TimesInput {
  std::vector<double> frame_ms, base_ms;    // of the arm and of the base arm
  std::vector<double> own_ms, own_base_ms;  // of the method's own passes (run.h)
};

// Pixels that a measure covers.
struct Region {
  std::string name;
  const image::Image& mask;  // empty: every pixel
};

// Direction in which a measure improves: lower (errors, times), higher (PSNR, SSIM), or neither.
enum class Better { lower, higher, neither };

// Images that a measure of a picture depends on. If the colours of one of these are not finite, the value is NaN.
enum class Needs { nothing, colours, benign, before };

// Properties of a measure that have usual values.
struct MeasureTraits {
  std::string unit;
  Better better = Better::lower;
  Needs needs = Needs::colours;
  bool to_base = false;  // ratio to the value of the base arm
};

// Measured quantity of a picture, such as RMSE, or of times: name, properties, and one of two functions, which return
// NaN if nothing was measured.
struct Measure : MeasureTraits {
  using OfPicture = double (*)(const MeasureInput& input, const Region& region);
  using OfTimes = double (*)(const TimesInput& times);

  std::string name, title, doc;    // `doc`: how it is computed
  bool per_region = false;         // has a value per region; other measures ignore the region
  OfPicture of_picture = nullptr;  // the value of a sequence is the mean over its frames
  OfTimes of_times = nullptr;      // times are measured on additional frames

  bool isTime() const { return of_times; }
};

const std::vector<Measure>& measures();
std::vector<std::string> measureNames();
const Measure& measureNamed(const std::string& name);  // asserts that the name exists

// Values by measure and region; the region is "all" for a measure that is not per region. Values that were not measured
// are left out.
using Values = std::map<std::string, std::map<std::string, double>>;
// Values of the measures of pictures among `names`.
Values measured(const MeasureInput& input, const std::vector<std::string>& names,
                const std::vector<std::string>& regions);

}  // namespace strobe::study
