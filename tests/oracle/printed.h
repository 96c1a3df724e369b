// SPDX-License-Identifier: MIT
// Prints numbers of docs/derivations.md for tools/reproduce: lines "NAME: 0.123456 0.234567".
#pragma once

#include <fmt/format.h>

#include <initializer_list>
#include <string>

namespace strobe::oracle {

inline void printed(const std::string& name, std::initializer_list<double> values) {
  std::string line = name + ":";
  for (double value : values) line += fmt::format(" {:.6f}", value);
  fmt::print("{}\n", line);
}

}  // namespace strobe::oracle
