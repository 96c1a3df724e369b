// SPDX-License-Identifier: MIT
// All error metrics of a pair of images, as shown by the command line, sweeps and reports.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/files.h"
#include "base/json_fwd.h"
#include "image/draw.h"
#include "image/flip.h"

namespace strobe::image {

// Picture from a file. The first bytes of the file decide its format, not its name.
struct ComparedPicture {
  Image linear;                    // RGB, Rec. 709: the pixels of the data window
  bool hdr = false;                // true for an OpenEXR file
  Rectangle data;                  // relative to the display window, which it may exceed
  Rectangle display;               // begins at 0,0
  std::vector<std::string> notes;  // colour and windows stated by the file, and their treatment
};

// Reads a PNG or OpenEXR file. `layer` selects the colour of an OpenEXR layer; a PNG refuses a layer. Throws `Error`
// naming the file, also for a value that is not finite (with its pixel).
ComparedPicture readPicture(const Path& file, const std::string& layer = "");

// Reads a mask for metrics.h: red, or the only channel, of a PNG or OpenEXR file. PNG values are not decoded from sRGB.
ComparedPicture readMask(const Path& file);

// Aligns pictures by their display windows. If the data windows of `test` and `reference` differ, both pictures get the
// area that contains the visible pixels of both. Pixels outside of a picture's data window are black, and the notes of
// the picture state this. An empty mask selects all pixels. A mask of the compared size is not aligned. Throws `Error`
// with the windows if display windows differ in size, or if a picture has no visible pixel.
void alignPictures(ComparedPicture& test, ComparedPicture& reference, ComparedPicture& mask);

// Options of an image comparison: HDR-FLIP with its exposures, and the viewing distance in pixels per degree.
struct CompareOptions {
  bool hdr = true;                     // also compute HDR-FLIP
  std::optional<Exposures> exposures;  // of HDR-FLIP; empty: automatic
  double pixels_per_degree = kPixelsPerDegree;
};

// Errors of an image against a reference image. Absent values were not measured: SSIM of an image smaller than its
// window, HDR-FLIP if it was not requested.
struct ImageComparison {
  double mse = 0, rmse = 0, psnr = 0, relmse = 0, relmse_trimmed = 0, smape = 0;
  std::optional<double> ssim, ms_ssim;  // ms_ssim takes no mask; absent with a mask
  double ldr_flip = 0, ldr_flip_max = 0;
  std::optional<double> hdr_flip, hdr_flip_max;
  Exposures exposures;     // of hdr_flip
  Image ldr_map, hdr_map;  // error maps of the whole image
  size_t pixels = 0;       // number of compared pixels
};

// Compares linear colour of the same size; `mask` as in metrics.h (empty: all pixels). Throws `Error` if sizes differ
// or the mask selects no pixel.
ImageComparison compareImages(const Image& test, const Image& reference, const Image& mask = {},
                              const CompareOptions& options = {});

// Keys mse rmse psnr relmse relmse_trimmed smape ssim ms_ssim ldr_flip ldr_flip_max hdr_flip hdr_flip_max pixels; with
// HDR also hdr_flip_start hdr_flip_stop hdr_flip_exposures hdr_flip_source. Absent values are null. The PSNR of
// identical images is the string "inf".
Json comparisonJson(const ImageComparison& comparison);

}  // namespace strobe::image
