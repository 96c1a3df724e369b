// SPDX-License-Identifier: MIT
#include "app/mutate.h"

#include <cstdio>
#include <memory>

#include "base/error.h"
#include "stability/mutation_run.h"

namespace strobe::app {

namespace {

struct Options {
  stability::MutationOptions run;
  std::string tests, results, page;
  bool list = false, json = false;
};

Path ownProgram() {
  std::error_code failed;
  Path program = std::filesystem::read_symlink("/proc/self/exe", failed);
  if (failed) throw Error(fmt::format("the program cannot find itself: {}", failed.message()));
  return program;
}

void list(const Options& options, const stability::MutationPlan& plan) {
  Json all = Json::array();
  for (const stability::Mutant& mutant : stability::listMutants(options.run, plan)) {
    all.push_back(toJson(mutant));
    if (!options.json)
      std::printf("%s:%d:%d: %s: %s -> %s\n", mutant.file.c_str(), mutant.line, mutant.column, nameOf(mutant.op),
                  mutant.before.c_str(), mutant.after.c_str());
  }
  if (options.json) std::printf("%s\n", all.dump(2).c_str());
}

void mutate(Options options) {
  stability::MutationPlan plan = stability::readMutationPlan(homeFolder() / "tests/stability/mutation.json");
  if (options.list) return list(options, plan);
  Path program = ownProgram();
  options.run.tests = {options.tests.empty() ? program.parent_path() / "tests" : Path(options.tests), program,
                       dataFolder()};
  options.run.reasons = homeFolder() / "docs/mutations_survivors.json";
  options.run.results = options.results.empty() ? program.parent_path() / "mutations.json" : Path(options.results);
  std::vector<stability::Mutant> mutants = stability::listMutants(options.run, plan);
  std::vector<stability::MutationResult> results = stability::runMutants(mutants, options.run, plan);
  if (!options.page.empty()) writeFileAtomically(options.page, stability::pageOf(results, options.run));
  Json all = Json::array();
  for (const auto& result : results) {
    all.push_back(toJson(result));
    bool open = result.fate == stability::Fate::Survived && result.reason.empty();
    if (open && !options.json)
      std::printf("%s:%d:%d: %s survives as %s\n", result.mutant.file.c_str(), result.mutant.line, result.mutant.column,
                  result.line.c_str(), result.mutated_line.c_str());
  }
  std::printf("%s\n", options.json ? all.dump(2).c_str() : stability::summaryOf(results).c_str());
  if (int open = stability::unexplained(results)) throw Error(fmt::format("{} mutants survive without a reason", open));
}

}  // namespace

void registerMutate(CLI::App& program) {
  auto options = std::make_shared<Options>();
  CLI::App* command = program.add_subcommand("mutate", "Put small mistakes into shaders and see whether tests notice");
  command->add_option("--seed", options->run.seed, "which mutants are drawn")->capture_default_str();
  command->add_option("--count", options->run.count, "how many")->check(CLI::PositiveNumber)->capture_default_str();
  command->add_option("--only", options->run.only, "a shader, or how its name begins: lib/, edge/plane.glsl")
      ->type_name("FILE");
  command->add_flag("--list", options->list, "name the mutants and end");
  command->add_option("--tests", options->tests, "folder of the test programs (default: tests, beside the program)")
      ->type_name("DIR");
  command
      ->add_option("--results", options->results,
                   "what is known so far; continued from (default: mutations.json, beside the program)")
      ->type_name("FILE");
  command->add_flag("--again", options->run.again, "try those that survived without a reason once more");
  command->add_option("--jobs", options->run.jobs, "mutants at a time")
      ->check(CLI::Range(1, 64))
      ->capture_default_str();
  command->add_option("--budget", options->run.budget_s, "seconds of tests after which a mutant survives")
      ->capture_default_str();
  command->add_option("--write", options->page, "write the page about it")->type_name("FILE");
  command->add_flag("--json", options->json, "report as JSON");
  command->callback([options] { mutate(*options); });
}

}  // namespace strobe::app
