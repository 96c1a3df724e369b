// SPDX-License-Identifier: MIT
#include "stability/suite.h"

#include <algorithm>

#include "base/lists.h"
#include "page/table.h"
#include "stability/shrink.h"

namespace strobe::stability {

// Minimum number of cases for a stale declaration. Some breaks are rare: 60 cases miss a break that occurs in 5 % of
// all cases with a probability of 0.95^60 = 5 %.
static constexpr int kEnough = 60;

namespace {

std::vector<const Invariant*> wanted(const Options& options) {
  std::vector<const Invariant*> list;
  for (const Invariant& one : invariants())
    if (options.invariants.empty() || contains(options.invariants, one.name)) list.push_back(&one);
  for (const std::string& name : options.invariants) invariantNamed(name);
  return list;
}

// The run of one pipeline.
class Suite {
 public:
  Suite(lab::Batch& batch, const std::string& pipeline, const Options& options)
      : batch_(batch), options_(options), invariants_(wanted(options)) {
    report_.pipeline = pipeline;
  }

  StabilityReport run() {
    int before = batch_.drawn();
    VariantList found = walk(batch_, report_.pipeline);
    report_.refused = found.refused;
    report_.same = found.same;
    int number = 0;
    for (const Variant& variant : found.variants) {
      if (number++ % options_.shards != options_.shard) continue;
      if (variant.name().find(options_.only) == std::string::npos) continue;
      report_.variants.push_back({variant.name(), {}});
      for (int i = 0; i < options_.cases; ++i) checkCase(variant, i);
      batch_.forgetColorsOf(variant.pipeline);
    }
    report_.pictures = batch_.drawn() - before;
    return std::move(report_);
  }

 private:
  void checkCase(const Variant& variant, int index) {
    lab::Shot shot = generated(variant, options_.seed, index + caseOf(variant));
    const bool accepted = batch_.accepts(shot.pipeline, shot.sets);
    bool any = false;
    for (const Invariant* invariant : invariants_) {
      bool taken =
          variant.isBase() || Random(options_.seed, variant.name() + invariant->name).whole(1, options_.thinned) == 1;
      if (!taken) continue;
      any = true;
      Count& count = report_.variants.back().second[invariant->name];
      if (accepted) checkOne(variant, *invariant, shot, count);
      else ++count.refused;
    }
    if (!any) return;
    ++report_.drawn;
    if (accepted) report_.blurred += blurs(batch_, shot);
  }

  // Index of a variant's first scene: variants take turns with the scenes.
  static int caseOf(const Variant& variant) { return Random(0, variant.name()).whole(0, 7); }

  Finding findingOf(const Invariant& invariant, const Variant& variant, const lab::Shot& shot) {
    return invariant.check({batch_, *batch_.evaluate(shot.pipeline, shot.sets), variant.isBase(), shot});
  }

  void checkOne(const Variant& variant, const Invariant& invariant, const lab::Shot& shot, Count& count) {
    Finding finding;
    try {
      finding = findingOf(invariant, variant, shot);
    } catch (const lab::Refusal& refusal) {
      ++count.refused;
      report_.refused.push_back({variant.name() + ", " + invariant.name, refusal.what()});
      return;
    } catch (const Error& error) {
      ++count.failed;
      report_.failures.push_back({variant.name(), invariant.name, error.what(), {lab::commandOf(shot)}});
      return;
    }
    if (!finding.applies) return;
    std::vector<Declared> declared = declaredBreaks(*batch_.evaluate(shot.pipeline, shot.sets), invariant.name);
    for (const Declared& one : declared) {
      Declaration& known = report_.declarations[one.key];
      known.where = one.where;
      known.invariant = invariant.name;
      known.reason = one.reason;
      ++known.used;
      known.seen += !finding.holds;
    }
    if (finding.holds) ++count.held;
    else if (!declared.empty()) ++count.broken;
    else fail(variant, invariant, shot, count);
  }

  void fail(const Variant& variant, const Invariant& invariant, const lab::Shot& shot, Count& count) {
    ++count.failed;
    noteRounding(*variant.description);
    auto still_fails = [&](const lab::Shot& candidate) {
      Finding finding = findingOf(invariant, variant, candidate);
      return finding.applies && !finding.holds;
    };
    bool enough = report_.failures.size() >= 8;  // shrinking is slow; further failures are reported as found
    lab::Shot small = enough ? shot : shrunk(shot, *variant.description, variant.sets, still_fails);
    Finding finding = findingOf(invariant, variant, small);
    Failure failure{variant.name(), invariant.name, finding.text, {}};
    for (const lab::Shot& one : finding.shots) failure.commands.push_back(lab::commandOf(one));
    report_.failures.push_back(failure);
  }

