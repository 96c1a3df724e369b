// SPDX-License-Identifier: MIT
// Content hashes: XXH3-128 within the program, SHA-256 for checks by other programs.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace strobe {

// 32 lower-case hexadecimal digits.
std::string hashBytes(const void* data, size_t size);
std::string hashText(std::string_view text);

// FIPS 180-4, as `sha256sum` prints it: 64 lower-case hexadecimal digits.
std::string sha256(std::string_view bytes);

}  // namespace strobe
