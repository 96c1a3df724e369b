// SPDX-License-Identifier: MIT
#include "bench/texts.h"

#include <fmt/format.h>

#include <cmath>

#include "page/number.h"

namespace strobe::bench {

std::string shownTime(double ms) { return ms < 0.1 ? fmt::format("{:.1f} µs", 1000 * ms) : page::shownMs(ms); }

std::string shownRange(const Estimate& estimate, std::string (*shown)(double)) {
  if (std::isnan(estimate.low)) return page::kNotMeasured;
  return shown(estimate.low) + " to " + shown(estimate.high);
}

page::TableCell timeCell(double ms) { return {ms, shownTime(ms)}; }

page::TableCell bytesCell(uint64_t bytes) {
  constexpr double kKilo = 1e3, kMega = 1e6;
  const double count = double(bytes);
  if (bytes == 0) return {count, page::kNotMeasured};
  return {count, count < kMega ? fmt::format("{:.1f} kB", count / kKilo) : fmt::format("{:.1f} MB", count / kMega)};
}

page::TableCell countCell(uint64_t count) {
  return {double(count), count == 0 ? page::kNotMeasured : std::to_string(count)};
}

std::string roundsOf(const Run& run) {
  std::string of = "a frame";
  if (run.frames_in_flight > 1) of = fmt::format("frames, {} in flight at once,", run.frames_in_flight);
  return fmt::format("{} rounds of {} of each shot in turn; the first frames, which compile, are not counted",
                     run.shots.front().ms.size(), of);
}

std::string deviceOf(const Run& run) {
  std::string text = fmt::format("{}, {}, rays by {}, {} threads", run.device, run.driver, run.backend, run.threads);
  for (const auto& [name, value] : run.environment) text += fmt::format(", {}={}", name, value);
  return text;
}

std::string cautionOf(const Run& run) {
  if (!run.software) return "Clocks are not locked.";
  std::string text =
      "A software device: compare ratios; its milliseconds are not comparable across machines, nor with a GPU's.";
  if (!run.timesPasses()) text += " It has no clock for passes while several frames are in flight.";
  return text;
}

const char* const kWorkNote =
    "Bytes are the sizes of a pass's images, each counted once: a lower bound of its traffic, without repeated reads, "
    "the scene and the ray tracing structures.";

}  // namespace strobe::bench
