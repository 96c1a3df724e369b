// SPDX-License-Identifier: MIT
// An independent judge of a plan: executes its commands one after the other in the memory model of the device and
// reports every pair of accesses that may collide, and every read that finds another image's contents.
//
// It takes from a plan the order of the steps, the slots and the barriers. What a step touches it works out for itself
// from the kind of the pass, so a use forgotten by the plan is found as well. It is stricter than a device in one
// respect: a barrier orders only accesses to its own resource.
#pragma once

#include <string>
#include <vector>

#include "plan/plan.h"

namespace strobe::plan::test {

// Empty if the plan is sound. `iterations` cuts each loop short (a stop condition may); 0 runs them to the end.
std::vector<std::string> replay(const Plan& plan, uint32_t trace_stage, int iterations = 0);

// `replay` for every number of iterations the loops can have.
std::vector<std::string> replayAll(const Plan& plan, uint32_t trace_stage);

}  // namespace strobe::plan::test
