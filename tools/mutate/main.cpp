// SPDX-License-Identifier: MIT
// Mutation tool: puts small mistakes into copies of the shaders and reports which mistakes the tests notice.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <cstring>

#include "base/error.h"
#include "mutate/run.h"
#include "script/evaluate.h"

namespace strobe::mutate {

namespace {

struct Options {
  MutationOptions run;
  std::string tests, results, page;
  bool list = false, json = false;
};

// Folder of this program, which also contains strobe and the folder of the test programs.
Path buildFolder() {
  std::error_code failed;
  Path program = std::filesystem::read_symlink("/proc/self/exe", failed);
  if (failed) throw Error(fmt::format("the program cannot find itself: {}", failed.message()));
  return program.parent_path();
}

void list(const Home& home, const Options& options, const MutationPlan& plan) {
  Json all = Json::array();
  for (const Mutant& mutant : listMutants(home, options.run, plan)) {
    all.push_back(toJson(mutant));
    if (!options.json)
      std::printf("%s:%d:%d: %s: %s -> %s\n", mutant.file.c_str(), mutant.line, mutant.column, nameOf(mutant.op),
                  mutant.before.c_str(), mutant.after.c_str());
  }
  if (options.json) std::printf("%s\n", all.dump(2).c_str());
}

void runAll(Options options) {
  const Home home = Home::fromEnvironment();
  const Path tool = home.shipped() / "tools/mutate", build = buildFolder();
  MutationPlan plan = readMutationPlan(tool / "plan.json");
  if (options.list) return list(home, options, plan);
  options.run.tests = {options.tests.empty() ? build / "tests" : Path(options.tests), build / "strobe", home.data()};
  options.run.reasons = tool / "survivors.json";
  options.run.results = options.results.empty() ? build / "mutations.json" : Path(options.results);
  std::vector<Mutant> mutants = listMutants(home, options.run, plan);
  std::vector<MutationResult> results = runMutants(home, mutants, options.run, plan);
  if (!options.page.empty()) writeFileAtomically(options.page, pageOf(results, options.run));
  Json all = Json::array();
  for (const auto& result : results) {
    all.push_back(toJson(result));
    bool open = result.fate == Fate::Survived && result.reason.empty();
    if (open && !options.json)
      std::printf("%s:%d:%d: %s survives as %s\n", result.mutant.file.c_str(), result.mutant.line, result.mutant.column,
                  result.line.c_str(), result.mutated_line.c_str());
  }
  std::printf("%s\n", options.json ? all.dump(2).c_str() : summaryOf(results).c_str());
  if (int open = unexplained(results)) throw Error(fmt::format("{} mutants survive without a reason", open));
}

}  // namespace

static void declare(CLI::App& program, Options& options) {
  program.add_option("--seed", options.run.seed, "which mutants are drawn")->capture_default_str();
  program.add_option("--count", options.run.count, "how many")->check(CLI::PositiveNumber)->capture_default_str();
  program.add_option("--only", options.run.only, "a shader, or how its name begins: lib/, edge/plane.glsl")
      ->type_name("FILE");
  program.add_flag("--list", options.list, "name the mutants and end");
  program.add_option("--tests", options.tests, "folder of the test programs (default: tests, beside the program)")
      ->type_name("DIR");
  program
      .add_option("--results", options.results,
                  "results file, which a later run continues (default: mutations.json, beside the program)")
      ->type_name("FILE");
  program.add_flag("--again", options.run.again, "try those that survived without a reason once more");
  program.add_option("--jobs", options.run.jobs, "mutants at a time")->check(CLI::Range(1, 64))->capture_default_str();
  program.add_option("--first", options.run.first, "tests to try before others, by how their names begin")
      ->type_name("TEST")
      ->delimiter(',');
  program.add_option("--budget", options.run.budget_s, "seconds of tests after which a mutant survives")
      ->capture_default_str();
  program.add_option("--write", options.page, "write the page about it")->type_name("FILE");
  program.add_flag("--json", options.json, "report as JSON");
}

}  // namespace strobe::mutate

int main(int argc, char** argv) {
  // Scripts are evaluated in a child process, which runs this program too.
  if (argc > 1 && std::strcmp(argv[1], "--script-child") == 0) strobe::script::runScriptChild(argc, argv);
  CLI::App program("Put small mistakes into shaders and report the mistakes that the tests notice", "strobe_mutate");
  strobe::mutate::Options options;
  strobe::mutate::declare(program, options);
  try {
    program.parse(argc, argv);
    strobe::mutate::runAll(options);
    return 0;
  } catch (const CLI::ParseError& error) {
    return program.exit(error) == 0 ? 0 : 2;
  } catch (const strobe::Error& error) {
    std::fprintf(stderr, "strobe_mutate: %s\n", error.what());
    return error.exitCode();
  } catch (const std::exception& error) {
    std::fprintf(stderr, "strobe_mutate: %s\n", error.what());
    return 1;
  }
}
