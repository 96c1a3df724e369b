// SPDX-License-Identifier: MIT
// Reduces a failing shot to a small shot that still fails.
#pragma once

#include <functional>

#include "stability/cases.h"

namespace strobe::stability {

// True if the shot still fails. An `Error` counts as false.
using StillFails = std::function<bool(const lab::Shot&)>;

// Simplifies the shot step by step while it still fails: objects, appearance, samples, tiles, size, random numbers.
// Does not change `kept`, the settings of the variant. `tries` limits the number of tests.
lab::Shot shrunk(lab::Shot shot, const plan::PipelineDesc& pipeline, const script::Settings& kept,
                 const StillFails& still_fails, int tries = 80);

}  // namespace strobe::stability
