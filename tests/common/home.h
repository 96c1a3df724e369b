// SPDX-License-Identifier: MIT
// The home that tests read from: the environment's, as the program has it.
#pragma once

#include "base/home.h"

namespace strobe {

inline const Home& home() {
  static const Home made = Home::fromEnvironment();
  return made;
}

}  // namespace strobe
