// SPDX-License-Identifier: MIT
// Validators for numbers in options.
#pragma once

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <charconv>
#include <cmath>
#include <string>

namespace strobe::app {

// Accepts finite numbers above 0. CLI11's own validator prints the largest double with all its digits.
inline CLI::Validator aboveZero() {
  auto refusal = [](const std::string& text) -> std::string {
    double number = 0;
    auto [end, status] = std::from_chars(text.data(), text.data() + text.size(), number);
    bool good = status == std::errc() && end == text.data() + text.size() && std::isfinite(number) && number > 0;
    return good ? "" : fmt::format("'{}' is not a number above 0", text);
  };
  return CLI::Validator("POSITIVE").operation(refusal);
}

}  // namespace strobe::app
