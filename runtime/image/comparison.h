// SPDX-License-Identifier: MIT
// All error metrics of a pair of images, as shown by the command line, sweeps and reports.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/files.h"
#include "base/json.h"
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

// Errors of an image against a reference image.
struct ImageComparison {
  // Keys mse rmse psnr relmse relmse_trimmed smape ssim ms_ssim ldr_flip ldr_flip_max hdr_flip hdr_flip_max pixels;
  // with HDR also hdr_flip_start hdr_flip_stop hdr_flip_exposures hdr_flip_source. Null: not measured, as SSIM of an
  // image smaller than its window, MS-SSIM with a mask, and HDR-FLIP unless requested. The PSNR of identical images is
  // "inf".
  Json numbers;
  Image map;  // error map of the whole image: of HDR-FLIP if it was requested, else of LDR-FLIP
};

// Compares linear colour of the same size; `mask` as in metrics.h (empty: all pixels). Throws `Error` if the mask
// selects no pixel.
ImageComparison compareImages(const Image& test, const Image& reference, const Image& mask = {},
                              const CompareOptions& options = {});

}  // namespace strobe::image
