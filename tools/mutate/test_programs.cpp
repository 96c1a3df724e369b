// SPDX-License-Identifier: MIT
#include "mutate/test_programs.h"

#include <algorithm>
#include <atomic>
#include <set>
#include <sstream>
#include <thread>

#include "base/error.h"
#include "base/hash.h"
#include "base/log.h"
#include "base/process.h"
#include "mutate/home_copy.h"

namespace strobe::mutate {

namespace fs = std::filesystem;

MutationPlan readMutationPlan(const Path& file) {
  MutationPlan plan;
  try {
    Json json = Json::parse(readText(file));
    for (const Json& program : json.at("programs"))
      plan.programs.push_back({program.at("program").get<std::string>(), program.at("filter").get<std::string>()});
    plan.longest_s = json.at("longest_s").get<double>();
    plan.sanitisers = json.at("sanitisers").get<std::map<std::string, std::string>>();
  } catch (const Json::exception& error) {
    throw Error(error.what(), {file.string()});
  }
  return plan;
}

Json toJson(const TestCase& test) {
  return {{"program", test.program},
          {"name", test.name},
          {"seconds", test.seconds},
          {"shaders", test.shaders},
          {"includes", test.includes}};
}

TestCase testFromJson(const Json& json) {
  return {json.at("program").get<std::string>(), json.at("name").get<std::string>(), json.at("seconds").get<double>(),
          json.at("shaders").get<std::vector<std::string>>(), json.at("includes").get<std::string>()};
}

std::vector<std::string> TestFolder::environment(const Path& home) const {
  std::vector<std::string> variables = {"STROBE_HOME=" + home.string(), "STROBE_PROGRAM=" + strobe.string()};
  if (data) variables.push_back("STROBE_DATA=" + fs::absolute(*data).string());
  return variables;
}

namespace {

// Time limit of a test on the unchanged shaders. A software device may have to compile the shaders first.
constexpr double kLongestTest_s = 600;

// Line like "[       OK ] Suite.Name (12 ms)": word, test, seconds.
struct Said {
  std::string word, test;
  double seconds = 0;
};

std::vector<Said> readOutput(const std::string& output) {
  std::vector<Said> all;
  std::istringstream lines(output);
  for (std::string line; std::getline(lines, line);) {
    if (!line.starts_with("[") || line.size() < 14 || line[11] != ']') continue;
    std::istringstream rest(line.substr(12)), inside(line.substr(1, 10));
    Said said;
    std::string bracket;
    inside >> said.word;
    rest >> said.test >> bracket;
    if (said.test.find('.') == std::string::npos) continue;
    while (!said.test.empty() && said.test.back() == ',') said.test.pop_back();
    if (bracket.starts_with("(")) said.seconds = std::atof(bracket.c_str() + 1) / 1000;
    all.push_back(said);
  }
  return all;
}

std::string joined(const std::vector<std::string>& names) { return fmt::format("{}", fmt::join(names, ":")); }

Path programPath(const TestFolder& tests, const std::string& program) {
  Path path = tests.folder / program;
  std::error_code ignored;
  if (!fs::is_regular_file(path, ignored))
    throw Error(fmt::format("the test program {} does not exist: build the tests, or name their folder with --tests",
                            path.string()));
  return fs::absolute(path);
}

ProgramEnd runTestProgram(const TestFolder& tests, const Path& home, const std::string& program,
                          std::vector<std::string> options, double limit_s, std::function<void()> meanwhile = {}) {
  options.insert(options.begin(), programPath(tests, program));
  return run({.arguments = std::move(options),
              .environment = tests.environment(home),
              .errors = Program::Errors::with_output,
              .wall_s = limit_s,
              .output_bytes = size_t{4} << 20,
              .drops_rest = true,
              .meanwhile = std::move(meanwhile)});
}

ProgramEnd runFiltered(const TestFolder& tests, const Path& home, const std::string& program, const std::string& filter,
                       double limit_s, std::function<void()> meanwhile = {}) {
  return runTestProgram(tests, home, program, {"--gtest_filter=" + filter, "--gtest_fail_fast", "--gtest_color=no"},
                        limit_s, std::move(meanwhile));
}

std::vector<std::string> namesOf(const TestFolder& tests, const Path& home, const MutationPlan::Program& program) {
  ProgramEnd end =
      runTestProgram(tests, home, program.name, {"--gtest_list_tests", "--gtest_filter=" + program.filter}, 60);
  if (!end.succeeded()) throw Error(fmt::format("{} lists no tests: {}", program.name, end.output));
  std::vector<std::string> names;
  std::istringstream lines(end.output);
  std::string suite;
  for (std::string line; std::getline(lines, line);) {
    std::string word = line.substr(0, line.find('#'));
    word.erase(0, word.find_first_not_of(' '));
    word.erase(word.find_last_not_of(' ') + 1);
    if (!line.starts_with("  ") && word.ends_with(".")) suite = word;
    else if (line.starts_with("  ") && !suite.empty()) names.push_back(suite + word);
  }
  return names;
}

// Measures the time of a test and the shaders that it reads. Returns the reason to leave the test out, or "".
std::string survey(const TestFolder& tests, const HomeCopy& home, TestCase& test) {
  OpenedFiles opened(home.folder() / "shaders");
  bool complete = true;
  auto look = [&] { complete = opened.collect(test.shaders) && complete; };
  ProgramEnd end = runFiltered(tests, home.folder(), test.program, test.name, kLongestTest_s, look);
  look();
  test.seconds = end.seconds;
  test.includes = includesOf(home.folder(), test.shaders);
  if (!complete) throw Error(fmt::format("{}: too many files were read at once to know which", test.name));
  if (end.timed_out) return fmt::format("takes more than {} s", kLongestTest_s);
  return end.succeeded() ? "" : "fails on the unchanged shaders";
}

}  // namespace

TestOutcome runTests(const TestFolder& tests, const Path& home, const std::string& program,
                     const std::vector<std::string>& names, double limit_s) {
  ProgramEnd end = runFiltered(tests, home, program, joined(names), limit_s);
  TestOutcome outcome;
  outcome.caught = !end.succeeded();
  std::string running;
  for (const Said& said : readOutput(end.output)) {
    if (said.word == "RUN") running = said.test;
    if (said.word == "OK") outcome.seconds[said.test] = said.seconds;
    if (said.word == "FAILED" && outcome.by.empty()) outcome.by = said.test;
  }
  if (!outcome.caught) return outcome;
  if (running.empty()) throw Error(fmt::format("{} ran no test: {}", program, end.output));
  if (outcome.by.empty()) outcome.by = running + (end.timed_out ? " (no end)" : " (crash)");
  return outcome;
}

std::vector<TestCase> listTests(const TestFolder& tests, const Path& home, const MutationPlan& plan) {
  std::vector<TestCase> all;
  for (const auto& program : plan.programs)
    for (const std::string& name : namesOf(tests, home, program)) all.push_back({program.name, name, 0, {}, {}});
  return all;
}

void surveyTests(const TestFolder& tests, const Path& original, const std::vector<TestCase>& all, int jobs,
                 const std::function<void(const TestCase&)>& passed) {
  std::atomic<size_t> next = 0;
  std::mutex mutex;
  std::string failure;
  Progress progress("survey", int(all.size()), "tests");
  int done = 0;
  auto work = [&] {
    try {
      HomeCopy home(original);
      for (size_t i; (i = next++) < all.size();) {
        TestCase test = all[i];
        const std::string problem = survey(tests, home, test);
        std::lock_guard lock(mutex);
        if (problem.empty()) passed(test);
        else warn(test.name + " " + problem + " and takes no part");
        progress.reach(++done);
      }
    } catch (const Error& error) {
      std::lock_guard lock(mutex);
      failure = error.what();
      next = all.size();
    }
  };
  std::vector<std::jthread> workers;
  for (int i = 0; i < jobs; ++i) workers.emplace_back(work);
  workers.clear();
  if (!failure.empty()) throw Error(failure);
}

std::vector<std::string> failingTests(const TestFolder& tests, const Path& home, const std::vector<TestCase>& cases) {
  std::vector<std::string> failing;
  for (const TestCase& test : cases)
    if (runTests(tests, home, test.program, {test.name}, kLongestTest_s).caught) failing.push_back(test.name);
  return failing;
}

std::string includesOf(const Path& home, const std::vector<std::string>& shaders) {
  std::string lines;
  for (const std::string& shader : shaders) {
    const Path file = home / "shaders" / shader;
    std::error_code ignored;
    if (!fs::is_regular_file(file, ignored)) continue;
    std::istringstream text(readText(file));
    for (std::string line; std::getline(text, line);)
      if (line.starts_with("#include")) lines += shader + line + "\n";
  }
  return hashText(lines);
}

double TestOrder::cost(const TestCase& test) const {
  auto found = took_.find(test.name);
  return 0.2 + std::max(test.seconds, found == took_.end() ? 0.0 : found->second);
}

// Expected catches per second. Without catches the value is small, and larger if the test reads fewer shaders.
double TestOrder::worth(const TestCase& test, const std::string& shader) const {
  auto here = caught_in_.find({shader, test.name});
  auto anywhere = caught_.find(test.name);
  bool first = std::any_of(first_.begin(), first_.end(), [&](const auto& name) { return test.name.starts_with(name); });
  double catches = (first ? 1e6 : 0.0) + 2.0 / double(test.shaders.size()) +
                   (here == caught_in_.end() ? 0 : 3.0 * here->second) +
                   (anywhere == caught_.end() ? 0 : 0.3 * anywhere->second);
  return catches / cost(test);
}

std::vector<TestOrder::Batch> TestOrder::batchesFor(const std::string& shader) const {
  std::lock_guard lock(mutex_);
  std::vector<std::pair<double, const TestCase*>> order;
  for (const TestCase& test : tests_)
    if (std::binary_search(test.shaders.begin(), test.shaders.end(), shader))
      order.push_back({worth(test, shader), &test});
  std::stable_sort(order.begin(), order.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
  std::vector<Batch> batches;
  double target_s = 2;
  for (size_t i = 0; i < order.size(); target_s *= 2) {
    double batch_s = 0;
    std::map<std::string, Batch> by_program;
    for (; i < order.size() && batch_s < target_s; ++i) {
      const TestCase& test = *order[i].second;
      Batch& batch = by_program[test.program];
      batch.program = test.program;
      batch.names.push_back(test.name);
      batch.seconds += cost(test);
      batch_s += cost(test);
    }
    for (const auto& [program, batch] : by_program) batches.push_back(batch);
  }
  return batches;
}

void TestOrder::caught(const std::string& shader, const std::string& test) {
  std::lock_guard lock(mutex_);
  std::string name = test.substr(0, test.find(' '));
  ++caught_[name];
  ++caught_in_[{shader, name}];
}

void TestOrder::took(const std::map<std::string, double>& seconds) {
  std::lock_guard lock(mutex_);
  for (const auto& [name, one] : seconds) {
    auto [entry, is_new] = took_.insert({name, one});
    if (!is_new) entry->second = (entry->second + one) / 2;
  }
}

}  // namespace strobe::mutate
