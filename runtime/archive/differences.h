// SPDX-License-Identifier: MIT
// Differences of two manifests and their causes: inputs, parameters and their origins, program, device, and the first
// pass in the order of execution with a different output.
#pragma once

#include "archive/manifest.h"

namespace strobe::archive {

// An input file that was altered, is missing or was added between two captures, with the first line that differs.
struct InputDifference {
  enum class Kind { altered, missing, added };
  Kind kind = Kind::altered;
  std::string name;
  int line = 0;         // first different line, from 1; 0 if the texts are not kept
  std::string was, is;  // text of the line
};

// Difference of two images of one size.
struct ImageDifference {
  std::string image;                     // "color", "node.port"
  bool is_kept = true;                   // both folders have the texels; if false, the following fields are not set
  double largest = 0, mean = 0;          // absolute, over all numbers; infinite if one of the two is not finite
  double largest_ulp = 0, mean_ulp = 0;  // in units in the last place of single precision; for integers as `largest`
  uint64_t pixels = 0;                   // pixels that differ in any channel
  int x = 0, y = 0, channel = 0;         // first number that differs, row by row from the top
  double was = 0, is = 0;                // values of that number
  std::optional<double> flip;            // mean HDR-FLIP of the color
};

// Differences of one picture between two captures: parameters, the first pass with a different output, and layers of
// its file.
struct PictureDifference {
  std::string name;
  std::vector<std::string> parameters;  // "samples of pipeline: 15 (default), now 8 (capture)"
  bool same_plan = true;
  int passes = 0;                        // number of passes with different outputs
  std::string node, pass, shader;        // the first such pass
  std::optional<ImageDifference> first;  // first difference of that pass
  std::vector<ImageDifference> layers;   // layers of the file that differ

  bool isImage() const { return passes > 0 || !layers.empty(); }
};

// All differences between two captures: program, device, input files, pictures, figures and films.
struct Differences {
  std::vector<std::string> program, device;  // "name: 'llvmpipe ...', now '...'"
  std::vector<InputDifference> inputs;
  std::vector<std::string> missing, added;  // pictures
  std::vector<PictureDifference> pictures;  // pictures with any difference
  std::vector<std::string> files;           // figures and films that differ

  bool sameDevice() const { return device.empty(); }
  // True if no picture is missing and every output of every pass, every layer, figure and film is the same bit for bit.
  bool identical() const;
  // True if no picture is missing and the mean FLIP of every color is at most `most_flip`.
  bool within(double most_flip) const;
};

// Differences of `now` from `stated`. Writes a map of the first difference of each picture to `folder`, unless `folder`
// is empty.
Differences differencesOf(const Manifest& stated, const Manifest& now, const Path& folder = {});

std::string textOf(const Differences& differences);
Json toJson(const Differences& differences);

// Compares two images of one format and size.
ImageDifference compared(const std::string& name, const graph::ReadImage& was, const graph::ReadImage& is);

}  // namespace strobe::archive
