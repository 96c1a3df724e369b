// SPDX-License-Identifier: MIT
// Mustache templates filled from JSON, and the files of runtime/page/assets/, which are part of the program.
#pragma once

#include <string>
#include <string_view>

#include "base/json_fwd.h"

namespace strobe::page {

// The content of a file of assets/. Asserts that there is one of this name.
std::string_view asset(std::string_view name);

// The template filled with `values`, which is an object. False in a section are null, false, "" and empty lists;
// numbers are written by fmt.
std::string rendered(std::string_view name, const Json& values);

}  // namespace strobe::page
