// SPDX-License-Identifier: MIT
// URIs of glTF files: relative paths, and data.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace strobe::scene {

// True if the text begins with a scheme (RFC 3986): a letter, then letters, digits, "+", "-" and ".", up to a colon
// before the first slash.
bool hasScheme(const std::string& uri);

std::string percentDecoded(const std::string& uri);

// Bytes of a base64 text, with or without padding; nothing if it has other characters.
std::optional<std::vector<uint8_t>> fromBase64(std::string_view text);

}  // namespace strobe::scene
