// SPDX-License-Identifier: MIT
#include "base/extension.h"

#include <algorithm>
#include <cctype>
#include <cstdint>

namespace strobe {

bool hasExtension(std::string_view name, std::string_view extension) {
  if (name.size() < extension.size()) return false;
  auto same = [](char a, char b) { return std::tolower(uint8_t(a)) == std::tolower(uint8_t(b)); };
  return std::equal(extension.begin(), extension.end(), name.end() - std::ptrdiff_t(extension.size()), same);
}

}  // namespace strobe
