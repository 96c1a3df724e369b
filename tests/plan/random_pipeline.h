// SPDX-License-Identifier: MIT
// Valid pipelines of random shape: passes of every kind, sizes, formats, loops, counters, taps.
#pragma once

#include "plan/plan.h"

namespace strobe::plan::test {

struct RandomPipeline {
  PipelineDesc pipeline;
  CompileOptions options;
};

RandomPipeline randomPipeline(uint32_t seed);

}  // namespace strobe::plan::test
