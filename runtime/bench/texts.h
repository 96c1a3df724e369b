// SPDX-License-Identifier: MIT
// Texts of a run: formatted numbers, device, and limits of the measurement.
#pragma once

#include "bench/times.h"
#include "page/table.h"

namespace strobe::bench {

// Microseconds below 0.1 ms: passes of a GPU are that short.
std::string shownTime(double ms);
// "LOW to HIGH"; kNotMeasured without an interval.
std::string shownRange(const Estimate& estimate, std::string (*shown)(double));
page::TableCell timeCell(double ms);
// kNotMeasured for 0.
page::TableCell bytesCell(uint64_t bytes);
page::TableCell countCell(uint64_t count);

std::string roundsOf(const Run& run);
// Device, driver, backend, threads and driver environment.
std::string deviceOf(const Run& run);
// Limits on comparing milliseconds of this device.
std::string cautionOf(const Run& run);

extern const char* const kWorkNote;  // definition of the counted bytes

}  // namespace strobe::bench
