// SPDX-License-Identifier: MIT
// Report of a run: text for a terminal, and a page.
#pragma once

#include "bench/comparison.h"
#include "page/page.h"

namespace strobe::bench {

// Methods of each scene and size with medians, intervals and ratios; the device, and the limits of the measurement;
// frames and moved passes of the comparison (may be null).
std::string textOf(const Run& run, const Comparison* comparison);

// Self-contained page: the same tables, the whole comparison, and for each method a waterfall and a table of its
// passes.
page::Page pageOf(const Run& run, const Comparison* comparison);

}  // namespace strobe::bench
