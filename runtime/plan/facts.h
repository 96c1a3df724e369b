// SPDX-License-Identifier: MIT
// Facts of a frame that a plan may be made without: what its scene does not have at these times is not paid for.
#pragma once

#include <string>
#include <vector>

namespace strobe::plan {

struct Fact {
  std::string name;
  std::string absent;  // what is said to people where it does not hold
  // Of the scene alone, and seen by shaders: FACT_<name> is 0 or 1 in passes that see the scene.
  bool compiled_in = false;
  // Of the times of the exposure, and seen by the shaders of all passes.
  bool compiled_into_all = false;
};

// In the order in which they are listed to people.
const std::vector<Fact>& facts();

std::vector<std::string> factNames();

// Null where there is none of that name.
const Fact* findFact(const std::string& name);

}  // namespace strobe::plan
