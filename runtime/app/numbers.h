// SPDX-License-Identifier: MIT
// Validators for numbers in options.
#pragma once

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <string>

#include "base/numbers.h"

namespace strobe::app {

// Accepts finite numbers above 0. CLI11's own validator prints the largest double with all its digits.
inline CLI::Validator aboveZero() {
  auto refusal = [](const std::string& text) -> std::string {
    return finiteNumber(text).value_or(0) > 0 ? "" : fmt::format("'{}' is not a number above 0", text);
  };
  return CLI::Validator("POSITIVE").operation(refusal);
}

}  // namespace strobe::app
