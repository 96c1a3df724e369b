// SPDX-License-Identifier: MIT
#include "live/times.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "math/statistics.h"

namespace strobe::live {

static constexpr float kVoid = std::numeric_limits<float>::quiet_NaN();

static void append(TimeHistory::Row& row, float ms) {
  row.ms.push_back(ms);
  if (row.ms.size() > TimeHistory::kFrames) row.ms.erase(row.ms.begin());
}

static std::vector<float> measured(const std::vector<float>& ms) {
  std::vector<float> values;
  std::copy_if(ms.begin(), ms.end(), std::back_inserter(values), [](float value) { return !std::isnan(value); });
  return values;
}

std::optional<double> TimeHistory::Row::latest() const {
  std::vector<float> values = measured(ms);
  if (values.empty()) return {};
  return values.back();
}

std::optional<double> TimeHistory::Row::median() const {
  std::vector<float> values = measured(ms);
  if (values.empty()) return {};
  return strobe::median({values.begin(), values.end()});
}

void TimeHistory::clear() {
  passes_.clear();
  total_.ms.clear();
  void_next_ = true;
  last_void_ = false;
}

// The history of a new pass begins with the pass's first frame.
void TimeHistory::add(const graph::FrameResult& frame) {
  std::vector<Row> rows;
  for (const graph::StepTime& time : frame.times) {
    auto old = std::find_if(passes_.begin(), passes_.end(), [&](const Row& row) { return row.name == time.name; });
    Row row = old == passes_.end() ? Row{time.name, {}} : *old;
    append(row, void_next_ || time.executions == 0 ? kVoid : float(time.gpu_ms));
    rows.push_back(std::move(row));
  }
  passes_ = std::move(rows);
  append(total_, void_next_ ? kVoid : float(frame.gpu_ms));
  last_void_ = std::exchange(void_next_, false);
}

}  // namespace strobe::live
