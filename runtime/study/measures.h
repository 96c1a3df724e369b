// SPDX-License-Identifier: MIT
// What can be measured of a picture. A measure is one entry of the registry in measures.cpp; names, units, tables,
// reports and the checks of experiment files follow from it.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "image/flip.h"
#include "lab/workbench.h"
#include "study/experiment.h"

namespace strobe::study {

// "whole", the masks that truth marks, and those that follow from the raster image.
std::vector<std::string> regionNames();

// What the measures of one truth's points share.
struct TruthPicture {
  image::Image color;
  std::map<std::string, image::Image> masks;  // by region; "whole" is empty
  std::map<std::string, double> sigma;        // truth's standard error by region
  image::Image full;                          // of the second truth; empty: there is none
  image::Exposures exposures;                 // of HDR-FLIP
};

// One picture and what it is held against.
struct Sight {
  Role role = Role::method;
  const TruthPicture* truth = nullptr;
  const lab::Picture* picture = nullptr;  // outputs and record
  image::Image color;
  const Sight* before = nullptr;         // of the frame before in a sequence; null: there is none
  const image::Image* benign = nullptr;  // of the same arm at the benign value; null: there is none
  const image::Image* front = nullptr;   // of the background's `front` arm; null: this is not what knows the background
  const Background* background = nullptr;
  uint64_t bytes = 0;                       // of all images that a frame holds at once
  std::vector<double> times_ms;             // of frames drawn after one to warm up
  std::vector<double> base_ms;              // of the base arm's frames in the same rounds
  std::vector<double> own_ms, own_base_ms;  // of the passes alone that are the method's own (own.h)

  // Error maps, made when they are first asked for.
  const image::Image& flip() const;
  const image::Image& hdrFlip() const;

 private:
  mutable image::Image flip_, hdr_flip_;
};

enum class Better { lower, higher, neither };

struct Measure {
  std::string name, title, unit;
  Better better = Better::lower;
  bool per_region = false;
  std::string doc;  // how it is computed
  // NaN: not measured. `mask` is that of `region` (empty: every pixel); both without meaning unless per region.
  // Of a sequence it is the mean over the frames.
  double (*of)(const Sight& sight, const std::string& region, const image::Image& mask) = nullptr;
  bool is_time = false;      // of frames that are drawn for it, not of the picture
  bool is_change = false;    // compared with the benign value
  bool to_base = false;      // a ratio to what the base measures
  bool of_sequence = false;  // needs two frames at least
  bool of_any = false;       // measured of a picture with colours that are not finite, too; times are
};

const std::vector<Measure>& measures();
std::vector<std::string> measureNames();
const Measure& measureNamed(const std::string& name);  // asserts that there is one

// Values by region, "all" for a measure that is not per region. Values that were not measured are left out. Colours of
// the picture or of truth that are not finite make a value NaN.
using Values = std::map<std::string, std::map<std::string, double>>;
Values measured(const Sight& sight, const std::vector<std::string>& names, const std::vector<std::string>& regions);

}  // namespace strobe::study
