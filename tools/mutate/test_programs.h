// SPDX-License-Identifier: MIT
// The tests that mutants are tried on: how long each takes, which shaders it reads, and which are likely to notice.
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

// plan.json: which tests of which programs take part, and what the operators must know.
struct MutationPlan {
  struct Program {
    std::string name, filter;  // as googletest reads it
  };
  std::vector<Program> programs;
  double longest_s = 10;  // tests that take longer on the unchanged shaders are left out
  std::map<std::string, std::string> sanitisers;
};
MutationPlan readMutationPlan(const Path& file);

struct TestCase {
  std::string program, name;
  double seconds = 0;                // alone, on the unchanged shaders
  std::vector<std::string> shaders;  // files it reads, below shaders/
  std::string includes;              // what these include: it reads the same ones as long as this is the same
};
Json toJson(const TestCase& test);
TestCase testFromJson(const Json& json);

// Where the test programs are, and what they are started with.
struct TestFolder {
  Path folder;
  Path strobe;  // the program itself, which tests start for scripts
  std::optional<Path> data;
  std::vector<std::string> environment(const Path& home) const;
};

// What a program said of its tests.
struct TestOutcome {
  bool caught = false;
  std::string by;                         // the test, and how it ended where it did not just fail
  std::map<std::string, double> seconds;  // of tests that passed
};
TestOutcome runTests(const TestFolder& tests, const Path& home, const std::string& program,
                     const std::vector<std::string>& names, double limit_s);

// The tests of the plan. Programs that are missing or list none are an `Error`.
std::vector<TestCase> listTests(const TestFolder& tests, const Path& home, const MutationPlan& plan);

// Runs each alone, `jobs` at a time, on an unchanged copy of the home folder, and reports each that passes there.
void surveyTests(const TestFolder& tests, const Path& home, const std::vector<TestCase>& all, int jobs,
                 const std::function<void(const TestCase&)>& passed);

// Those of the tests that fail on the unchanged shaders now.
std::vector<std::string> failingTests(const TestFolder& tests, const Path& home, const std::vector<TestCase>& cases);

// A hash of what each of the shaders includes; one that is gone includes nothing.
std::string includesOf(const Path& home, const std::vector<std::string>& shaders);

// Puts those first that caught most per second, on the same shader above all.
class TestOrder {
 public:
  // `first`: how the names of those begin that come before all others.
  TestOrder(std::vector<TestCase> tests, std::vector<std::string> first)
      : tests_(std::move(tests)), first_(std::move(first)) {}
  // Of those that read the shader, in batches: each for one program, the first ones short.
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
