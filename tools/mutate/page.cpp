// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include "mutate/run.h"

namespace strobe::mutate {

namespace {

// As code in a cell of a table: bars would end the cell.
std::string cell(const std::string& code) {
  std::string text;
  for (char c : code) text += c == '|' ? "\\|" : c == '\n' ? " " : std::string(1, c);
  return text.empty() ? "nothing" : "`" + text + "`";
}

std::string place(const Mutant& mutant) { return fmt::format("{}:{}:{}", mutant.file, mutant.line, mutant.column); }

std::string countsByOperator(const std::vector<MutationResult>& results) {
  std::string text = "| operator | caught | survived | same code | refused |\n|---|---|---|---|---|\n";
  for (MutationOperator op : mutationOperators()) {
    std::vector<MutationResult> own;
    for (const auto& result : results)
      if (result.mutant.op == op) own.push_back(result);
    text += fmt::format("| {} | {} | {} | {} | {} |\n", nameOf(op), countOf(own, Fate::Caught),
                        countOf(own, Fate::Survived), countOf(own, Fate::Equivalent), countOf(own, Fate::Refused));
  }
  return text;
}

std::string survivors(const std::vector<MutationResult>& results) {
  std::string text = "| shader | line | as mutated | tests | why that is harmless |\n|---|---|---|---|---|\n";
  for (const auto& result : results) {
    if (result.fate != Fate::Survived) continue;
    std::string reason = result.reason.empty() ? "**no reason yet**" : result.reason;
    text += fmt::format("| {} | {} | {} | {} of {} | {} |\n", place(result.mutant), cell(result.line),
                        cell(result.mutated_line), result.tests, result.tests_of, reason);
  }
  return text;
}

std::string everything(const std::vector<MutationResult>& results) {
  std::string text = "| shader | operator | was | becomes | outcome |\n|---|---|---|---|---|\n";
  for (const auto& result : results) {
    std::string outcome = result.by;
    if (result.fate == Fate::Survived) outcome = "survived";
    if (result.fate == Fate::Equivalent) outcome = "same code";
    if (result.fate == Fate::Refused) outcome = "refused by the compiler";
    if (result.fate == Fate::Untried) outcome = "not tried";
    text += fmt::format("| {} | {} | {} | {} | {} |\n", place(result.mutant), nameOf(result.mutant.op),
                        cell(result.mutant.before), cell(result.mutant.after), outcome);
  }
  return text;
}

}  // namespace

std::string pageOf(const std::vector<MutationResult>& results, const MutationOptions& options) {
  return fmt::format(
      "# What the tests notice\n\n"
      "One small mistake at a time is put into a copy of the shaders, and tests that read the shader are run until one "
      "fails. Made by `strobe_mutate --seed {} --count {} --write tools/mutate/mutations.md`; the tests that take part "
      "are "
      "named in `plan.json`, the reasons are kept in `survivors.json`.\n\n"
      "**{}.**\n\n"
      "Mutants that compile to the same code under every choice of every pass, or do not compile, count for nothing. "
      "The window's own two shaders (`live/`) are reached by no pass and are left out.\n\n"
      "{}\n## Survivors\n\n{}\n## All mutants\n\n{}",
      options.seed, options.count, summaryOf(results), countsByOperator(results), survivors(results),
      everything(results));
}

}  // namespace strobe::mutate
