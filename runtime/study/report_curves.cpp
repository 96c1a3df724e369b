// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "base/lists.h"
#include "lab/shot_data.h"
#include "page/chart.h"
#include "page/number.h"
#include "study/curves.h"
#include "study/gallery.h"
#include "study/report.h"

namespace strobe::study {

namespace {

using page::shownNumber;
using page::shownShare;

std::string shownRmse(double value) {
  return std::isnan(value) ? "–" : value == 0 ? "0" : fmt::format("{:.3g}", value);
}

std::string titleOf(const AxisSummary& axis) { return axis.unit.empty() ? axis.title : axis.title + ", " + axis.unit; }

// ---- ranges of arms

std::vector<std::string> armsOf(const std::vector<Curve>& curves) {
  std::vector<std::string> arms;
  for (const Curve& curve : curves)
    for (const std::string& arm : curve.arms()) addOnce(arms, arm);
  return arms;
}

page::Table rangeTable(const std::vector<Curve>& curves, Against against) {
  page::Table table;
  table.columns = {"method"};
  for (const Curve& curve : curves) table.columns.push_back({titleOf(curve.axis()), true});
  for (const std::string& arm : armsOf(curves)) {
    page::Row row = {arm};
    for (const Curve& curve : curves) row.push_back(curve.range(arm, against));
    table.add(std::move(row));
  }
  return table;
}

page::Table benignTable(const Results& results, const std::vector<Curve>& curves) {
  page::Table table;
  table.columns = {"method"};
  for (const Curve& curve : curves)
    table.columns.push_back({curve.axis().title + " " + shownNumber(curve.value(curve.benign())), true});
  auto add = [&](const std::string& label, page::Emphasis mark, auto error) {
    page::Row row = {page::TableCell(label, mark)};
    for (const Curve& curve : curves) {
      double share = error(curve);
      row.push_back(page::TableCell(share, shownShare(share), mark));
    }
    table.add(std::move(row));
  };
  for (const std::string& arm : armsOf(curves))
    add(arm, page::Emphasis::none, [&](const Curve& curve) { return curve.error(arm, curve.benign()); });
  add("floor", page::Emphasis::faint, [](const Curve& curve) { return curve.floor(curve.benign()); });
  add(results.arms.back().name + " ±", page::Emphasis::faint, [](const Curve& c) { return c.sigma(c.benign()); });
  return table;
}

// Table of one axis for a terminal, with a row per arm.
page::Table summaryTable(const Curve& curve, double factor) {
  page::Table table;
  table.columns = {
      titleOf(curve.axis()),
      {fmt::format("error at {} ({})", shownNumber(curve.value(curve.benign())), curve.axis().region), true},
      fmt::format("at most {:g} times the floor", factor),
      "as usual"};
  for (const std::string& arm : curve.arms())
    table.add({arm, shownShare(curve.error(arm, curve.benign())), curve.range(arm, Against::floor),
               curve.range(arm, Against::own)});
  return table;
}

// ---- one axis

std::string regionText(const std::string& region) {
  if (region == "whole") return "the whole picture";
  if (region == "inner")
    return "inner: pixels of the object that show a farther surface at another time of the exposure";
  if (region == "hidden") return "hidden: pixels that show a surface that was hidden at the raster time";
  if (region == "self") return "self: pixels that show a part of their own object that was hidden at the raster time";
  return "outer: pixels that a nearer surface covers at another time of the exposure";
}

page::Scale::Kind scaleOf(const std::string& name) {
  using Kind = page::Scale::Kind;
  return name == "linear" ? Kind::linear : name == "even" ? Kind::even : Kind::log;
}

page::Series armSeries(const Curve& curve, const std::string& arm, int style, const std::string& region) {
  page::Series series;
  series.label = arm;
  series.style = style;
  Trusted usual = curve.trusted(arm, Against::own);
  for (size_t i = 0; i < curve.size(); ++i) {
    const Point* point = curve.group(i).find(arm);
    if (!point) continue;
    page::ChartPoint drawn{curve.value(i), 100 * curve.error(arm, i, region)};
    drawn.hollow = !point->limits.empty();
    drawn.faint = !usual.holds(i);
    drawn.tip =
        fmt::format("{}, {} {}: {} of the contrast, RMSE {}{}", arm, shownNumber(curve.value(i)), curve.axis().unit,
                    shownShare(curve.error(arm, i, region)), shownRmse(point->value("rmse", region)),
                    point->limits.empty() ? "" : fmt::format("; limit met: {}", fmt::join(point->limits, "; ")));
    series.points.push_back(drawn);
  }
  return series;
}

// Band up to `factor` times the floor.
page::Series bandSeries(const Curve& curve, double factor, const std::string& region) {
  page::Series band;
  band.kind = page::Series::Kind::band;
  band.style = page::kReferenceStyle;
  for (size_t i = 0; i < curve.size(); ++i) {
    double least = 100 * curve.floor(i, region);
    page::ChartPoint point{curve.value(i), least};
    if (!std::isnan(least)) point.y_range = {-INFINITY, factor * least};
    band.points.push_back(point);
  }
  return band;
}

page::Chart chartOf(const Curve& curve, double factor, const std::string& region) {
  page::Chart chart;
  chart.x.title = titleOf(curve.axis());
  chart.x.kind = scaleOf(curve.axis().scale);
  chart.y.title = "error, share of contrast";
  chart.y.kind = page::Scale::Kind::log;
  chart.y.unit = " %";
  chart.y.rounded = true;
  chart.y.decades = 4;
  chart.about = fmt::format("Error of each method against {}, region {}; the numbers are in the table below",
                            chart.x.title, region);
  chart.guides = {{curve.value(curve.benign()), "value used by the other axes"}};
  page::Series floor, sigma;
  floor.label = "floor", floor.style = page::kReferenceStyle;
  sigma.label = "truth ±", sigma.style = page::kUncertaintyStyle;
  for (size_t i = 0; i < curve.size(); ++i) {
    floor.points.push_back({curve.value(i), 100 * curve.floor(i, region)});
    sigma.points.push_back({curve.value(i), 100 * curve.sigma(i, region)});
  }
  chart.series = {bandSeries(curve, factor, region), sigma, floor};
  int style = 0;
  for (const std::string& arm : curve.arms()) chart.series.push_back(armSeries(curve, arm, style++, region));
  return chart;
}

// Table of RMSE values; ° marks points that met a limit.
page::Table numbersTable(const Curve& curve, const std::string& region) {
  page::Table table;
  table.caption = "RMSE, " + regionText(region);
  table.columns = {curve.axis().unit};
  for (const std::string& arm : curve.arms()) table.columns.push_back({arm, true});
  for (const char* name : {"floor", "truth ±", "pixels"}) table.columns.push_back({name, true});
  for (size_t i = 0; i < curve.size(); ++i) {
    const PointGroup& group = curve.group(i);
    page::Row row = {curve.label(i)};
    for (const std::string& arm : curve.arms()) {
      const Point* point = group.find(arm);
      double rmse = point ? point->value("rmse", region) : NAN;
      std::string mark = point && !point->limits.empty() ? "°" : "";
      row.push_back(point ? orLack(shownRmse(rmse) + mark, rmse, group, *point) : "–");
    }
    row.push_back(group.floor() ? shownRmse(group.floor()->value("rmse", region)) : "–");
    row.push_back(shownRmse(group.truth().value("rmse", region)));
    row.push_back(page::shownCount(group.truth().value("pixels", region)));
    table.add(std::move(row));
  }
  return table;
}

std::string driftText(const Curve& curve) {
  if (!curve.axis().same_picture) return "";
  double most = 0, share = 0;
  for (size_t i = 0; i < curve.size(); ++i) {
    most = std::max(most, curve.group(i).truth().value("change"));
    share = std::max(share, curve.group(i).truth().value("changed"));
  }
  return fmt::format(
      "The picture does not depend on the value: truth differs from truth at {} by more than 1e-5 in at most {} of the "
      "pixels, by at most {}.",
      shownNumber(curve.value(curve.benign())), shownShare(share), shownRmse(most));
}

page::Details commandsOf(const Curve& curve) {
  std::string text;
  for (size_t i = 0; i < curve.size(); ++i) {
    text += fmt::format("# {} {}\n", curve.label(i), curve.axis().unit);
    for (const Point& point : curve.group(i).points)
      if (point.role != ArmRole::floor) text += point.command + "\n";
  }
  return {"Commands that repeat one point", {page::Code{text}}};
}

void addDetails(const Results& results, const Curve& curve, double factor, Parts& parts) {
  const std::string& own = curve.axis().region;
  page::Details numbers{"Numbers",
                        {page::Paragraph{"° a limit of the method was met.", Tone::soft}, numbersTable(curve, own)}};
  page::Details others{"The other regions", {}};
  for (const std::string& region : results.regions) {
    if (region == own) continue;
    numbers.blocks.push_back(numbersTable(curve, region));
    others.blocks.push_back(page::Heading{regionText(region), 4, ""});
    others.blocks.push_back(page::Figure{page::svgOf(chartOf(curve, factor, region), 940, 330), ""});
  }
  for (page::Details& details : std::vector<page::Details>{numbers, others, commandsOf(curve)})
    parts.push_back({std::move(details), ReportPart::kPage});
}

void addAxis(const Results& results, const Curve& curve, double factor, Parts& parts) {
  const AxisSummary& axis = curve.axis();
  parts.push_back(heading(axis.title, 2, axis.name, ReportPart::kRead));
  parts.push_back({summaryTable(curve, factor), ReportPart::kTerminal});
  parts.push_back(text(axis.fixed, Tone::plain, ReportPart::kRead));
  parts.push_back(text(axis.note, Tone::plain, ReportPart::kRead));
  page::Chart chart = chartOf(curve, factor, axis.region);
  parts.push_back(
      {page::Figure{page::svgOf(chart), "", lab::fileNameOf("curve " + axis.name), chart.about}, ReportPart::kRead});
  parts.push_back(text(fmt::format("Region: {}. Contrast {:.4g}.", regionText(axis.region), curve.contrast()),
                       Tone::soft, ReportPart::kPage));
  parts.push_back(text(driftText(curve), Tone::soft, ReportPart::kRead));
  parts.push_back(text(curve.filled(axis.reading), Tone::plain, ReportPart::kRead));
  append(parts, expectationParts(results, "", axis.name));
  addDetails(results, curve, factor, parts);
}

const char* const kHowToRead =
    "In the curves, the black line is the floor, and the shaded band ends at the factor times the floor: a method in "
    "the band is as good as its samples allow. A curve is faint where the method is worse than usual. A mark is hollow "
    "if the method met a limit. The dotted vertical line is the benign value, which the other axes use. The grey dots "
    "are truth's own standard error. Values below the lower border are drawn on the border. The pointer on a mark "
    "shows its values.";

}  // namespace

Parts curveParts(const Results& results) {
  double factor = results.layout.curves->factor;
  std::vector<Curve> curves = curvesIn(results, factor);
  Parts parts;
  if (curves.empty()) return parts;
  parts.push_back(text(
      fmt::format("Errors are the root mean square of the difference from truth, linear values, over the region named, "
                  "as a share of the picture's contrast (standard deviation of truth at the benign value). {}x{} "
                  "pixels.",
                  results.width, results.height),
      Tone::soft, ReportPart::kRead));
  parts.push_back(heading("Range with errors near the sampling floor", 2, "", ReportPart::kRead));
  parts.push_back(text(
      fmt::format("Values around the benign value. At each value, the method's error is at most {:g} times the floor "
                  "(truth with as many samples as the method), the method met no limit, and all colours are finite.",
                  factor),
      Tone::soft, ReportPart::kRead));
  parts.push_back({rangeTable(curves, Against::floor), ReportPart::kRead});
  parts.push_back(heading("Range with errors no worse than usual", 2, "", ReportPart::kRead));
  parts.push_back(text(fmt::format("The error may also be {:g} times the method's own error at the benign value: the "
                                   "method is no worse than usual, even if its usual error is large.",
                                   factor),
                       Tone::soft, ReportPart::kRead));
  parts.push_back({rangeTable(curves, Against::own), ReportPart::kRead});
  parts.push_back(heading("Errors at the benign values", 3, "", ReportPart::kRead));
  parts.push_back({benignTable(results, curves), ReportPart::kRead});
  parts.push_back(text(kHowToRead, Tone::soft, ReportPart::kPage));
  for (const Curve& curve : curves) addAxis(results, curve, factor, parts);
  return parts;
}

}  // namespace strobe::study
