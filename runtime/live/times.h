// SPDX-License-Identifier: MIT
// GPU times of the last frames, per pass. A time that was not measured is absent, never 0.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "graph/graph.h"

namespace strobe::live {

class TimeHistory {
 public:
  static constexpr size_t kFrames = 120;

  // The next frame's times are void: it paid for pipelines that were made for it.
  void voidNext() { void_next_ = true; }
  void add(const graph::FrameResult& frame);
  void clear();
  // Whether the last frame's times were void: another frame has to be drawn to know them.
  bool lastIsVoid() const { return last_void_; }

  struct Row {
    std::string name;       // of the node
    std::vector<float> ms;  // oldest first, NaN where void; at most `kFrames`
    // Of the measured ones among the last frames; nothing without any.
    std::optional<double> latest() const;
    std::optional<double> median() const;
  };
  const std::vector<Row>& passes() const { return passes_; }  // in the order of execution of the last frame
  const Row& total() const { return total_; }

 private:
  std::vector<Row> passes_;
  Row total_{"total", {}};
  bool void_next_ = true, last_void_ = false;
};

}  // namespace strobe::live
