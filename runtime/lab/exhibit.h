// SPDX-License-Identifier: MIT
// A demo rendered and measured: every column of every shot against truth of the same anchor.
#pragma once

#include <functional>
#include <map>

#include "image/flip.h"
#include "lab/demo.h"
#include "lab/workbench.h"

namespace strobe::lab {

// Against truth, over one region; NaN: not measured. Of a floor: sqrt(mean squared difference + truth's variance);
// of truth: its own standard error.
struct Errors {
  double rmse, flip, hdr_flip;
  double full_rmse;  // against truth shaded at each time
};

// One column in one anchor.
struct Entry {
  const DemoColumn* column = nullptr;
  std::map<std::string, Errors> errors;  // by region
  std::optional<double> ms;              // GPU time of a frame, the second of two
  uint64_t clamped = 0;                  // pixels whose displacement was shortened
  image::Image color;                    // linear, one sample per pixel at its centre: what is measured
  image::Image shown;                    // linear, what people look at
  Json record, timings;
  std::vector<Path> files;
};

// All columns measured against one truth.
struct Group {
  std::string anchor;
  std::map<std::string, image::Image> masks;  // by region; "whole" is empty
  std::map<std::string, size_t> pixels;
  image::Exposures exposures;  // of HDR-FLIP, from the truth
  std::vector<Entry> entries;  // in the order of the demo's columns

  const Entry* find(const std::string& label) const;
  const Entry& truth() const;
  const Entry* floor() const;  // nullptr: there is none
};

// How much of what is behind can tell good from bad: over the inner blur, where it is known.
struct Contrast {
  double deviation = 0;   // standard deviation of the background, root mean square of the channels
  double difference = 0;  // mean |front - background|
  size_t pixels = 0;
};

// Whether an expectation applies and holds, in words and numbers.
struct Verdict {
  bool applies = false, holds = false;
  std::string text;
};

struct ShotResult {
  const DemoShot* shot = nullptr;  // `missing` says why the rest is empty
  Shot resolved;                   // with what the scene supplied
  std::vector<Group> groups;       // the shot's own anchor first
  double displacement_px = 0;      // median over the instances that move in the picture
  std::vector<image::Rectangle> crops;
  std::optional<Contrast> contrast;
  std::optional<Verdict> verdict;
  std::string attribution;
};

struct Exhibition {
  const Demo* demo = nullptr;  // outlives this
  gpu::DeviceInfo device;
  std::vector<ShotResult> shots;
  double render_s = 0;  // wall clock
};

// Renders everything and writes pictures and records below `folder` as it goes; progress on stderr. The demo's size
// may have been changed since it was read: crops follow `file_width` x `file_height`.
Exhibition exhibit(const Demo& demo, Workbench& bench, const Path& folder, int file_width, int file_height);

}  // namespace strobe::lab
