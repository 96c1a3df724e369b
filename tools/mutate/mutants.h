// SPDX-License-Identifier: MIT
// Small mistakes made on purpose: from the text of a shader to every variant of it that differs by one of a fixed list
// of operators, and a draw of some of them by a seed.
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
  DroppedSanitiser,  // a call that replaces what is not finite
};
const char* nameOf(MutationOperator op);
const std::vector<MutationOperator>& mutationOperators();

struct Mutant {
  std::string file;  // below shaders/
  MutationOperator op = MutationOperator::Sign;
  size_t offset = 0;  // in the text
  int line = 1, column = 1;
  std::string before, after;
};

// What operators must know of names that are declared elsewhere.
struct Vocabulary {
  std::map<std::string, std::string> sanitisers;  // functions of one argument, and the type each returns
  std::set<std::string> unlike;  // functions and structures whose first two arguments are of different types
};

// Functions and structures declared in a text whose first two arguments are of different types.
std::set<std::string> unlikeArgumentsIn(const std::string& text);

// Every mutant of a text, in the order of their places. Comments, preprocessor lines, layouts, structures and sizes of
// arrays stay as they are.
std::vector<Mutant> mutantsOf(const std::string& file, const std::string& text, const Vocabulary& words = {});

// The text with the one change.
std::string mutated(const std::string& text, const Mutant& mutant);

// `count` of them (or all there are) by a seed: files get shares in proportion to what they offer, at least one each
// where `count` allows; within a file the operators take turns, and no two change the same place. By file and place.
std::vector<Mutant> drawMutants(const std::vector<std::vector<Mutant>>& by_file, uint64_t seed, size_t count);

}  // namespace strobe::mutate
