// SPDX-License-Identifier: MIT
// What Strobe cannot do with any pipeline. Each room declares its own limits in its limits.h; messages and the
// reference page quote them. The limits of passes are declared with their counters (docs/writing-a-pass.md).
#pragma once

#include <string>
#include <string_view>

namespace strobe {

struct Limit {
  // Known: never reported, since nearly every picture meets it or it cannot be detected. Warned: the picture is made,
  // with a warning. Refused: an error before anything is drawn.
  enum class Kind { Known, Warned, Refused };
  std::string_view name;
  Kind kind = Kind::Warned;
  std::string_view met;     // when it is met
  std::string_view result;  // what is done then, and what to do about it

  // "`facts`; RESULT", for an error or a warning.
  std::string text(const std::string& facts) const { return facts + "; " + std::string(result); }
};

}  // namespace strobe
