// SPDX-License-Identifier: MIT
// The home that tests read files from, found through the environment as in the program.
#pragma once

#include "base/home.h"

namespace strobe {

inline const Home& home() {
  static const Home made = Home::fromEnvironment();
  return made;
}

}  // namespace strobe
