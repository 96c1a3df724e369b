// SPDX-License-Identifier: MIT
// Two programs that draw the same shots alternately.
#pragma once

#include <functional>

#include "bench/times.h"

namespace strobe::bench {

struct Turns {
  std::vector<Run> first, second;  // one run per block and program
};

// Runs each program `blocks` times. `arguments` make a program print a run as JSON. The first program to run alternates
// from block to block, so that a drift of the machine's speed favours neither. `progress` is called after each block of
// both. Throws `Error` with a program's message if the program fails or prints anything but a run, and if the two runs
// have different shots.
Turns runInTurn(const std::string& first, const std::string& second, const std::vector<std::string>& arguments,
                int blocks, const std::function<void(int done)>& progress);

}  // namespace strobe::bench
