// SPDX-License-Identifier: MIT
// A mutation run: each mutant of the shaders in a home folder of its own, compiled, and tried by tests until one fails.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/home.h"
#include "mutate/test_programs.h"

namespace strobe::mutate {

struct MutationOptions {
  uint64_t seed = 1;
  size_t count = 120;
  std::string only;  // a shader's name below shaders/, or the beginning of one; "" for all
  TestFolder tests;
  Path results;  // kept up to date, and continued from
  Path reasons;  // why survivors are harmless, see giveReasons
  int jobs = 1;
  double budget_s = 90;            // of tests per mutant
  bool again = false;              // those that survived without a reason are tried once more
  std::vector<std::string> first;  // how the names of tests begin that come before all others
};

enum class Fate { Untried, Refused, Equivalent, Caught, Survived };

struct MutationResult {
  Mutant mutant;
  std::string line, mutated_line;  // without the space around them
  Fate fate = Fate::Untried;
  bool compiles = false;        // and to something else, as is known of one that is yet untried
  std::string by;               // the test that caught it
  int tests = 0, tests_of = 0;  // tried on, of those that read the shader
  double seconds = 0;
  std::string reason;  // why it is harmless that it survived, or ""
};

// The mutants that a seed draws from the shaders of the home folder which passes reach.
std::vector<Mutant> listMutants(const Home& home, const MutationOptions& options, const MutationPlan& plan);

// Tries each mutant, unless the results hold it already.
std::vector<MutationResult> runMutants(const Home& home, const std::vector<Mutant>& mutants,
                                       const MutationOptions& options, const MutationPlan& plan);

// survivors.json: reasons, by shader, line and mutated line.
void giveReasons(std::vector<MutationResult>& results, const Path& file);

int countOf(const std::vector<MutationResult>& results, Fate fate);
int unexplained(const std::vector<MutationResult>& results);

// "112 of 128 caught (88 %), ..."
std::string summaryOf(const std::vector<MutationResult>& results);

// The page mutations.md.
std::string pageOf(const std::vector<MutationResult>& results, const MutationOptions& options);

Json toJson(const Mutant& mutant);
Json toJson(const MutationResult& result);

}  // namespace strobe::mutate
