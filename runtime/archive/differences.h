// SPDX-License-Identifier: MIT
// How two manifests differ, and why: inputs, parameters and who set them, program, device, and the first pass in the
// order of execution whose output is another.
#pragma once

#include "archive/manifest.h"

namespace strobe::archive {

struct InputDifference {
  enum class Kind { altered, missing, added };
  Kind kind = Kind::altered;
  std::string name;
  int line = 0;         // the first that differs, from 1; 0 where the texts are not kept
  std::string was, is;  // that line
};

// Of two images of one size.
struct ImageDifference {
  std::string image;                     // "color", "node.port"
  bool is_kept = true;                   // both folders have the texels; without them nothing below is known
  double largest = 0, mean = 0;          // absolute, over all numbers; infinite where one of two is not finite
  double largest_ulp = 0, mean_ulp = 0;  // in representable single-precision numbers; of integers as `largest`
  uint64_t pixels = 0;                   // that differ in any channel
  int x = 0, y = 0, channel = 0;         // the first that does, row by row from the top
  double was = 0, is = 0;                // its values
  std::optional<double> flip;            // mean HDR-FLIP, of the color
};

struct PictureDifference {
  std::string name;
  std::vector<std::string> parameters;  // "samples of pipeline: 15 (default), now 8 (capture)"
  bool same_plan = true;
  int passes = 0;                        // whose outputs differ
  std::string node, pass, shader;        // the first of them
  std::optional<ImageDifference> first;  // what differs there
  std::vector<ImageDifference> layers;   // those of the file that differ

  bool isImage() const { return passes > 0 || !layers.empty(); }
};

struct Differences {
  std::vector<std::string> program, device;  // "name: 'llvmpipe ...', now '...'"
  std::vector<InputDifference> inputs;
  std::vector<std::string> missing, added;  // pictures
  std::vector<PictureDifference> pictures;  // those that differ in anything
  std::vector<std::string> files;           // figures and films that differ

  bool sameDevice() const { return device.empty(); }
  // Every output of every pass, every layer, figure and film is the same bit for bit.
  bool identical() const;
  // The same but for colours, whose mean FLIP is at most `most_flip` in every picture.
  bool within(double most_flip) const;
};

// Of `now` to `stated`. Writes a picture of the first difference of each picture to `folder`, unless that is empty.
Differences differencesOf(const Manifest& stated, const Manifest& now, const Path& folder = {});

std::string textOf(const Differences& differences);
Json toJson(const Differences& differences);

// Two images of one format and size.
ImageDifference compared(const std::string& name, const graph::ReadImage& was, const graph::ReadImage& is);

}  // namespace strobe::archive
