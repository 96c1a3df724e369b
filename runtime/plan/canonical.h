// SPDX-License-Identifier: MIT
// A plan as data and as text. Equal plans give equal bytes of data.
#pragma once

#include <string>

#include "plan/plan.h"

namespace strobe::plan {

// All data that decide the execution of a frame: resolved parameters, wiring, sizes, order, memory, barriers. The
// result has no shader sources and no documentation.
Json toJson(const Plan& plan);

// Identity of a plan: the hash of its canonical form.
std::string hashOf(const Plan& plan);

// Hash of the plan without the values that shaders read as parameters. Plans of equal shape run on the same pipelines
// and images.
std::string shapeOf(const Plan& plan);

// Several lines for `strobe plan`: order, sizes, formats, memory, culled nodes and the reason for each.
std::string describe(const Plan& plan);

}  // namespace strobe::plan
