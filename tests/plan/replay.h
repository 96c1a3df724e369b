// SPDX-License-Identifier: MIT
// An independent check of a plan: executes its commands in order in a model of the device's memory. Reports every pair
// of accesses that may collide and every read that gets another image's contents.
//
// The replay takes the order of steps, the slots and the barriers from the plan. It derives the accesses of a step from
// the kind of the pass, so that an access missing in the plan is found as well. It is stricter than a device in one
// respect: a barrier orders only accesses to its own resource.
#pragma once

#include <string>
#include <vector>

#include "plan/plan.h"

namespace strobe::plan::test {

// Problems; empty if the plan is sound. `iterations` limits each loop, like a stop condition; 0 runs loops to the end.
std::vector<std::string> replay(const Plan& plan, uint32_t trace_stage, int iterations = 0);

// `replay` for every number of iterations the loops can have.
std::vector<std::string> replayAll(const Plan& plan, uint32_t trace_stage);

}  // namespace strobe::plan::test
