// SPDX-License-Identifier: MIT
#include "scene/gltf_uri.h"

#include <algorithm>
#include <cctype>

namespace strobe::scene {

bool hasScheme(const std::string& uri) {
  const size_t end = uri.find_first_of(":/?#");
  if (end == std::string::npos || uri[end] != ':' || !std::isalpha(uint8_t(uri[0]))) return false;
  return std::all_of(uri.begin(), uri.begin() + std::ptrdiff_t(end),
                     [](char c) { return std::isalnum(uint8_t(c)) || c == '+' || c == '-' || c == '.'; });
}

std::optional<std::vector<uint8_t>> fromBase64(std::string_view text) {
  std::vector<uint8_t> bytes;
  uint32_t bits = 0;
  int held = 0;
  while (!text.empty() && text.back() == '=') text.remove_suffix(1);
  for (char c : text) {
    static constexpr std::string_view kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    size_t digit = kDigits.find(c);
    if (digit == std::string_view::npos) return std::nullopt;
    bits = bits << 6 | uint32_t(digit);
    held += 6;
    if (held < 8) continue;
    held -= 8;
    bytes.push_back(uint8_t(bits >> held));
  }
  return bytes;
}

std::string percentDecoded(const std::string& uri) {
  std::string text;
  for (size_t i = 0; i < uri.size(); ++i) {
    bool escape =
        uri[i] == '%' && i + 2 < uri.size() && std::isxdigit(uint8_t(uri[i + 1])) && std::isxdigit(uint8_t(uri[i + 2]));
    text += escape ? char(std::stoi(uri.substr(i + 1, 2), nullptr, 16)) : uri[i];
    if (escape) i += 2;
  }
  return text;
}

}  // namespace strobe::scene
