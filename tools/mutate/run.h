// SPDX-License-Identifier: MIT
// A mutation run: compiles each mutant in a copy of the home folder and runs tests on it until one test fails.
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
  std::string only;  // beginning of the shader paths below shaders/; "" for all
  TestFolder tests;
  Path results;  // results file; updated after each mutant, read at the start
  Path reasons;  // reasons why survivors are harmless (giveReasons)
  int jobs = 1;
  double budget_s = 90;            // time of tests per mutant
  bool again = false;              // test survivors without a reason once more
  std::vector<std::string> first;  // beginnings of the names of tests that run first
};

enum class Fate { Untried, Refused, Equivalent, Caught, Survived };

struct MutationResult {
  Mutant mutant;
  std::string line, mutated_line;  // without the space at both ends
  Fate fate = Fate::Untried;
  bool compiles = false;        // to other code than the original
  std::string by;               // the test that caught it
  int tests = 0, tests_of = 0;  // number of tests run; number of tests that read the shader
  double seconds = 0;
  std::string reason;  // why the surviving mutant is harmless; "" if unknown
};

// Draws mutants by the seed, from the shaders of the home folder that passes use.
std::vector<Mutant> listMutants(const Home& home, const MutationOptions& options, const MutationPlan& plan);

// Tests each mutant, unless the results file has its result.
std::vector<MutationResult> runMutants(const Home& home, const std::vector<Mutant>& mutants,
                                       const MutationOptions& options, const MutationPlan& plan);

// Sets reasons from survivors.json, by shader, line and mutated line.
void giveReasons(std::vector<MutationResult>& results, const Path& file);

int countOf(const std::vector<MutationResult>& results, Fate fate);
int unexplained(const std::vector<MutationResult>& results);

// "112 of 128 caught (88 %), ..."
std::string summaryOf(const std::vector<MutationResult>& results);

// Text of the page mutations.md.
std::string pageOf(const std::vector<MutationResult>& results, const MutationOptions& options);

Json toJson(const Mutant& mutant);
Json toJson(const MutationResult& result);

}  // namespace strobe::mutate
