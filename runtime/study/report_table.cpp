// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "base/lists.h"
#include "page/number.h"
#include "study/curves.h"
#include "study/gallery.h"
#include "study/report.h"

namespace strobe::study {

namespace {

// ---- along one axis

// Table of the groups on one axis and no other: rows by arm and value, columns by shot.
class AxisTable {
 public:
  AxisTable(const Results& results, const AxisSummary& axis, const TableLayout& layout)
      : results_(results), axis_(axis), layout_(layout) {
    for (const PointGroup& group : results.groups) {
      if (group.at.size() != 1 || group.at[0].first != axis.name) continue;
      groups_.push_back(&group);
      addOnce(shots_, group.shot);
    }
  }

  bool empty() const { return groups_.empty(); }
  page::Table table() const;
  // Replaces {ARM, VALUE @ SHOT} by the first measure of the cells at this point, {NAME ARM, VALUE @ SHOT} by the
  // measure NAME.
  std::string filled(const std::string& text) const {
    return replaced(text, [this](const std::string& inside) { return replacement(inside); });
  }

 private:
  const Point* find(const std::string& arm, size_t value, const std::string& shot) const;
  std::string shown(const std::string& measure, const PointGroup& group, const Point& point) const;
  std::string cell(const std::string& arm, size_t value, const std::string& shot) const;
  std::string replacement(const std::string& inside) const;
  const PointGroup* groupAt(size_t value, const std::string& shot) const;

