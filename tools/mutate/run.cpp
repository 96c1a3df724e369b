// SPDX-License-Identifier: MIT
#include "mutate/run.h"

#include <algorithm>
#include <atomic>
#include <map>
#include <set>
#include <thread>

#include "base/error.h"
#include "base/hash.h"
#include "base/log.h"
#include "mutate/glsl.h"
#include "mutate/home_copy.h"
#include "mutate/shader_code.h"

namespace strobe::mutate {

namespace {

Path shaderPath(const Path& home, const std::string& file) { return home / "shaders" / file; }

const char* nameOf(Fate fate) {
  switch (fate) {
    case Fate::Untried:
      return "untried";
    case Fate::Refused:
      return "refused";
    case Fate::Equivalent:
      return "equivalent";
    case Fate::Caught:
      return "caught";
    case Fate::Survived:
      return "survived";
  }
  return "";
}

Fate fateNamed(const std::string& name) {
  for (Fate fate : {Fate::Refused, Fate::Equivalent, Fate::Caught, Fate::Survived})
    if (name == nameOf(fate)) return fate;
  return Fate::Untried;
}

// Key of a result: hash of the change and of the text of the shader.
std::string keyOf(const Path& home, const Mutant& mutant) {
  return hashText(fmt::format("{}|{}|{}|{}|{}", mutant.file, hashText(readText(shaderPath(home, mutant.file))),
                              mutant.offset, mutant.before, mutant.after))
      .substr(0, 16);
}

MutationResult resultFor(const Path& home, const Mutant& mutant) {
  std::string text = readText(shaderPath(home, mutant.file));
  std::string line = lineAt(text, mutant.offset), changed = mutated(text, mutant);
  // The first line of a change over several lines.
  return {.mutant = mutant, .line = line, .mutated_line = lineAt(changed, mutant.offset)};
}

// The results file: known results of mutants and known data of tests.
class Kept {
 public:
  Kept(const Path& home, const Path& file) : home_(home), file_(file) {
    std::error_code ignored;
    if (!std::filesystem::exists(file, ignored)) return;
    try {
      json_ = Json::parse(readText(file));
    } catch (const Json::exception& error) {
      throw Error(fmt::format("is not a results file: {}", error.what()), {file.string()});
    }
  }

  void fill(MutationResult& result) const {
    std::string key = keyOf(home_, result.mutant);
    if (!json_.contains("mutants") || !json_["mutants"].contains(key)) return;
    const Json& kept = json_["mutants"][key];
    result.fate = fateNamed(kept.at("fate").get<std::string>());
    result.compiles = result.fate != Fate::Refused && result.fate != Fate::Equivalent;
    result.by = kept.at("by").get<std::string>();
    result.tests = kept.at("tests").get<int>();
    result.tests_of = kept.at("tests_of").get<int>();
    result.seconds = kept.at("seconds").get<double>();
  }

  void put(const MutationResult& result) {
    json_["mutants"][keyOf(home_, result.mutant)] = toJson(result);
    save();
  }

  // Known data of tests by name, without tests with changed includes.
  std::map<std::string, TestCase> survey() const {
    std::map<std::string, TestCase> tests;
    if (!json_.contains("survey")) return tests;
    for (const Json& kept : json_["survey"]) {
      TestCase test = testFromJson(kept);
      if (test.includes == includesOf(home_, test.shaders)) tests[test.name] = test;
    }
    return tests;
  }

  void putSurvey(const std::vector<TestCase>& tests) {
    json_["survey"] = Json::array();
    for (const TestCase& test : tests) json_["survey"].push_back(toJson(test));
    save();
  }

