// SPDX-License-Identifier: MIT
// The contact sheet of an experiment with pictures: per shot a row of pictures, of magnified crops and of differences
// from truth.
#pragma once

#include "study/gallery.h"

namespace strobe::study {

// A display image (sRGB-encoded values). `galleries`: one of each shot, without pictures where it is missing.
image::Image sheetOf(const Results& results, const std::vector<Gallery>& galleries);

}  // namespace strobe::study
