// SPDX-License-Identifier: MIT
// A run for people: as text for a terminal, and as a page.
#pragma once

#include "bench/comparison.h"
#include "page/page.h"

namespace strobe::bench {

// Of each scene and size the methods with medians, intervals and ratios; the frames and moved passes of the comparison
// (may be null); on what it ran, and what may be read from it.
std::string textOf(const Run& run, const Comparison* comparison);

// Self-contained: the same tables, all of the comparison, and of each method a waterfall of its passes and what each of
// them touches.
page::Page pageOf(const Run& run, const Comparison* comparison);

}  // namespace strobe::bench
