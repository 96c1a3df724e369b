// SPDX-License-Identifier: MIT
// Mutants: variants of a shader with one deliberate small mistake each, made by a fixed list of operators, and a random
// draw of mutants by a seed.
#pragma once

#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace strobe::mutate {

enum class MutationOperator {
  Sign,              // + and -, += and -=, ++ and --; a unary minus dropped
  Constant,          // 0 to 1, 1 to 0 and 2, other literals to 0 and twice
  Comparison,        // < and <=, > and >=, == and !=; and the other direction
  OffByOne,          // [i] to [i + 1], a loop's < to <= and back, + 1 and - 1 dropped
  SwappedOperands,   // of -, of /, and the first two arguments of a call
  Extremum,          // min and max
  Connective,        // && and ||
  DroppedClamp,      // clamp(x, a, b), min(x, a) and max(x, a) to x
  DroppedSanitiser,  // a call that replaces values that are not finite
};
const char* nameOf(MutationOperator op);
const std::vector<MutationOperator>& mutationOperators();

struct Mutant {
  std::string file;  // below shaders/
  MutationOperator op = MutationOperator::Sign;
  size_t offset = 0;  // in the file
  int line = 1, column = 1;
  std::string before, after;
};

// Properties of names that other files declare, as input of the operators.
struct Vocabulary {
  std::map<std::string, std::string> sanitisers;  // functions of one argument, with their return type
  std::set<std::string> unlike;  // functions and structures whose first two arguments are of different types
};

// Functions and structures declared in a text whose first two arguments are of different types.
std::set<std::string> unlikeArgumentsIn(const std::string& text);

// All mutants of a text, sorted by place. Comments, preprocessor lines, layouts, structures and sizes of
// arrays stay as they are.
std::vector<Mutant> mutantsOf(const std::string& file, const std::string& text, const Vocabulary& words = {});

// The text with the change of the mutant.
std::string mutated(const std::string& text, const Mutant& mutant);

// Draws `count` mutants (all if there are fewer) by a seed, sorted by file and place. The share of a file is
// proportional to its number of mutants, at least one if `count` allows. Within a file the operators alternate, and a
// second mutant at the same place is drawn only if no other place is left.
std::vector<Mutant> drawMutants(const std::vector<std::vector<Mutant>>& by_file, uint64_t seed, size_t count);

}  // namespace strobe::mutate
