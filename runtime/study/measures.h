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

// Input of a measure: a picture and the pictures for comparison.
struct Sight {
  ArmRole role = ArmRole::method;
  const TruthPicture* truth = nullptr;
  const lab::Picture* picture = nullptr;  // outputs and record
  image::Image color;
  const Sight* before = nullptr;         // previous frame of a sequence, or null
  const image::Image* benign = nullptr;  // picture of the same arm at the benign value, or null
  const image::Image* front = nullptr;   // foreground picture; null unless the arm provides the background
  const Background* background = nullptr;
  uint64_t bytes = 0;                       // memory of all images that a frame holds at once
  std::vector<double> times_ms;             // frame times after one warm-up frame
  std::vector<double> base_ms;              // frame times of the base arm in the same rounds
  std::vector<double> own_ms, own_base_ms;  // times of the method's own passes (run.h)

  // Error maps, computed on first use.
  const image::Image& flip() const;
  const image::Image& hdrFlip() const;

 private:
  mutable image::Image flip_, hdr_flip_;
};

// Pixels that a measure covers.
struct Region {
  std::string name;
  const image::Image& mask;  // empty: every pixel
};

// Direction in which a measure improves: lower (errors, times), higher (PSNR, SSIM), or neither.
enum class Better { lower, higher, neither };

// Measured quantity of a picture, such as RMSE or frame time: name, unit, direction of improvement and function.
struct Measure {
  std::string name, title, unit;
  Better better = Better::lower;
  bool per_region = false;
  std::string doc;  // how it is computed
  // NaN: not measured. Only a measure `per_region` uses the region. The value of a sequence is the mean over its
  // frames.
  double (*of)(const Sight& sight, const Region& region) = nullptr;
  bool is_time = false;      // measured on additional frames, not on the picture
  bool is_change = false;    // compared with the benign value
  bool to_base = false;      // ratio to the value of the base arm
  bool of_sequence = false;  // needs at least two frames
  bool of_any = false;       // measured even if colours are not finite, as times are
};

const std::vector<Measure>& measures();
std::vector<std::string> measureNames();
const Measure& measureNamed(const std::string& name);  // asserts that the name exists

// Values by measure and region; the region is "all" for a measure that is not per region. Values that were not measured
// are left out. Colours that are not finite, in the picture or in truth, make a value NaN.
using Values = std::map<std::string, std::map<std::string, double>>;
Values measured(const Sight& sight, const std::vector<std::string>& names, const std::vector<std::string>& regions);

}  // namespace strobe::study
