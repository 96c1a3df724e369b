// SPDX-License-Identifier: MIT
// The field `without` of a pass (`if_no` in Lua), as canonical form and as text for users.
#pragma once

#include "plan/description.h"

namespace strobe::plan {

// Stand-ins of a pass whose ports are already read. Throws `Error` at the place of the first mistake.
std::vector<WithoutDesc> withoutFromJson(const Json& json, const PassDesc& pass);

Json toJson(const WithoutDesc& without);

// The reason that a node does not run, and its stand-ins: "nothing moves in this frame: blurred = color".
std::string reasonOf(const WithoutDesc& without);

}  // namespace strobe::plan