  void noteRounding(const plan::PipelineDesc& pipeline) {
    for (const plan::PassDesc& pass : pipeline.passes)
      for (const auto* ports : {&pass.writes, &pass.updates})
        for (const plan::PortDesc& port : *ports)
          if (port.format.ends_with("16f")) report_.rounded.insert(pass.name + "." + port.name + ", " + port.format);
  }

  lab::Batch& batch_;
  Options options_;
  std::vector<const Invariant*> invariants_;
  StabilityReport report_;
};

}  // namespace

StabilityReport check(lab::Batch& batch, const std::string& pipeline, const Options& options) {
  return Suite(batch, pipeline, options).run();
}

Count StabilityReport::total(const std::string& invariant) const {
  Count sum;
  for (const auto& [variant, counts] : variants)
    for (const auto& [name, count] : counts) {
      if (!invariant.empty() && name != invariant) continue;
      sum.held += count.held;
      sum.broken += count.broken;
      sum.failed += count.failed;
      sum.refused += count.refused;
    }
  return sum;
}

static std::map<std::string, Declaration> merged(const std::vector<StabilityReport>& reports) {
  std::map<std::string, Declaration> all;
  for (const StabilityReport& report : reports)
    for (const auto& [key, one] : report.declarations) {
      Declaration& sum = all[key];
      int used = sum.used + one.used, seen = sum.seen + one.seen;
      sum = one;
      sum.used = used;
      sum.seen = seen;
    }
  return all;
}

std::vector<Declaration> stale(const std::vector<StabilityReport>& reports, bool all_pipelines) {
  std::vector<Declaration> list;
  for (const auto& [key, one] : merged(reports)) {
    const bool whole = all_pipelines || one.where.starts_with("pipeline ");
    if (whole && one.seen == 0 && one.used >= kEnough) list.push_back(one);
  }
  return list;
}

// ---- as text

// Number of failed cases by invariant, and formats that may be the reason.
static std::string summaryOf(const StabilityReport& report) {
  std::vector<std::string> parts;
  for (const Invariant& one : invariants()) {
    Count sum = report.total(one.name);
    if (sum.failed)
      parts.push_back(fmt::format("{} {} of {}", one.name, sum.failed, sum.held + sum.broken + sum.failed));
  }
  if (parts.empty()) return "";
  std::string text = fmt::format("  failed by invariant: {}\n", fmt::join(parts, ", "));
  if (report.rounded.empty()) return text;
  return text +
         fmt::format(
             "  16-bit floats round by up to 1/2048 (4.9e-4) of a value; most invariants allow 1e-5 or nothing: {}; "
             "rgba32f shows whether the rounding is the cause\n",
             fmt::join(report.rounded, "; "));
}

std::string textOf(const StabilityReport& report) {
  Count sum = report.total();
  std::string text = fmt::format(
      "{}: {} variants, {} values that change nothing, {} refused; {} cases hold, {} break as declared, {} refused, "
      "{} failed ({} pictures)\n",
      report.pipeline, report.variants.size(), report.same, report.refused.size(), sum.held, sum.broken, sum.refused,
      sum.failed, report.pictures);
  for (const Failure& failure : report.failures) {
    text += fmt::format("  FAILED {} with {}\n    {}\n", failure.invariant, failure.variant, failure.text);
    for (const std::string& command : failure.commands) text += "    " + command + "\n";
  }
  return text + summaryOf(report);
}

// A number of cases; empty for 0.
static page::TableCell countCell(int count, page::Emphasis mark = page::Emphasis::none) {
  if (count == 0) return {};
  return {std::to_string(count), mark};
}

static page::Table totalsOf(const StabilityReport& report) {
  page::Table table{"", {"invariant"}};
  for (const char* what : {"hold", "break as declared", "refused", "failed"}) table.columns.push_back({what, true});
  auto add = [&](const std::string& name, const Count& sum) {
    table.add({name, countCell(sum.held), countCell(sum.broken), countCell(sum.refused),
               countCell(sum.failed, page::Emphasis::bad)});
  };
  for (const Invariant& one : invariants()) {
    Count sum = report.total(one.name);
    if (sum.held + sum.broken + sum.refused + sum.failed > 0) add(one.name, sum);
  }
  add("all", report.total());
  return page::withoutEmptyColumns(table);
}

// Invariants with a case that does not hold, and the number of such cases: "mirrored, shifted (2 of 3, refused)".
static std::string exceptionsIn(const std::map<std::string, Count>& counts) {
  std::vector<std::string> parts;
  for (const Invariant& one : invariants()) {
    auto found = counts.find(one.name);
    if (found == counts.end()) continue;
    const Count& count = found->second;
    int other = count.broken + count.refused + count.failed, all = count.held + other;
    if (other == 0) continue;
    std::vector<std::string> notes;
    if (all > 1) notes.push_back(fmt::format("{} of {}", other, all));
    if (count.refused) notes.push_back("refused");
    if (count.failed) notes.push_back("**failed**");
    parts.push_back(one.name + (notes.empty() ? "" : fmt::format(" ({})", fmt::join(notes, ", "))));
  }
  return fmt::format("{}", fmt::join(parts, ", "));
}

// Variants with equal exceptions share a row.
static page::Table exceptionsOf(const StabilityReport& report) {
  std::vector<std::pair<std::string, std::vector<std::string>>> groups;
  for (const auto& [variant, counts] : report.variants) {
    std::string text = exceptionsIn(counts);
    if (text.empty()) continue;
    auto group = std::find_if(groups.begin(), groups.end(), [&](const auto& one) { return one.first == text; });
    if (group == groups.end()) group = groups.insert(groups.end(), {text, {}});
    group->second.push_back("`" + variant + "`");
  }
  page::Table table{"", {"not held", {"variants", true}, "names"}};
  for (const auto& [text, variants] : groups)
    table.add({text, std::to_string(variants.size()), fmt::format("{}", fmt::join(variants, ", "))});
  return table;
}

static std::string refusalsOf(const StabilityReport& report) {
  std::map<std::string, std::string> reasons;
  for (const Refused& one : report.refused) reasons.emplace(one.name, one.reason);
  std::string text = reasons.empty() ? "" : "Refused settings, each with the message of the program:\n\n";
  for (const auto& [name, reason] : reasons) text += fmt::format("- `{}`: {}\n", name, reason);
  return reasons.empty() ? "" : text + "\n";
}

static std::string sectionOf(const StabilityReport& report) {
  auto holds_all = [](const auto& variant) { return exceptionsIn(variant.second).empty(); };
  auto whole = std::count_if(report.variants.begin(), report.variants.end(), holds_all);
  std::string text = fmt::format(
      "## {}\n\nChecked variants: {}. Variants that hold every invariant: {}. Further values, not checked because they "
      "give the plan of a checked variant: {}.\n\n{}\n",
      report.pipeline, report.variants.size(), whole, report.same, page::markdownOf(totalsOf(report)));
  std::string exceptions = page::markdownOf(exceptionsOf(report));
  if (!exceptions.empty()) text += exceptions + "\n";
  return text + refusalsOf(report);
}

std::string pageOf(const std::vector<StabilityReport>& reports, const Options& options) {
  std::string text =
      "<!-- Written by `strobe stability --write docs/stability.md`; do not edit. -->\n\n# Invariants held\n\n";
  text += fmt::format(
      "`strobe stability` checks [invariants](invariants.md), properties that every blur has, on generated scenes. A "
      "variant is one setting of a pipeline. Cases per variant and invariant: {}; random seed: {}.\n\nFor each "
      "pipeline, the first table counts the cases by invariant: cases that hold, cases that break the invariant as the "
      "pipeline declares, cases that the pipeline refuses, and failed cases. The second table lists the variants that "
      "do not hold all invariants. The last table of the page has the declared breaks with their reasons.\n\n",
      options.cases, options.seed);
  for (const StabilityReport& report : reports) text += sectionOf(report);
  page::Table declared{"", {"with", "invariant", "broken in", "reason"}};
  for (const auto& [key, one] : merged(reports))
    declared.add({"`" + one.where + "`", one.invariant, fmt::format("{} of {} cases", one.seen, one.used), one.reason});
  return text +
         "## Declared breaks\n\nA pass, a pipeline or a value of a parameter may break an invariant by design, and "
         "then declares the reason. The third column has the number of cases that break the invariant, of all cases "
         "with the pass, pipeline or value.\n\n" +
         page::markdownOf(declared);
}

Json toJson(const StabilityReport& report) {
  Json json;
  json["pipeline"] = report.pipeline;
  json["same"] = report.same;
  for (const auto& [variant, counts] : report.variants)
    for (const auto& [invariant, count] : counts)
      json["variants"][variant][invariant] = {
          {"held", count.held}, {"broken", count.broken}, {"refused", count.refused}, {"failed", count.failed}};
  json["refused"] = Json::array();
  for (const Refused& one : report.refused) json["refused"].push_back({{"what", one.name}, {"reason", one.reason}});
  json["declared"] = Json::array();
  for (const auto& [key, one] : report.declarations)
    json["declared"].push_back({{"with", one.where},
                                {"invariant", one.invariant},
                                {"reason", one.reason},
                                {"cases", one.used},
                                {"seen", one.seen}});
  json["failures"] = Json::array();
  for (const Failure& one : report.failures)
    json["failures"].push_back(
        {{"variant", one.variant}, {"invariant", one.invariant}, {"text", one.text}, {"commands", one.commands}});
  return json;
}

}  // namespace strobe::stability
