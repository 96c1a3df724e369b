// SPDX-License-Identifier: MIT
#include "bench/slopes_report.h"

#include <algorithm>
#include <cmath>

#include "bench/texts.h"
#include "page/chart.h"
#include "page/number.h"

namespace strobe::bench {

namespace {

using page::TableCell;

// ---- numbers

// Time in milliseconds, microseconds or nanoseconds: slopes per pixel are small.
std::string shownAny(double ms) {
  if (std::isnan(ms)) return page::kNotMeasured;
  double size = std::abs(ms);
  if (size >= 1) return fmt::format("{:.3g} ms", ms);
  if (size >= 1e-3) return fmt::format("{:.3g} µs", ms * 1e3);
  return fmt::format("{:.3g} ns", ms * 1e6);
}

std::string shownR2(double r2) { return std::isnan(r2) ? page::kNotMeasured : fmt::format("{:.3f}", r2); }

std::string unitOf(const AxisRun& axis) { return axis.unit.empty() ? axis.name : axis.unit; }

// ---- slopes

TableCell outcomeOf(const Fit& fit) {
  if (fit.verdict == GrowthVerdict::unknown) return fit.expected ? "too few values" : "";
  return {nameOf(fit.verdict), fit.verdict == GrowthVerdict::fails ? page::Emphasis::bad : page::Emphasis::none};
}

void addFit(page::Table& table, const Fit& fit, bool names_method) {
  const LineFit& line = fit.line;
  std::string per = fit.isLogarithmic() ? " per doubling" : "", at = fit.isLogarithmic() ? " at 1" : "";
  table.add({names_method ? fit.method : "", fit.part, TableCell(line.slope.value, shownAny(line.slope.value) + per),
             shownRange(line.slope, shownAny), TableCell(line.intercept, shownAny(line.intercept) + at),
             TableCell(line.r2, shownR2(line.r2)), fit.expected ? nameOf(fit.expected->growth) : "", outcomeOf(fit),
             fit.expected ? fit.expected->why : ""});
}

// True for frames, for expectations by name, and for failed expectations.
bool isShort(const Fit& fit) {
  bool is_named = fit.expected && fit.expected->part == fit.part;
  return fit.part == kFrame || is_named || fit.verdict == GrowthVerdict::fails;
}

page::Table slopeTable(const AxisRun& axis, const std::vector<Fit>& fits, bool all) {
  page::Table table;
  table.columns = {"method",
                   "part",
                   {"slope, per " + unitOf(axis), true},
                   {"95 % interval", true},
                   {"at 0", true},
                   {"R²", true},
                   "expected",
                   "outcome",
                   "why"};
  std::string last;
  for (const Fit& fit : fits) {
    if (!all && !isShort(fit)) continue;
    addFit(table, fit, fit.method != last);
    last = fit.method;
  }
  return page::withoutEmptyColumns(std::move(table));
}

// Medians of the frames with their intervals, and the line of each method.
page::Chart chartOf(const AxisRun& axis, const std::vector<Fit>& fits) {
  page::Chart chart;
  chart.about = fmt::format("Time of a frame against {}; the table below has the lines", axis.title);
  chart.x.title = axis.title;
  chart.y.title = "milliseconds, medians";
  chart.y.ends = {0};
  int style = 0;
  for (const Fit& fit : fits) {
    if (fit.part != kFrame) continue;
    page::Series medians{"", style, {}, page::Series::Kind::scatter}, line{fit.method, style, {}};
    for (size_t i = 0; i < fit.x.size(); ++i) {
      std::string tip = fmt::format("{}: {} at {:g}", fit.method, shownTime(fit.ms[i].value), fit.x[i]);
      medians.points.push_back({fit.x[i], fit.ms[i].value, tip, false, false, {fit.ms[i].low, fit.ms[i].high}});
      line.points.push_back({fit.x[i], fit.at(fit.x[i]), "", true});
    }
    std::sort(line.points.begin(), line.points.end(), [](const auto& a, const auto& b) { return a.x < b.x; });
    chart.series.push_back(std::move(line));
    chart.series.push_back(std::move(medians));
    ++style;
  }
  return chart;
}

const char* const kLegend = "Filled: medians with their intervals. Hollow: the line.";

std::string basisOf() {
  return fmt::format(
      "A line is the least-squares line through the medians of the rounds. Its interval is Student's t with two "
      "degrees of freedom less than values; values off the line widen the interval. A time is constant if the interval "
      "of its change along the axis reaches into ±{:.0f} % of its mean. A time grows if the interval of the slope is "
      "above 0 and R² is at least {:g}.",
      100 * kConstantShare, kLeastR2);
}

std::string summaryOf(const Slopes& slopes) {
  size_t expected = 0, holds = 0, fails = 0;
  for (const std::vector<Fit>& fits : slopes.fits)
    for (const Fit& fit : fits) {
      expected += fit.expected.has_value();
      holds += fit.verdict == GrowthVerdict::holds;
      fails += fit.verdict == GrowthVerdict::fails;
    }
  return fmt::format("{} expectations: {} hold and {} fail.", expected, holds, fails);
}

// ---- demands

std::string shownFps(double fps) { return fps > 0 ? fmt::format("{:.0f}", fps) : ""; }

page::Table demandTable(const Slopes& slopes) {
  page::Table table;
  table.columns = {"scene",
                   "method",
                   "size",
                   {"bytes", true},
                   {"rays", true},
                   {"time at least", true},
                   {"frames per second at most", true},
                   {"published", true},
                   "by"};
  for (const Demand& demand : slopes.demands) {
    const double ms = demand.leastMs(slopes.gpu);
    table.add({demand.scene, demand.method, fmt::format("{}x{}", demand.width, demand.height),
               bytesCell(bytesOf(demand.passes)), countCell(raysOf(demand.passes)), timeCell(ms),
               TableCell(1000 / ms, shownFps(1000 / ms)), shownFps(demand.published_fps), demand.published_by});
  }
  return page::withoutEmptyColumns(std::move(table));
}

std::string demandBasisOf(const Slopes& slopes) {
  return fmt::format(
      "Bound for a GPU of {:g} GB/s and {:g} billion rays per second, not a prediction: each pass takes at least the "
      "time of its bytes or of its rays, whichever is longer. Arithmetic, waiting, geometry and textures are not "
      "included. Rays grow with the pixels.",
      slopes.gpu.gigabytes_per_s, slopes.gpu.gigarays_per_s);
}

const Run& anyRun(const Slopes& slopes) { return slopes.axes.front().run; }

}  // namespace

Json toJson(const Slopes& slopes) {
  Json json = {
      {"strobe_slopes", 1},
      {"command", slopes.command},
      {"title", slopes.title},
      {"gpu", {{"gigabytes_per_s", slopes.gpu.gigabytes_per_s}, {"gigarays_per_s", slopes.gpu.gigarays_per_s}}},
      {"axes", Json::array()},
      {"demands", Json::array()}};
  for (size_t i = 0; i < slopes.axes.size(); ++i) json["axes"].push_back(toJson(slopes.axes[i], slopes.fits[i]));
  for (const Demand& demand : slopes.demands) json["demands"].push_back(toJson(demand, slopes.gpu));
  return json;
}

std::string textOf(const Slopes& slopes) {
  std::string text;
  for (size_t i = 0; i < slopes.axes.size(); ++i)
    text +=
        fmt::format("{}\n{}\n", slopes.axes[i].title, page::textOf(slopeTable(slopes.axes[i], slopes.fits[i], false)));
  text += fmt::format("{} {}\n\nLower bound of a frame's GPU time\n{}\n{}\n\n", summaryOf(slopes), basisOf(),
                      page::textOf(demandTable(slopes)), demandBasisOf(slopes));
  const Run& run = anyRun(slopes);
  return text + fmt::format("{}.\n{}. {}\n{}\n", deviceOf(run), roundsOf(run), cautionOf(run), kWorkNote);
}

page::Page pageOf(const Slopes& slopes) {
  using Kind = page::Paragraph::Kind;
  const Run& run = anyRun(slopes);
  page::Page page;
  page.title = slopes.title;
  page.note = fmt::format("{} {}. {}", slopes.question, roundsOf(run), cautionOf(run));
  page.blocks.push_back(page::Paragraph{summaryOf(slopes), Kind::finding});
  page.blocks.push_back(page::Paragraph{basisOf(), Kind::soft});
  for (size_t i = 0; i < slopes.axes.size(); ++i) {
    const AxisRun& axis = slopes.axes[i];
    page.blocks.push_back(page::Heading{axis.title, 2, fmt::format("axis-{}", i + 1)});
    page.blocks.push_back(page::Figure{page::svgOf(chartOf(axis, slopes.fits[i])), kLegend});
    page.blocks.push_back(slopeTable(axis, slopes.fits[i], false));
    page.blocks.push_back(page::Details{"All passes", {slopeTable(axis, slopes.fits[i], true)}});
  }
  page.blocks.push_back(page::Heading{"Lower bound of a frame's GPU time", 2, "demand"});
  page.blocks.push_back(page::Paragraph{demandBasisOf(slopes), Kind::soft});
  page.blocks.push_back(demandTable(slopes));
  page.blocks.push_back(page::Paragraph{kWorkNote, Kind::soft});
  page.footer = {fmt::format("Strobe {} on {}.", run.version, deviceOf(run)), "Made by `" + slopes.command + "`."};
  return page;
}

}  // namespace strobe::bench
