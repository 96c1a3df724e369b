// SPDX-License-Identifier: MIT
// A picture with equal rows, against a filter along the row in double precision, pixel by pixel with each pixel's own
// jitter.
#pragma once

#include <functional>
#include <string>

#include "oracle/jitters.h"
#include "oracle/render.h"

namespace strobe::oracle {

// The shot, and the row filter at one pixel for a given jitter.
struct RowCase {
  std::string what;
  lab::Shot shot;
  std::function<double(int x, double jitter)> expected;
  int first, last;  // columns
  JitterAt jitter = ignJitter;
};

// Tolerance 2e-3: single precision changes a weight by less, and a tap that changes pixels is accounted for.
void expectPerPixel(const RowCase& filter, const image::Image& color);

}  // namespace strobe::oracle