 private:
  void save() const { writeFileAtomically(file_, json_.dump(1) + "\n"); }
  Path home_, file_;
  Json json_;
};

// Tests that take part. New tests, and tests with changed includes, run alone on the unchanged shaders first.
std::vector<TestCase> testsFor(const Path& home, const MutationOptions& options, const MutationPlan& plan, Kept& kept) {
  std::map<std::string, TestCase> known = kept.survey();
  std::vector<TestCase> tests, fresh;
  for (const TestCase& test : listTests(options.tests, home, plan)) {
    auto found = known.find(test.name);
    (found == known.end() ? fresh : tests).push_back(found == known.end() ? test : found->second);
  }
  if (!fresh.empty()) {
    note(fmt::format("running {} tests alone on the unchanged shaders", fresh.size()));
    surveyTests(options.tests, home, fresh, options.jobs, [&](const TestCase& test) {
      tests.push_back(test);
      kept.putSurvey(tests);
    });
  }
  std::erase_if(tests, [&](const TestCase& test) { return test.seconds > plan.longest_s; });
  return tests;
}

// Runs tests until one fails or the time for one mutant is over.
void tryTests(MutationResult& result, const MutationOptions& options, const Path& home, TestOrder& order) {
  const Path file = home / "shaders" / result.mutant.file;
  const std::string text = readText(file);
  writeFileAtomically(file, mutated(text, result.mutant));
  double started_s = clockSeconds();
  result.fate = Fate::Survived;
  result.by.clear();
  result.tests = result.tests_of = 0;
  for (const TestOrder::Batch& batch : order.batchesFor(result.mutant.file)) {
    result.tests_of += int(batch.names.size());
    double spent_s = clockSeconds() - started_s;
    if (result.fate == Fate::Caught || spent_s > options.budget_s) continue;
    TestOutcome outcome = runTests(options.tests, home, batch.program, batch.names, 60 + 15 * batch.seconds);
    result.tests += int(batch.names.size());
    order.took(outcome.seconds);
    if (!outcome.caught) continue;
    result.fate = Fate::Caught;
    result.by = outcome.by;
    order.caught(result.mutant.file, outcome.by);
  }
  result.seconds = clockSeconds() - started_s;
  writeFileAtomically(file, text);
}

// Finds the mutants that compile to other code than the original; the other mutants need no tests.
void compileAll(const Home& home, std::vector<MutationResult>& results, Kept& kept) {
  auto unknown = [](const MutationResult& result) { return result.fate == Fate::Untried && !result.compiles; };
  if (std::none_of(results.begin(), results.end(), unknown)) return;
  note("compiling the mutants");
  ShaderCode code(home);
  Progress progress("compiling", int(results.size()), "mutants");
  int done = 0;
  for (MutationResult& result : results) {
    progress.reach(++done);
    if (!unknown(result)) continue;
    CodeChange change = code.changeBy(result.mutant);
    result.compiles = change == CodeChange::Different;
    if (change == CodeChange::Same) result.fate = Fate::Equivalent;
    if (change == CodeChange::Refused) result.fate = Fate::Refused;
    kept.put(result);
  }
}

void testAll(const Path& original, std::vector<MutationResult>& results, const std::vector<size_t>& wanted,
             const MutationOptions& options, TestOrder& order, Kept& kept) {
  std::atomic<size_t> next = 0;
  std::mutex mutex;
  std::string failure;
  auto work = [&] {
    try {
      HomeCopy home(original);
      for (size_t i; (i = next++) < wanted.size();) {
        MutationResult& result = results[wanted[i]];
        tryTests(result, options, home.folder(), order);
        std::lock_guard lock(mutex);
        kept.put(result);
        note(fmt::format("{}/{} {}:{} {} -> {}: {} ({:.0f} s)", i + 1, wanted.size(), result.mutant.file,
                         result.mutant.line, result.mutant.before, result.mutant.after,
                         result.fate == Fate::Caught ? result.by : nameOf(result.fate), result.seconds));
      }
    } catch (const Error& error) {
      std::lock_guard lock(mutex);
      failure = error.what();
      next = wanted.size();
    }
  };
  std::vector<std::jthread> workers;
  for (int i = 0; i < options.jobs; ++i) workers.emplace_back(work);
  workers.clear();
  if (!failure.empty()) throw Error(failure);
}

// Throws if a test that caught mutants also fails on the unchanged shaders. Resets the results of such tests.
void checkCatchers(const Path& home, std::vector<MutationResult>& results, const std::vector<size_t>& wanted,
                   const MutationOptions& options, const std::vector<TestCase>& tests, Kept& kept) {
  note("running what caught mutants on the unchanged shaders");
  std::set<std::string> names;
  auto nameOf = [](const MutationResult& result) { return result.by.substr(0, result.by.find(' ')); };
  for (size_t i : wanted)
    if (results[i].fate == Fate::Caught) names.insert(nameOf(results[i]));
  std::vector<TestCase> catchers;
  for (const TestCase& test : tests)
    if (names.count(test.name)) catchers.push_back(test);
  std::vector<std::string> failing = failingTests(options.tests, home, catchers);
  if (failing.empty()) return;
  for (size_t i : wanted) {
    if (std::find(failing.begin(), failing.end(), nameOf(results[i])) == failing.end()) continue;
    results[i].fate = Fate::Untried;
    kept.put(results[i]);
  }
  throw Error(fmt::format("fails without any mutant: {}; was a file changed meanwhile?", fmt::join(failing, ", ")));
}

}  // namespace

std::vector<Mutant> listMutants(const Home& home, const MutationOptions& options, const MutationPlan& plan) {
  std::vector<std::vector<Mutant>> by_file;
  std::vector<std::string> files = ShaderCode(home).files();
  Vocabulary words{plan.sanitisers, {}};
  for (const std::string& file : files)
    words.unlike.merge(unlikeArgumentsIn(readText(shaderPath(home.shipped(), file))));
  bool found = false;
  for (const std::string& file : files) {
    if (!file.starts_with(options.only)) continue;
    found = true;
    by_file.push_back(mutantsOf(file, readText(shaderPath(home.shipped(), file)), words));
  }
  if (!found)
    throw Error(fmt::format("no pass reaches a shader '{}'{}", options.only, didYouMean(options.only, files)), {}, 2);
  return drawMutants(by_file, options.seed, options.count);
}

std::vector<MutationResult> runMutants(const Home& original, const std::vector<Mutant>& mutants,
                                       const MutationOptions& options, const MutationPlan& plan) {
  // A snapshot, so that edits during the run do not make tests fail.
  HomeCopy snapshot(original.shipped());
  const Path& home = snapshot.folder();
  Kept kept(home, options.results);
  std::vector<MutationResult> results;
  for (const Mutant& mutant : mutants) {
    results.push_back(resultFor(home, mutant));
    kept.fill(results.back());
  }
  giveReasons(results, options.reasons);
  for (MutationResult& result : results)
    if (options.again && result.fate == Fate::Survived && result.reason.empty()) result.fate = Fate::Untried;
  compileAll(Home({home}, original.data(), original.program()), results, kept);
  std::vector<size_t> wanted;
  for (size_t i = 0; i < results.size(); ++i)
    if (results[i].fate == Fate::Untried) wanted.push_back(i);
  if (wanted.empty()) return results;
  std::vector<TestCase> tests = testsFor(home, options, plan, kept);
  for (const std::string& name : options.first)
    if (std::none_of(tests.begin(), tests.end(), [&](const TestCase& test) { return test.name.starts_with(name); }))
      throw Error(fmt::format("--first: the name of no test that takes part begins with '{}'", name), {}, 2);
  TestOrder order(tests, options.first);
  for (const MutationResult& result : results)
    if (result.fate == Fate::Caught) order.caught(result.mutant.file, result.by);
  testAll(home, results, wanted, options, order, kept);
  checkCatchers(home, results, wanted, options, tests, kept);
  return results;
}

void giveReasons(std::vector<MutationResult>& results, const Path& file) {
  std::error_code ignored;
  if (!std::filesystem::exists(file, ignored)) return;
  try {
    for (const Json& known : Json::parse(readText(file)))
      for (MutationResult& result : results)
        if (known.at("shader") == result.mutant.file && known.at("line") == result.line &&
            known.at("mutated") == result.mutated_line)
          result.reason = known.at("reason").get<std::string>();
  } catch (const Json::exception& error) {
    throw Error(error.what(), {file.string()});
  }
}

int countOf(const std::vector<MutationResult>& results, Fate fate) {
  return int(std::count_if(results.begin(), results.end(), [&](const auto& result) { return result.fate == fate; }));
}

int unexplained(const std::vector<MutationResult>& results) {
  return int(std::count_if(results.begin(), results.end(),
                           [](const auto& result) { return result.fate == Fate::Survived && result.reason.empty(); }));
}

std::string summaryOf(const std::vector<MutationResult>& results) {
  int caught = countOf(results, Fate::Caught), survived = countOf(results, Fate::Survived);
  double share = caught + survived > 0 ? 100.0 * caught / (caught + survived) : 0;
  return fmt::format(
      "{} of {} caught ({:.0f} %), {} survived ({} without a reason); not counted: {} compile to the same code, {} do "
      "not compile",
      caught, caught + survived, share, survived, unexplained(results), countOf(results, Fate::Equivalent),
      countOf(results, Fate::Refused));
}

Json toJson(const Mutant& mutant) {
  return {{"shader", mutant.file},         {"line", mutant.line},     {"column", mutant.column},
          {"operator", nameOf(mutant.op)}, {"before", mutant.before}, {"after", mutant.after}};
}

Json toJson(const MutationResult& result) {
  Json json = toJson(result.mutant);
  json["text"] = result.line;
  json["mutated"] = result.mutated_line;
  json["fate"] = nameOf(result.fate);
  json["by"] = result.by;
  json["tests"] = result.tests;
  json["tests_of"] = result.tests_of;
  json["seconds"] = result.seconds;
  if (!result.reason.empty()) json["reason"] = result.reason;
  return json;
}

}  // namespace strobe::mutate
