// SPDX-License-Identifier: MIT
// Report of a run: text for a terminal, a page, and a trace.
#pragma once

#include "bench/comparison.h"
#include "page/page.h"

namespace strobe::bench {

// Methods of each scene and size with medians, intervals and ratios; the device, and the limits of the measurement;
// frames and moved passes of the comparison (may be null).
std::string textOf(const Run& run, const TimeComparison* comparison);

// Self-contained page: the same tables, the whole comparison, and for each method a waterfall and a table of its
// passes.
page::Page pageOf(const Run& run, const TimeComparison* comparison);

// The run for trace viewers (Perfetto, chrome://tracing): Chrome's trace event format, JSON object form, microseconds.
// One process per shot, with a complete event ("X") for the frame of the typical round. Below the frame, one event per
// part, one after the other from 0. If the parts add up to more than the frame (they overlapped on the device), the
// frame's event is as long as their sum.
Json traceOf(const Run& run);

}  // namespace strobe::bench
