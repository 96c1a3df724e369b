// SPDX-License-Identifier: MIT
// What Strobe cannot do, whatever the pipeline: one table, which messages and the reference page quote. The limits of
// passes are declared with their counters (docs/writing-passes.md).
#pragma once

#include <string>
#include <vector>

namespace strobe {

struct Limit {
  // Known: nothing is said when it is met, since nearly every picture meets it, or nobody can tell. Warned: the picture
  // is made, with a warning. Refused: an error before anything is drawn.
  enum class Kind { Known, Warned, Refused };
  std::string name;
  Kind kind = Kind::Warned;
  std::string met;     // when it is met
  std::string result;  // what is done then, and what to do about it
};

const std::vector<Limit>& limits();

// "`facts`; RESULT", for an error or a warning. A name that is not in the table is our own mistake.
std::string limitText(const std::string& name, const std::string& facts);

}  // namespace strobe
