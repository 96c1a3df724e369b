// SPDX-License-Identifier: MIT
// Contact sheet of an experiment with pictures: for each shot, a row of pictures, rows of magnified crops and a row of
// differences from truth.
#pragma once

#include "study/gallery.h"

namespace strobe::study {

// Display image (sRGB-encoded values). `galleries`: one per shot, without pictures if the shot is missing.
image::Image sheetOf(const Results& results, const std::vector<Gallery>& galleries);

}  // namespace strobe::study
