// SPDX-License-Identifier: MIT
// From a shot that fails to a small one that still fails.
#pragma once

#include <functional>

#include "stability/cases.h"

namespace strobe::stability {

// Is the shot still wrong? An `Error` counts as no.
using StillFails = std::function<bool(const lab::Shot&)>;

// Takes away and makes smaller, one thing after the other, as long as it still fails: objects, looks, samples, tiles,
// size, numbers that were drawn. Never touches `kept`, the settings that make up the variant. `tries` bounds the work.
lab::Shot shrunk(lab::Shot shot, const plan::PipelineDesc& pipeline, const script::Settings& kept,
                 const StillFails& still_fails, int tries = 80);

}  // namespace strobe::stability
