// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include "mutate/run.h"
#include "page/table.h"

namespace strobe::mutate {

namespace {

std::string code(const std::string& text) { return text.empty() ? "nothing" : "`" + text + "`"; }

std::string place(const Mutant& mutant) { return fmt::format("{}:{}:{}", mutant.file, mutant.line, mutant.column); }

page::Table countsByOperator(const std::vector<MutationResult>& results) {
  page::Table table{"", {"operator", {"caught", true}, {"survived", true}, {"same code", true}, {"refused", true}}};
  for (MutationOperator op : mutationOperators()) {
    std::vector<MutationResult> own;
    for (const auto& result : results)
      if (result.mutant.op == op) own.push_back(result);
    page::Row row = {nameOf(op)};
    for (Fate fate : {Fate::Caught, Fate::Survived, Fate::Equivalent, Fate::Refused})
      row.push_back(std::to_string(countOf(own, fate)));
    table.add(row);
  }
  return table;
}

page::Table survivors(const std::vector<MutationResult>& results) {
  page::Table table{"", {"shader", "line", "as mutated", "tests", "why that is harmless"}};
  for (const auto& result : results) {
    if (result.fate != Fate::Survived) continue;
    bool open = result.reason.empty();
    table.add({place(result.mutant), code(result.line), code(result.mutated_line),
               fmt::format("{} of {}", result.tests, result.tests_of),
               open ? page::TableCell("no reason yet", page::Emphasis::bad) : page::TableCell(result.reason)});
  }
  return table;
}

page::Table everything(const std::vector<MutationResult>& results) {
  page::Table table{"", {"shader", "operator", "was", "becomes", "outcome"}};
  for (const auto& result : results) {
    std::string outcome = result.by;
    if (result.fate == Fate::Survived) outcome = "survived";
    if (result.fate == Fate::Equivalent) outcome = "same code";
    if (result.fate == Fate::Refused) outcome = "refused by the compiler";
    if (result.fate == Fate::Untried) outcome = "not tried";
    table.add({place(result.mutant), nameOf(result.mutant.op), code(result.mutant.before), code(result.mutant.after),
               outcome});
  }
  return table;
}

}  // namespace

std::string pageOf(const std::vector<MutationResult>& results, const MutationOptions& options) {
  return fmt::format(
      "# Mistakes that the tests notice\n\n"
      "One small mistake at a time is put into a copy of the shaders, and tests that read the shader are run until one "
      "fails. Each test compiles the changed shader again. For a mistake in a file that many shaders include, the time "
      "(`--budget`) suffices only for some tests: first the tests named by `--first`, then the tests with the most "
      "catches. Made by `strobe_mutate --seed {} --count {} --write tools/mutate/mutations.md`. `plan.json` names the "
      "tests that take part, `survivors.json` has the reasons.\n\n"
      "**{}.**\n\n"
      "Mutants that compile to the same code under every choice of every pass, or do not compile, are not counted. "
      "The window's own two shaders (`live/`) are reached by no pass and are left out.\n\n"
      "{}\n## Survivors\n\n{}\n## All mutants\n\n{}",
      options.seed, options.count, summaryOf(results), markdownOf(countsByOperator(results)),
      markdownOf(survivors(results)), markdownOf(everything(results)));
}

}  // namespace strobe::mutate
