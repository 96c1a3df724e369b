// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "base/error.h"

namespace strobe::testing {

// The message of the Error that ends `step`; empty if it does not fail.
template <class Step>
std::string refusalOf(const Step& step) {
  try {
    step();
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

}  // namespace strobe::testing
