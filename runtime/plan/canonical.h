// SPDX-License-Identifier: MIT
// A plan as data that is the same, byte for byte, whenever the plan is; and as text for people.
#pragma once

#include <string>

#include "plan/plan.h"

namespace strobe::plan {

// Everything that decides what a frame executes: resolved parameters, wiring, sizes, order, memory, barriers.
// Sources of shaders and texts of documentation are not in it.
Json toJson(const Plan& plan);

// Identity of a plan: the hash of its canonical form.
std::string hashOf(const Plan& plan);

// Identity of all but the values that shaders read as parameters: plans of one shape run on the same pipelines and
// images.
std::string shapeOf(const Plan& plan);

// Several lines for `strobe plan`: order, sizes, formats, memory, what was culled and why.
std::string describe(const Plan& plan);

}  // namespace strobe::plan
