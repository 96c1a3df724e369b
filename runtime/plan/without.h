// SPDX-License-Identifier: MIT
// The field `without` of a pass, in the canonical form and for people.
#pragma once

#include "plan/description.h"

namespace strobe::plan {

// Of a pass whose ports are known. Throws `Error` at the place of the first mistake.
std::vector<WithoutDesc> withoutFromJson(const Json& json, const PassDesc& pass);

Json toJson(const WithoutDesc& without);

// Why a node does not run, and what stands in: "nothing moves in this frame: blurred = color".
std::string reasonOf(const WithoutDesc& without);

}  // namespace strobe::plan
