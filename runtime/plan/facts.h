// SPDX-License-Identifier: MIT
// Facts of a frame. If a fact does not hold, the plan leaves out passes that have a stand-in.
#pragma once

#include <string>
#include <vector>

namespace strobe::plan {

// Named property of a frame, such as "something moves" or "a light casts shadows". Without it, some passes need not
// run.
struct Fact {
  std::string name;
  std::string absent;  // text for users if the fact does not hold
  // Depends on the scene alone: shaders of passes that use the scene have FACT_<name>, 0 or 1.
  bool compiled_in = false;
  // Depends on the times of the exposure: shaders of all passes have FACT_<name>, 0 or 1.
  bool compiled_into_all = false;
};

// All facts, in the order of lists in messages and documentation.
const std::vector<Fact>& facts();

// The fact of that name, or null.
const Fact* findFact(const std::string& name);

}  // namespace strobe::plan
