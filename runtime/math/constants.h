// SPDX-License-Identifier: MIT
#pragma once

namespace strobe {

inline constexpr double kPi = 3.14159265358979323846;

}  // namespace strobe
