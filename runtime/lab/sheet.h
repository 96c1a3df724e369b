// SPDX-License-Identifier: MIT
// The contact sheet of an exhibition: one picture to show, per shot a row of pictures, of magnified crops and of
// differences from truth.
#pragma once

#include "lab/exhibit.h"

namespace strobe::lab {

// Where a difference image saturates is 1 / gain in linear values.
image::Image differenceFromTruth(const Entry& entry, const Group& group, double gain);

// Mean of the linear colours below each pixel of the result; neither side grows.
image::Image shrunk(const image::Image& linear, int width, int height);

// A display image (sRGB-encoded values).
image::Image sheetOf(const Exhibition& exhibition);

}  // namespace strobe::lab