  const Results& results_;
  const AxisSummary& axis_;
  const TableLayout& layout_;
  std::vector<const PointGroup*> groups_;
  std::vector<std::string> shots_;
};

const PointGroup* AxisTable::groupAt(size_t value, const std::string& shot) const {
  for (const PointGroup* group : groups_)
    if (group->shot == shot && group->at[0].second == axis_.values[value]) return group;
  return nullptr;
}

const Point* AxisTable::find(const std::string& arm, size_t value, const std::string& shot) const {
  const PointGroup* group = groupAt(value, shot);
  return group ? group->find(arm) : nullptr;
}

std::string AxisTable::shown(const std::string& measure, const PointGroup& group, const Point& point) const {
  double value = point.value(measure);
  bool is_error = measure == "rmse" || measure == "rmse_full";
  bool shares = layout_.share && is_error;
  if (shares) value /= group.truth().value("contrast");
  return orLack(shares ? page::shownShare(value) : shownValue(measureNamed(measure), value), value, group, point);
}

std::string AxisTable::cell(const std::string& arm, size_t value, const std::string& shot) const {
  const Point* point = find(arm, value, shot);
  if (!point) return "";
  std::vector<std::string> parts;
  for (const std::string& measure : layout_.cells) {
    bool is_change = measure.starts_with("change");
    if (!(is_change && value == axis_.benign)) parts.push_back(shown(measure, *groupAt(value, shot), *point));
  }
  return fmt::format("{}{}", fmt::join(parts, "; "), point->limits.empty() ? "" : "°");
}

page::Table AxisTable::table() const {
  page::Table table;
  table.columns = {"method", axis_.name};
  for (const std::string& measure : layout_.once) table.columns.push_back({headOf(measureNamed(measure)), true});
  for (const std::string& shot : shots_) table.columns.push_back({results_.shot(shot).title, true});
  for (const ArmSummary& arm : results_.arms)
    for (size_t value = 0; value < axis_.values.size(); ++value) {
      const Point* first = find(arm.name, value, shots_.front());
      if (!first || arm.role != ArmRole::method) continue;
      page::Row row = {arm.name, axis_.labels[value]};
      for (const std::string& measure : layout_.once) {
        double once = first->value(measure);
        row.push_back(
            {once, orLack(shownValue(measureNamed(measure), once), once, *groupAt(value, shots_.front()), *first)});
      }
      for (const std::string& shot : shots_) row.push_back(cell(arm.name, value, shot));
      table.add(std::move(row));
    }
  return table;
}

std::string AxisTable::replacement(const std::string& inside) const {
  std::string measure = layout_.cells.empty() ? "rmse" : layout_.cells.front(), rest = inside;
  for (const std::string& name : measureNames())
    if (inside.starts_with(name + " ")) measure = name, rest = inside.substr(name.size() + 1);
  for (const PointGroup* group : groups_)
    for (const Point& point : group->points) {
      auto value = std::find(axis_.values.begin(), axis_.values.end(), group->at[0].second);
      const std::string& label = axis_.labels[size_t(value - axis_.values.begin())];
      if (rest == point.arm + ", " + label + " @ " + group->shot) return shown(measure, *group, point);
    }
  if (results_.partial || results_.missing() > 0) return page::kNotMeasured;
  throw Error(fmt::format(
      "the reading of axis '{}' has {{{}}}; expected {{ARM, VALUE @ SHOT}} or {{MEASURE ARM, VALUE @ SHOT}}",
      axis_.name, inside));
}

// ---- all points

page::Table pointTable(const Results& results) {
  page::Table table;
  table.columns = {"shot"};
  for (const AxisSummary& axis : results.axes) table.columns.push_back({axis.name, true});
  table.columns.push_back("arm");
  std::vector<std::pair<const Measure*, std::string>> columns;
  for (const std::string& name : results.measures) {
    const Measure& measure = measureNamed(name);
    for (const std::string& region : measure.per_region ? results.regions : std::vector<std::string>{""}) {
      columns.emplace_back(&measure, region);
      table.columns.push_back({headOf(measure) + (region.empty() ? "" : " " + region), true});
    }
  }
  for (const PointGroup& group : results.groups)
    for (const Point& point : group.points) {
      page::Emphasis mark = point.role == ArmRole::method ? page::Emphasis::none : page::Emphasis::faint;
      page::Row row = {results.shot(group.shot).title};
      for (const AxisSummary& axis : results.axes) {
        const Json* at = group.valueOn(axis.name);
        row.push_back(!at ? "" : at->is_string() ? at->get<std::string>() : at->dump());
      }
      row.push_back(page::TableCell(point.arm + (point.role == ArmRole::truth ? " ±" : ""), mark));
      for (const auto& [measure, region] : columns) {
        double value = point.value(measure->name, region);
        row.push_back(page::TableCell(value, orLack(shownValue(*measure, value), value, group, point), mark));
      }
      table.add(std::move(row));
    }
  return page::withoutEmptyColumns(std::move(table));
}

std::string explained(const Results& results, const TableLayout& layout) {
  std::vector<std::string> texts;
  auto add = [&](const std::vector<std::string>& names) {
    for (const std::string& name : names) texts.push_back(measureNamed(name).title + ": " + measureNamed(name).doc);
  };
  add(layout.cells), add(layout.once);
  if (layout.axes.empty()) add(results.measures);
  std::string text = fmt::format("{}.", fmt::join(texts, "; "));
  if (layout.share) text += " Errors are shares of the contrast of truth (its standard deviation).";
  return text + (results.software ? " A software device: its milliseconds are not a GPU's." : "");
}

}  // namespace

Parts tableParts(const Results& results) {
  const TableLayout& layout = *results.layout.table;
  Parts parts;
  if (layout.axes.empty()) {
    parts.push_back(heading(layout.title.empty() ? "Points" : layout.title, 2, "points", ReportPart::kRead));
    parts.push_back(text(layout.note, Tone::plain, ReportPart::kRead));
    parts.push_back(text(explained(results, layout), Tone::soft, ReportPart::kRead));
    parts.push_back({pointTable(results)});
    return parts;
  }
  for (const std::string& name : layout.axes)
    for (const AxisSummary& axis : results.axes) {
      AxisTable table(results, axis, layout);
      if (axis.name != name || table.empty()) continue;
      if (parts.empty()) {
        parts.push_back(heading(layout.title.empty() ? "Tables" : layout.title, 2, "tables", ReportPart::kRead));
        parts.push_back(text(layout.note, Tone::plain, ReportPart::kRead));
        parts.push_back(text(explained(results, layout), Tone::soft, ReportPart::kRead));
      }
      parts.push_back(heading(axis.title + ": `" + axis.name + "`", 3));
      parts.push_back(text(table.filled(axis.reading), Tone::plain, ReportPart::kRead));
      append(parts, expectationParts(results, "", axis.name));
      parts.push_back({table.table()});
    }
  return parts;
}

}  // namespace strobe::study
