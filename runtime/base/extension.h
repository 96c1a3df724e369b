// SPDX-License-Identifier: MIT
// Extensions of file names.
#pragma once

#include <string_view>

namespace strobe {

// True if the name ends in `extension` (".lua"), ignoring case.
bool hasExtension(std::string_view name, std::string_view extension);

}  // namespace strobe
