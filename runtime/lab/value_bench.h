// SPDX-License-Identifier: MIT
// What values of parameters change in a picture, and what they cost in memory and time.
#pragma once

#include "image/image.h"
#include "lab/session.h"

namespace strobe::lab {

// "color_format=fp16,tile=20": settings that are tried together.
std::vector<std::pair<std::string, std::string>> settingsOf(const std::string& text);

// One shot with other values.
struct ValueCost {
  std::string settings;      // "" for the shot as it is
  uint64_t image_bytes = 0;  // of all images of a frame, as they share memory
  double bytes_per_pixel = 0;
  double gpu_ms = 0;   // median over the rounds
  double rms = 0;      // of the colour's difference from the shot as it is, over pixels and channels
  double largest = 0;  // channel of any pixel
  int largest_x = 0, largest_y = 0;
  std::optional<double> error;             // root mean square of the difference from a reference
  std::map<std::string, uint64_t> limits;  // counts of passes that say what they did to the picture, where not 0
};

// The shot as it is, then with each of the settings. All are drawn in turns, one after the other, `rounds` times, so
// that any other load of the machine meets them alike; a first round, in which shaders are compiled, does not count.
std::vector<ValueCost> benchValues(Workbench& bench, const Shot& shot, const std::vector<std::string>& settings,
                                   int rounds, const image::Image& reference = {});

// A Markdown table.
std::string tableOf(const std::vector<ValueCost>& costs);
Json jsonOf(const std::vector<ValueCost>& costs);

}  // namespace strobe::lab
