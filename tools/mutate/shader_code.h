// SPDX-License-Identifier: MIT
// What all passes compile to, to find the mutants that change nothing.
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

  // Files below shaders/ that some pass reaches, sorted.
  std::vector<std::string> files() const;

  // Refused: the compiler does not take it. Same: every pass that includes the file compiles to what it was.
  CodeChange changeBy(const Mutant& mutant);

 private:
  struct Unit {
    const plan::PassDesc* pass = nullptr;
    shader::Interface interface;
    std::optional<std::string> hash;  // of the original, once it was needed; "" where that does not compile
  };
  std::string original(Unit& unit) const;

  Home home_;
  HomeCopy copy_;
  std::vector<plan::PassDesc> passes_;
  std::map<const plan::PassDesc*, std::set<std::string>> files_;
  std::vector<Unit> units_;
};

}  // namespace strobe::mutate
