// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "base/numbers.h"
#include "study/effects.h"
#include "study/gallery.h"
#include "study/report.h"

namespace strobe::study {

namespace {

std::string signedNumber(double value) { return std::isnan(value) ? "–" : fmt::format("{:+.3g}", value); }

std::string intervalText(const Estimate& estimate) {
  if (std::isnan(estimate.low)) return "–";
  return signedNumber(estimate.low) + " to " + signedNumber(estimate.high);
}

// Mark of an interval that does not contain 0.
page::Emphasis markOf(const Estimate& estimate) {
  return estimate.low > 0 || estimate.high < 0 ? page::Emphasis::best : page::Emphasis::none;
}

std::string basisOf(const FactorEffect& one) {
  if (one.comparison == LevelComparison::slope) return fmt::format("line through {} points", one.points);
  if (one.comparison == LevelComparison::unpaired) return "unpaired";
  std::string text = countText(size_t(one.effect.blocks), "block");
  return one.effect.incomplete ? text + fmt::format(", {} incomplete left out", one.effect.incomplete) : text;
}

void addEstimate(page::Table& table, const std::string& factor, const std::string& level, const Estimate& estimate,
                 const std::string& basis) {
  page::Emphasis mark = markOf(estimate);
  table.add(
      {factor, level, {estimate.value, signedNumber(estimate.value), mark}, {intervalText(estimate), mark}, basis});
}

page::Table mainTable(const Effects& effects) {
  page::Table table;
  table.columns = {"factor", "level", {"effect", true}, {"95 % interval", true}, "compared in"};
  for (const FactorEffect& one : effects.main) {
    const Factor& factor = effects.factors[one.factor];
    if (one.comparison == LevelComparison::slope)
      addEstimate(table, factor.name, one.doubling ? "per doubling" : "per unit", one.slope, basisOf(one));
    for (size_t level = 0; level < one.effect.levels.size(); ++level)
      addEstimate(table, factor.name, factor.labels[level], one.effect.levels[level], basisOf(one));
  }
  return table;
}

// Table of the `most` largest interactions over all pairs.
page::Table pairTable(const Effects& effects, size_t most) {
  struct Cell {
    const PairEffect* pair;
    size_t index;  // of the estimate
    const Estimate* estimate;
  };
  std::vector<Cell> cells;
  for (const PairEffect& pair : effects.pairs)
    for (size_t i = 0; i < pair.interaction.levels.size(); ++i)
      cells.push_back({&pair, i, &pair.interaction.levels[i]});
  std::stable_sort(cells.begin(), cells.end(), [](const Cell& a, const Cell& b) {
    return std::abs(a.estimate->value) > std::abs(b.estimate->value);
  });
  if (cells.size() > most) cells.resize(most);
  page::Table table;
  table.columns = {"pair", "levels", {"interaction", true}, {"95 % interval", true}, "blocks"};
  for (const Cell& cell : cells) {
    const Factor &first = effects.factors[cell.pair->first], &second = effects.factors[cell.pair->second];
    page::Emphasis mark = markOf(*cell.estimate);
    table.add({first.name + " × " + second.name,
               first.labels[cell.index / second.levels()] + ", " + second.labels[cell.index % second.levels()],
               {cell.estimate->value, signedNumber(cell.estimate->value), mark},
               {intervalText(*cell.estimate), mark},
               fmt::format("{}", cell.pair->interaction.blocks)});
  }
  return table;
}

}  // namespace

Parts effectParts(const Results& results) {
  FirstView view = firstViewOf(results);
  Parts parts = {heading("Effects", 2, "effects", ReportPart::kPage),
                 text(kHowToReadEffects, Tone::soft, ReportPart::kPage)};
  size_t start = parts.size();
  for (const ShotSummary& shot : results.shots) {
    Effects effects = effectsOf(results, shot.name, view.y, view.region);
    if (effects.factors.size() < 2) continue;
    parts.push_back(heading(shot.title + ": " + headOf(measureNamed(view.y), view.region), 3, "", ReportPart::kPage));
    parts.push_back({mainTable(effects), ReportPart::kPage});
    if (!effects.pairs.empty()) parts.push_back({pairTable(effects, 12), ReportPart::kPage});
  }
  return parts.size() == start ? Parts() : parts;
}

}  // namespace strobe::study
