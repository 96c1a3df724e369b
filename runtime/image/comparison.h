// SPDX-License-Identifier: MIT
// All error metrics of a pair of images at once: what the command line, sweeps and reports show.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/files.h"
#include "base/json_fwd.h"
#include "image/flip.h"
#include "image/image.h"

namespace strobe::image {

// A rectangle of pixels; x and y point right and down.
struct Window {
  int x = 0, y = 0, width = 0, height = 0;
};

// A picture from a file, recognised by its first bytes, not its name.
struct Picture {
  Image linear;                    // RGB, Rec. 709: the pixels of the data window
  bool hdr = false;                // an OpenEXR file
  Window data;                     // by the display window, which it may exceed
  Window display;                  // begins at 0,0
  std::vector<std::string> notes;  // stated colour and windows, and their treatment
};

// `layer` picks the colour of an OpenEXR layer and is refused for a PNG. Throws `Error` naming the file, also for a
// value that is not finite (with its pixel).
Picture readPicture(const Path& file, const std::string& layer = "");

// One channel, as metrics.h takes it: red (or the only channel) of a PNG or OpenEXR file, not decoded from sRGB.
Picture readMask(const Path& file);

// Puts pictures over each other by their display windows. If their data windows differ, both get the pixels that either
// shows, black outside of its own data window; its notes say so. An empty mask selects all pixels; a mask of the
// compared size applies to those. Throws `Error` with the windows if display windows differ in size, or if a picture
// shows nothing.
void alignPictures(Picture& test, Picture& reference, Picture& mask);

struct CompareOptions {
  bool hdr = true;  // HDR-FLIP too
  HdrFlipOptions flip;
};

// Absent values could not be measured: SSIM of an image smaller than its window, HDR-FLIP when it was not requested.
struct Comparison {
  double mse = 0, rmse = 0, psnr = 0, relmse = 0, relmse_trimmed = 0, smape = 0;
  std::optional<double> ssim, ms_ssim;  // ms_ssim takes no mask and is absent with one
  double ldr_flip = 0, ldr_flip_max = 0;
  std::optional<double> hdr_flip, hdr_flip_max;
  Exposures exposures;     // of hdr_flip
  Image ldr_map, hdr_map;  // error maps of the whole image
  size_t pixels = 0;       // that counted
};

// Linear colour of the same size; `mask` as in metrics.h (empty: all). Throws `Error` when sizes differ or no pixel
// counts.
Comparison compareImages(const Image& test, const Image& reference, const Image& mask = {},
                         const CompareOptions& options = {});

// Keys mse rmse psnr relmse relmse_trimmed smape ssim ms_ssim ldr_flip ldr_flip_max hdr_flip hdr_flip_max, with HDR
// also hdr_flip_start, hdr_flip_stop, hdr_flip_exposures, hdr_flip_source; pixels. What is absent is null; the PSNR of
// identical images is the string "inf".
Json comparisonJson(const Comparison& comparison);

}  // namespace strobe::image
