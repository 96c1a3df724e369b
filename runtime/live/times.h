// SPDX-License-Identifier: MIT
// GPU times of the last frames, per pass. A time that was not measured is NaN or absent, never 0.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "graph/graph.h"

namespace strobe::live {

// GPU times of the most recent frames, milliseconds, per pass and in total. Frames that created GPU pipelines count as
// not measured.
class TimeHistory {
 public:
  static constexpr size_t kFrames = 120;

  // Marks the next frame's times as void, because they include the creation of GPU pipelines.
  void voidNext() { void_next_ = true; }
  void add(const graph::FrameResult& frame);
  void clear();
  // True if the last frame's times were void. Another frame has to be drawn to measure the times.
  bool lastIsVoid() const { return last_void_; }

  struct Row {
    std::string name;       // name of the node
    std::vector<float> ms;  // oldest first, NaN where void; at most `kFrames`
    // Latest and median of the measured times; empty without a measured time.
    std::optional<double> latest() const;
    std::optional<double> median() const;
  };
  const std::vector<Row>& passes() const { return passes_; }  // in the last frame's order of execution
  const Row& total() const { return total_; }

 private:
  std::vector<Row> passes_;
  Row total_{"total", {}};
  bool void_next_ = true, last_void_ = false;
};

}  // namespace strobe::live
