// SPDX-License-Identifier: MIT
// A run for trace viewers (Perfetto, chrome://tracing).
#pragma once

#include "bench/times.h"

namespace strobe::bench {

// Chrome's trace event format, JSON object form, microseconds. One process per shot, with a complete event ("X") for
// the frame of the typical round. Below the frame, one event per part, one after the other from 0. If the parts add up
// to more than the frame (they overlapped on the device), the frame's event is as long as their sum.
Json traceOf(const Run& run);

}  // namespace strobe::bench
