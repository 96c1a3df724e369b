// SPDX-License-Identifier: MIT
// Two programs that take turns at the same shots.
#pragma once

#include <functional>

#include "bench/times.h"

namespace strobe::bench {

struct Turns {
  std::vector<Run> first, second;  // a block of each program
};

// Starts each program with these arguments, which make it print a run as JSON, `blocks` times; who begins changes from
// block to block, so that a machine that gets slower or faster serves neither. `progress` is called after each block of
// both. Throws `Error` with what a program said where it fails or prints something else, and where the two print runs
// of other shots.
Turns runInTurn(const std::string& first, const std::string& second, const std::vector<std::string>& arguments,
                int blocks, const std::function<void(int done)>& progress);

}  // namespace strobe::bench
