// SPDX-License-Identifier: MIT
// How numbers of a run are written, and what is said beside them.
#pragma once

#include "bench/times.h"
#include "page/table.h"

namespace strobe::bench {

// Passes of a GPU take microseconds.
std::string shownTime(double ms);
// "LOW to HIGH"; kNotMeasured where there is no interval.
std::string shownRange(const Estimate& estimate, std::string (*shown)(double));
// kNotMeasured for none.
std::string shownBytes(uint64_t bytes);
std::string shownCount(uint64_t count);

std::string roundsOf(const Run& run);
// Device, driver and what else decides its speed.
std::string deviceOf(const Run& run);
// What may not be read from milliseconds of this device.
std::string cautionOf(const Run& run);

extern const char* const kWorkNote;  // what bytes are

}  // namespace strobe::bench
