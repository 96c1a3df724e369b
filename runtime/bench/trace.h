// SPDX-License-Identifier: MIT
// A run for trace viewers (Perfetto, chrome://tracing).
#pragma once

#include "bench/times.h"

namespace strobe::bench {

// Chrome's trace event format, JSON object form: a process per shot, in it a complete event ("X") for the frame of the
// shot's typical round and one below it for each part, one after the other from 0; microseconds. Where parts add up to
// more than the frame (they overlapped on the device), the frame's event is as long as they are.
Json traceOf(const Run& run);

}  // namespace strobe::bench
