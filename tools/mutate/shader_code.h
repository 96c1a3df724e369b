// SPDX-License-Identifier: MIT
// Compiled code of all passes, for finding the mutants that do not change the code.
#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "graph/pipelines.h"
#include "mutate/home_copy.h"
#include "mutate/mutants.h"

namespace strobe::mutate {

enum class CodeChange { Refused, Same, Different };

class ShaderCode {
 public:
  // Evaluates every pass of the home; throws `Error`.
  explicit ShaderCode(const Home& home);

  // Files below shaders/ that passes use, sorted.
  std::vector<std::string> files() const;

  // Refused: the mutant does not compile. Same: every pass that includes the file compiles to equal code.
  CodeChange changeBy(const Mutant& mutant);

 private:
  struct Unit {
    const plan::PassDesc* pass = nullptr;
    shader::Interface interface;
    std::optional<std::string> hash;  // of the original, computed at first use; "" if it does not compile
  };
  std::string original(Unit& unit) const;

  Home home_;
  HomeCopy copy_;
  std::vector<plan::PassDesc> passes_;
  std::map<const plan::PassDesc*, std::set<std::string>> files_;
  std::vector<Unit> units_;
};

}  // namespace strobe::mutate
