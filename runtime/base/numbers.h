// SPDX-License-Identifier: MIT
// Numbers in texts.
#pragma once

#include <array>
#include <charconv>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>

namespace strobe {

// The `count` numbers of a text like "3,4", separated by `between`. Nothing if the text has any other form.
template <class Number, size_t count>
std::optional<std::array<Number, count>> numbersIn(std::string_view text, char between) {
  std::array<Number, count> numbers{};
  const char *at = text.data(), *end = at + text.size();
  for (size_t i = 0; i < count; ++i, ++at) {
    auto [after, error] = std::from_chars(at, end, numbers[i]);
    bool follows = i + 1 < count ? after != end && *after == between : after == end;
    if (error != std::errc() || !follows) return {};
    at = after;
  }
  return numbers;
}

// The finite number of a text; nothing if the text has any other form.
inline std::optional<double> finiteNumber(std::string_view text) {
  auto number = numbersIn<double, 1>(text, ',');
  return number && std::isfinite(number->front()) ? std::optional(number->front()) : std::nullopt;
}

// "1 truth", "2 truths": for nouns with a plural in "s".
inline std::string countText(size_t count, std::string_view noun) {
  return std::to_string(count) + " " + std::string(noun) + (count == 1 ? "" : "s");
}

}  // namespace strobe
