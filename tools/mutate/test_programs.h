// SPDX-License-Identifier: MIT
// Tests for mutants: the time of each test, the shaders that it reads, and an order by the expected number of catches.
#pragma once

#include <functional>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "base/files.h"
#include "base/json.h"
#include "mutate/mutants.h"

namespace strobe::mutate {

// plan.json: the test programs and tests that take part, and the sanitisers for the operators.
struct MutationPlan {
  struct Program {
    std::string name, filter;  // in the syntax of --gtest_filter
  };
  std::vector<Program> programs;
  double longest_s = 10;  // tests that take longer on the unchanged shaders are left out
  std::map<std::string, std::string> sanitisers;
};
MutationPlan readMutationPlan(const Path& file);

struct TestCase {
  std::string program, name;
  double seconds = 0;                // of a run alone, on the unchanged shaders
  std::vector<std::string> shaders;  // files it reads, below shaders/
  std::string includes;              // hash of their includes (includesOf); `shaders` is valid until the hash changes
};
Json toJson(const TestCase& test);
TestCase testFromJson(const Json& json);

// Folder of the test programs, and their environment.
struct TestFolder {
  Path folder;
  Path strobe;  // the program itself, which tests start for scripts
  std::optional<Path> data;
  std::vector<std::string> environment(const Path& home) const;
};

// Result of a run of tests of one program.
struct TestOutcome {
  bool caught = false;
  std::string by;                         // the failed test; " (crash)" or " (no end)" follows if it did not finish
  std::map<std::string, double> seconds;  // of tests that passed
};
TestOutcome runTests(const TestFolder& tests, const Path& home, const std::string& program,
                     const std::vector<std::string>& names, double limit_s);

// Tests of the plan. Throws `Error` if a program is missing or fails to list its tests.
std::vector<TestCase> listTests(const TestFolder& tests, const Path& home, const MutationPlan& plan);

// Runs each test alone on an unchanged copy of the home folder, `jobs` tests in parallel. Calls `passed` for each test
// that passes.
void surveyTests(const TestFolder& tests, const Path& home, const std::vector<TestCase>& all, int jobs,
                 const std::function<void(const TestCase&)>& passed);

// Names of the tests that fail on the unchanged shaders.
std::vector<std::string> failingTests(const TestFolder& tests, const Path& home, const std::vector<TestCase>& cases);

// Hash of the includes of the shaders; missing files are skipped.
std::string includesOf(const Path& home, const std::vector<std::string>& shaders);

// Order of tests by catches per second; catches on the same shader count most.
class TestOrder {
 public:
  // `first`: beginnings of the names of tests that come before all other tests.
  TestOrder(std::vector<TestCase> tests, std::vector<std::string> first)
      : tests_(std::move(tests)), first_(std::move(first)) {}
  // Batch of tests that read a shader, for one program. The first batches are short.
  struct Batch {
    std::string program;
    std::vector<std::string> names;
    double seconds = 0;  // expected
  };
  std::vector<Batch> batchesFor(const std::string& shader) const;
  void caught(const std::string& shader, const std::string& test);
  void took(const std::map<std::string, double>& seconds);

 private:
  double worth(const TestCase& test, const std::string& shader) const;
  double cost(const TestCase& test) const;

  mutable std::mutex mutex_;
  std::vector<TestCase> tests_;
  std::vector<std::string> first_;
  std::map<std::string, int> caught_;
  std::map<std::pair<std::string, std::string>, int> caught_in_;  // by shader and test
  std::map<std::string, double> took_;
};

}  // namespace strobe::mutate
