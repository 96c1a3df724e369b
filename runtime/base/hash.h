// SPDX-License-Identifier: MIT
// Content identity (XXH3-128), not security.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace strobe {

// 32 lower-case hexadecimal digits.
std::string hashBytes(const void* data, size_t size);
std::string hashText(std::string_view text);

}  // namespace strobe
