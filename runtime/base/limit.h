// SPDX-License-Identifier: MIT
// Limits of Strobe that hold for every pipeline. Each folder declares its own limits in its limits.h; messages and the
// reference page quote them. The limits of passes are declared with their counters (docs/writing-a-pass.md).
#pragma once

#include <string>
#include <string_view>

namespace strobe {

// Limit that a picture met, as a warning "FACTS; RESULT".
struct LimitMet {
  std::string facts;   // the numbers and names of this picture
  std::string result;  // consequence and remedy
  std::string text() const { return facts + "; " + result; }
};

// Documented limit: its name, the condition that meets it, the consequence and remedy, and the response (none, a
// warning or an error).
struct Limit {
  // Known: never reported, because nearly every picture meets the limit or because it cannot be detected. Warned: the
  // picture is made, with a warning. Refused: an error before anything is drawn.
  enum class Kind { Known, Warned, Refused };
  std::string_view name;
  Kind kind = Kind::Warned;
  std::string_view met;     // condition
  std::string_view result;  // consequence and remedy

  LimitMet metBy(const std::string& facts) const { return {facts, std::string(result)}; }
  // "`facts`; RESULT", for an error or a warning.
  std::string text(const std::string& facts) const { return metBy(facts).text(); }
};

}  // namespace strobe
