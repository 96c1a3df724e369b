// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstdio>
#include <memory>

#include "app/commands.h"
#include "app/shot_options.h"
#include "gpu/choice.h"
#include "stability/extremes.h"
#include "stability/suite.h"

namespace strobe::app {

namespace {

struct StabilityOptions {
  std::vector<std::string> pipelines;
  stability::Options suite;
  std::string device, write;
  bool json = false, extremes = false;
};

// Declared breaks without a failing case. Empty unless all invariants and variants ran: a partial run leaves
// declarations without a case.
std::vector<stability::Declaration> staleIn(const StabilityOptions& options,
                                            const std::vector<stability::StabilityReport>& reports) {
  bool all = options.suite.invariants.empty() && options.suite.only.empty();
  return all ? stability::stale(reports, options.pipelines.empty()) : std::vector<stability::Declaration>();
}

Json jsonOf(const std::vector<stability::StabilityReport>& reports, const std::vector<stability::Declaration>& stale) {
  Json json;
  for (const auto& report : reports) json["pipelines"].push_back(stability::toJson(report));
  json["stale"] = Json::array();
  for (const auto& one : stale) json["stale"].push_back({{"with", one.where}, {"invariant", one.invariant}});
  return json;
}

// Runs every extreme case with every pipeline and preset.
void runExtremes(const Home& home, const StabilityOptions& options) {
  lab::Workbench bench(home, options.device, validationWanted());
  std::vector<stability::Variant> methods = stability::methodsOf(home, bench.limits);
  std::vector<stability::ExtremeOutcome> outcomes;
  const stability::Extremes extremes = stability::readExtremes(home, bench.limits);
  for (const stability::Extreme& extreme : extremes.cases)
    for (auto& outcome : stability::runExtreme(bench, methods, extremes, extreme))
      outcomes.push_back(std::move(outcome));
  std::fputs(stability::textOf(outcomes).c_str(), stdout);
  if (!options.write.empty()) writeFileAtomically(options.write, stability::pageOf(outcomes));
  auto failed = std::count_if(outcomes.begin(), outcomes.end(), [](const auto& o) { return !o.failures.empty(); });
  if (failed) throw Error(fmt::format("{} of {} extreme cases fail", failed, outcomes.size()));
}

void run(const Home& home, const StabilityOptions& options) {
  if (options.extremes) return runExtremes(home, options);
  for (const std::string& name : options.suite.invariants) stability::invariantNamed(name);
  // Report mistakes before a device is created.
  for (const std::string& name : options.pipelines) script::evaluatePipeline(home, {name, {}});
  lab::Workbench bench(home, options.device, validationWanted());
  lab::Batch batch(bench);
  std::vector<std::string> pipelines = options.pipelines.empty() ? script::pipelineNames(home) : options.pipelines;
  std::vector<stability::StabilityReport> reports;
  int failed = 0;
  for (const std::string& pipeline : pipelines) {
    reports.push_back(stability::check(batch, pipeline, options.suite));
    failed += reports.back().total().failed;
    if (!options.json) std::fputs(stability::textOf(reports.back()).c_str(), stdout), std::fflush(stdout);
  }
  bench.device().refuseMessages();
  std::vector<stability::Declaration> stale = staleIn(options, reports);
  if (options.json) std::printf("%s\n", jsonOf(reports, stale).dump(2).c_str());
  if (!options.write.empty()) writeFileAtomically(options.write, stability::pageOf(reports, options.suite));
  for (const auto& one : stale)
    if (!options.json)
      std::printf("declared, but it holds in all %d cases: %s breaks %s\n", one.used, one.where.c_str(),
                  one.invariant.c_str());
  if (failed || !stale.empty())
    throw Error(fmt::format("{} cases break an invariant, {} declared breaks do not occur", failed, stale.size()));
}

}  // namespace

void registerStability(CLI::App& program, const Home& home) {
  auto options = std::make_shared<StabilityOptions>();
  CLI::App* command = program.add_subcommand("stability", "Check invariants of every blur on generated scenes");
  command->add_option("pipelines", options->pipelines, "names or .lua files (default: every pipeline that ships)");
  command->add_option("--cases", options->suite.cases, "number of cases for each variant and invariant")
      ->check(CLI::Range(1, 100000));
  command->add_option("--seed", options->suite.seed, "seed of the random cases");
  command->add_option("--invariant", options->suite.invariants, "NAME: check only this invariant (repeatable)")
      ->allow_extra_args(false);
  command->add_option("--variant", options->suite.only, "check only variants with this text in the name");
  command->add_option("--device", options->device, gpu::kDeviceHelp);
  command->add_flag("--extremes", options->extremes,
                    "check the extreme cases instead (sizes, scales, offsets, near plane ...)");
  command->add_flag("--json", options->json, "report as JSON");
  command->add_option("--write", options->write, "write the table of counts")->type_name("FILE");
  command->callback([options, &home] { run(home, *options); });
}

}  // namespace strobe::app
