// SPDX-License-Identifier: MIT
#include "stability/curves_page.h"

#include <algorithm>

#include "base/error.h"
#include "lab/html.h"
#include "lab/html_parts.h"
#include "page/chart.h"
#include "page/number.h"
#include "page/templates.h"

namespace strobe::stability::curves {

using lab::escaped;
using page::shownNumber;
using page::shownShare;

namespace {

std::string shownError(double value) {
  return std::isnan(value) ? "–" : value == 0 ? "0" : fmt::format("{:.3g}", value);
}

const char* wordOf(Doubt doubt) {
  switch (doubt) {
    case Doubt::error:
      return "error";
    case Doubt::limit:
      return "limit";
    case Doubt::broken:
      return "not finite";
    case Doubt::none:
      break;
  }
  return "";
}

// "everywhere", "2 (error below) to 31 (limit above)", "nowhere".
std::string rangeOf(const Report& report, const ReportAxis& axis, size_t method, Measure measure) {
  Trusted trusted = trustedOf(report, axis, method, measure);
  if (trusted.count == 0) {
    bool anywhere = false;
    for (size_t i = 0; i < axis.points.size(); ++i)
      anywhere |= doubtOf(report, axis, method, i, measure) == Doubt::none;
    return anywhere ? "not at " + shownNumber(axis.benign) : "nowhere";
  }
  auto end = [&](size_t point, Doubt doubt, const char* side) {
    return fmt::format("{} ({} {})", shownNumber(axis.points[point].value), wordOf(doubt), side);
  };
  bool from = trusted.below != Doubt::none, to = trusted.above != Doubt::none;
  std::string low = from ? end(trusted.first, trusted.below, "below") : "";
  std::string high = to ? end(trusted.first + trusted.count - 1, trusted.above, "above") : "";
  if (from && to) return low + " to " + high;
  return from ? "from " + low : to ? "up to " + high : "everywhere";
}

using Rows = std::vector<std::vector<std::string>>;

// The first row is the head.
Rows rangeRows(const Report& report, Measure measure) {
  Rows rows = {{"method"}};
  for (const ReportAxis& axis : report.axes) rows[0].push_back(axis.title + ", " + axis.unit);
  for (size_t m = 0; m < report.methods.size(); ++m) {
    rows.push_back({report.methods[m]});
    for (const ReportAxis& axis : report.axes) rows.back().push_back(rangeOf(report, axis, m, measure));
  }
  return rows;
}

// Errors at the benign values.
Rows benignRows(const Report& report) {
  Rows rows = {{"method"}};
  for (const ReportAxis& axis : report.axes)
    rows[0].push_back(fmt::format("{} {}", axis.title, shownNumber(axis.benign)));
  auto add = [&](const std::string& label, auto error) {
    rows.push_back({label});
    for (const ReportAxis& axis : report.axes) rows.back().push_back(shownShare(error(axis, axis.benignIndex())));
  };
  for (size_t m = 0; m < report.methods.size(); ++m)
    add(report.methods[m], [m](const ReportAxis& axis, size_t point) { return axis.error(m, point); });
  add(report.floor, [](const ReportAxis& axis, size_t point) { return axis.floor(point); });
  add(report.truth + " ±", [](const ReportAxis& axis, size_t point) { return axis.sigma(point); });
  return rows;
}

std::string howTrusted(const Report& report) {
  return fmt::format(
      "The values about the benign one at which a method's error is at most {:g} times the floor there "
      "(truth with as many samples as the method), no limit of it was met and every value is finite.",
      report.factor);
}

std::string howUsual(const Report& report) {
  return fmt::format(
      "The same with {:g} times the method's own error at the benign value allowed as well: where it is no "
      "worse than usual, however bad that is.",
      report.factor);
}

std::string howErrors(const Report& report) {
  return fmt::format(
      "Errors are the root mean square of the difference from truth, linear values, over the region named, "
      "as a share of the picture's contrast (standard deviation of truth at the benign value). {}x{} pixels.",
      report.width, report.height);
}

std::string howVariants(const Report& report) {
  return fmt::format(
      "Errors against truth over the whole picture, as a share of its contrast, and behind them the largest "
      "difference in any channel from the picture of the reference value (the first of each method here). MiB: "
      "all images that a frame holds at once. Milliseconds: median and least of 9 frames each, drawn in turn{}.",
      report.software ? "; a software device, so they are not a GPU's" : "");
}

Rows variantRows(const Report& report, const ReportVariant& variant) {
  Rows rows = {{"method", variant.name, "MiB", "ms (least)"}};
  for (const std::string& in : report.cases) rows[0].push_back(in);
  for (const VariantRow& row : variant.rows) {
    rows.push_back(
        {row.method, row.value, fmt::format("{:.2f}", row.mib), fmt::format("{:.1f} ({:.1f})", row.ms, row.least_ms)});
    for (size_t i = 0; i < row.errors.size(); ++i) {
      std::string change = row.value == variant.reference ? "" : fmt::format("; {}", shownError(row.changes[i]));
      rows.back().push_back(shownShare(row.errors[i]) + change + (row.limits[i].empty() ? "" : "°"));
    }
  }
  return rows;
}

std::string deviceOf(const Report& report) {
  return fmt::format("Strobe {} on {}, {}{}.", report.strobe, report.device, report.driver,
                     report.software ? "; a software device" : "");
}

std::string driftOf(const ReportAxis& axis) {
  if (!axis.same_picture) return "";
  double most = 0, share = 0;
  for (const ReportPoint& point : axis.points)
    most = std::max(most, point.drift), share = std::max(share, point.drifted);
  return fmt::format(
      "What is seen does not depend on the value: truth differs from truth at {} by more than 1e-5 in at most {} of "
      "the pixels, by at most {}.",
      shownNumber(axis.benign), shownShare(share), shownError(most));
}

// ---- the page

std::string regionText(const std::string& region) {
  if (region == "whole") return "the whole picture";
  if (region == "inner") return "inner: pixels of the object that see something farther within the exposure";
  if (region == "hidden") return "hidden: pixels that see within the exposure what the capture could not see";
  return "outer: pixels before which something nearer passes";
}

page::Scale::Kind scaleOf(const std::string& name) {
  using Kind = page::Scale::Kind;
  return name == "linear" ? Kind::linear : name == "even" ? Kind::even : Kind::log;
}

page::Series methodLine(const Report& report, const ReportAxis& axis, size_t method, size_t region) {
  page::Series line{report.methods[method], int(method), {}};
  Trusted usual = trustedOf(report, axis, method, Measure::own);
  for (size_t i = 0; i < axis.points.size(); ++i) {
    const ReportPoint& point = axis.points[i];
    const Measured& measured = point.methods[method];
    page::Point drawn{point.value, 100 * measured.rmse[region] / axis.contrast};
    drawn.hollow = !measured.limits.empty();
    drawn.faint = !usual.holds(i);
    drawn.tip =
        fmt::format("{}, {} {}: {} of the contrast, RMSE {}{}", report.methods[method], shownNumber(point.value),
                    axis.unit, shownShare(measured.rmse[region] / axis.contrast), shownError(measured.rmse[region]),
                    measured.limits.empty() ? "" : fmt::format("; limit met: {}", fmt::join(measured.limits, "; ")));
    line.points.push_back(drawn);
  }
  return line;
}

page::Chart chartOf(const Report& report, const ReportAxis& axis, size_t region) {
  page::Chart chart;
  chart.x = {axis.title + ", " + axis.unit, scaleOf(axis.scale)};
  chart.y = {"error, share of contrast", page::Scale::Kind::log, " %", true, 4};
  chart.guides = {{axis.benign, "what the other axes use"}};
  chart.about = fmt::format("Error of each method against {}, region {}; the numbers are in the table below",
                            chart.x.title, kRegions[region]);
  page::Series floor{report.floor, page::kReferenceStyle, {}}, sigma{"truth ±", page::kUncertaintyStyle, {}};
  page::Series band{"", page::kReferenceStyle, {}, page::Series::Kind::band};
  for (const ReportPoint& point : axis.points) {
    double least = 100 * point.floor.rmse[region] / axis.contrast;
    floor.points.push_back({point.value, least});
    sigma.points.push_back({point.value, 100 * point.sigma[region] / axis.contrast});
    page::Point allowed{point.value, least};
    if (!std::isnan(least)) allowed.y_range = {-INFINITY, report.factor * least};
    band.points.push_back(allowed);
  }
  chart.series = {band, sigma, floor};
  for (size_t m = 0; m < report.methods.size(); ++m) chart.series.push_back(methodLine(report, axis, m, region));
  return chart;
}

class Page {
 public:
  explicit Page(const Report& report) : report_(report) {}
  std::string text();

 private:
  void paragraph(const std::string& text, const char* kind = "") {
    if (!text.empty())
      page_ += fmt::format("<p{}>{}</p>\n", *kind ? fmt::format(" class=\"{}\"", kind) : "", escaped(text));
  }
  void table(const Rows& rows);
  void numbers(const ReportAxis& axis, size_t region);
  void commands(const ReportAxis& axis);
  void axis(const ReportAxis& axis);
  void variants();

  const Report& report_;
  std::string page_;
};

void Page::table(const Rows& rows) {
  page_ += "<div class=\"scroll wide\"><table><thead><tr>";
  for (const std::string& cell : rows[0]) page_ += "<th scope=\"col\">" + escaped(cell) + "</th>";
  page_ += "</tr></thead><tbody>\n";
  for (size_t i = 1; i < rows.size(); ++i) {
    page_ += "<tr>";
    for (const std::string& cell : rows[i]) page_ += "<td>" + escaped(cell) + "</td>";
    page_ += "</tr>\n";
  }
  page_ += "</tbody></table></div>\n";
}

// RMSE as measured, to copy; ° marks points at which a limit was hit.
void Page::numbers(const ReportAxis& axis, size_t region) {
  Rows rows = {{axis.unit}};
  for (const std::string& method : report_.methods) rows[0].push_back(method);
  rows[0].insert(rows[0].end(), {report_.floor, "truth ±", "pixels"});
  for (const ReportPoint& point : axis.points) {
    rows.push_back({point.label});
    for (const Measured& measured : point.methods)
      rows.back().push_back(shownError(measured.rmse[region]) + (measured.broken           ? " (not finite)"
                                                                 : measured.limits.empty() ? ""
                                                                                           : "°"));
    rows.back().insert(rows.back().end(), {shownError(point.floor.rmse[region]), shownError(point.sigma[region]),
                                           std::to_string(point.pixels[region])});
  }
  page_ += fmt::format("<h4>RMSE, {}</h4>\n", escaped(regionText(kRegions[region])));
  table(rows);
}

void Page::commands(const ReportAxis& axis) {
  page_ += "<details><summary>Commands that repeat one point</summary>\n<pre>";
  for (const ReportPoint& point : axis.points) {
    page_ += fmt::format("<b># {} {}</b>\n{}\n", escaped(point.label), escaped(axis.unit), escaped(point.command));
    for (const Measured& measured : point.methods) page_ += escaped(measured.command) + "\n";
  }
  page_ += "</pre></details>\n";
}

void Page::axis(const ReportAxis& axis) {
  page_ += fmt::format("<section id=\"{}\">\n<h2>{}</h2>\n", escaped(axis.name), escaped(axis.title));
  paragraph(axis.fixed);
  paragraph(axis.note);
  page_ += svgOf(chartOf(report_, axis, axis.regionIndex()));
  paragraph(fmt::format("Region: {}. Contrast {:.4g}. {}", regionText(axis.region), axis.contrast, driftOf(axis)),
            "soft");
  if (!axis.reading.empty()) paragraph(filled(report_, axis, axis.reading), "verdict");
  page_ += "<details><summary>Numbers</summary>\n";
  paragraph("° a limit of the method was met.", "soft");
  numbers(axis, axis.regionIndex());
  for (size_t region = 0; region < kRegions.size(); ++region)
    if (region != axis.regionIndex()) numbers(axis, region);
  page_ += "</details>\n<details><summary>The other regions</summary>\n";
  for (size_t region = 0; region < kRegions.size(); ++region) {
    if (region == axis.regionIndex()) continue;
    page_ += fmt::format("<h4>{}</h4>\n", escaped(regionText(kRegions[region])));
    page_ += svgOf(chartOf(report_, axis, region), 940, 330);
  }
  page_ += "</details>\n";
  commands(axis);
  page_ += "</section>\n";
}

void Page::variants() {
  page_ += "<section id=\"variants\">\n<h2>Numbers between passes</h2>\n";
  paragraph(howVariants(report_), "soft");
  for (const ReportVariant& variant : report_.variants) {
    page_ += fmt::format("<h3>{}: {}</h3>\n", escaped(variant.title), escaped(variant.name));
    paragraph(filled(report_, variant, variant.reading), "verdict");
    table(variantRows(report_, variant));
  }
  page_ += "</section>\n";
}

const char* const kOwnStyle = R"css(
h4 { font-size: .95rem; margin: .9rem 0 .2rem; } details { margin: .3rem 0; } summary { cursor: pointer; color: var(--accent); }
pre { overflow-x: auto; background: var(--panel); padding: .6rem .8rem; font-size: .8rem; line-height: 1.45; } nav a { margin-right: 1.1rem; color: var(--accent); }
th { white-space: normal; } .wide td { white-space: normal; min-width: 7rem; }
)css";

const char* const kHowToRead =
    "In the curves, the shaded band is what a method may err by to be as good as its samples allow: up to the factor "
    "times the "
    "floor, the black line. A curve is faint where the method is worse than usual, a mark hollow where a limit of it "
    "was met, "
    "the dotted vertical line is the benign value, at which the other axes stand. The grey dots are truth's own "
    "standard "
    "error. What is below the lower border is drawn on it. Values are shown where the pointer rests on a mark.";

std::string Page::text() {
  page_ =
      "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>" +
      escaped(report_.title) + "</title>\n<link rel=\"icon\" href=\"data:,\">\n<style>" + lab::kPageStyle +
      std::string(page::asset("chart.css")) + kOwnStyle + "</style>\n</head>\n<body>\n<h1>" + escaped(report_.title) +
      "</h1>\n";
  paragraph(report_.note);
  paragraph(howErrors(report_) + " " + deviceOf(report_), "soft");
  page_ += "<nav>";
  for (const ReportAxis& axis : report_.axes)
    page_ += fmt::format("<a href=\"#{}\">{}</a>", escaped(axis.name), escaped(axis.title));
  if (!report_.variants.empty()) page_ += "<a href=\"#variants\">Numbers between passes</a>";
  page_ += "</nav>\n<h2>Where each method is as good as its samples allow</h2>\n";
  paragraph(howTrusted(report_), "soft");
  table(rangeRows(report_, Measure::floor));
  page_ += "<h2>Where each method is no worse than usual</h2>\n";
  paragraph(howUsual(report_), "soft");
  table(rangeRows(report_, Measure::own));
  page_ += "<h3>Errors at the benign values</h3>\n";
  table(benignRows(report_));
  paragraph(kHowToRead, "soft");
  for (const ReportAxis& one : report_.axes) axis(one);
  if (!report_.variants.empty()) variants();
  page_ += "<footer>\n";
  paragraph("Made again by: " + report_.command);
  return page_ + "</footer>\n</body>\n</html>\n";
}

// ---- readings

size_t methodIndex(const Report& report, const ReportAxis& axis, const std::string& label) {
  auto found = std::find(report.methods.begin(), report.methods.end(), label);
  if (found == report.methods.end())
    throw Error(fmt::format("the reading of axis '{}' names no method: '{}'{}", axis.name, label,
                            didYouMean(label, report.methods)));
  return size_t(found - report.methods.begin());
}

std::string endNamed(const Report& report, const ReportAxis& axis, const std::string& label, bool upper) {
  Trusted usual = trustedOf(report, axis, methodIndex(report, axis, label), Measure::own);
  if (usual.count == 0) return "nowhere";
  return shownNumber(axis.points[upper ? usual.first + usual.count - 1 : usual.first].value);
}

std::string replacement(const Report& report, const ReportAxis& axis, const std::string& inside) {
  if (inside.starts_with("from ")) return endNamed(report, axis, inside.substr(5), false);
  if (inside.starts_with("to ")) return endNamed(report, axis, inside.substr(3), true);
  size_t at = inside.rfind(" @ ");
  if (at == std::string::npos)
    throw Error(fmt::format(
        "the reading of axis '{}' has {{{}}}, which is none of {{LABEL @ VALUE}}, {{from LABEL}}, {{to LABEL}}",
        axis.name, inside));
  std::string label = inside.substr(0, at), value = inside.substr(at + 3);
  for (size_t i = 0; i < axis.points.size(); ++i) {
    if (axis.points[i].label != value) continue;
    if (label == "floor") return shownShare(axis.floor(i));
    if (label == "truth") return shownShare(axis.sigma(i));
    return shownShare(axis.error(methodIndex(report, axis, label), i));
  }
  throw Error(fmt::format("the reading of axis '{}' names no value: '{}'", axis.name, value));
}

std::string markdownTable(const Rows& rows) {
  std::string text;
  for (size_t i = 0; i < rows.size(); ++i) {
    text += fmt::format("| {} |\n", fmt::join(rows[i], " | "));
    if (i > 0) continue;
    text += "|";
    for (size_t column = 0; column < rows[i].size(); ++column) text += column == 0 ? "---|" : "---:|";
    text += "\n";
  }
  return text;
}

// Characters, not bytes.
size_t lengthOf(const std::string& text) {
  return size_t(std::count_if(text.begin(), text.end(), [](unsigned char c) { return (c & 0xc0) != 0x80; }));
}

}  // namespace

// `text` with what is in braces replaced.
template <class Replace>
static std::string replaced(const std::string& text, const Replace& replace) {
  std::string result;
  for (size_t at = 0; at < text.size();) {
    size_t open = text.find('{', at), close = text.find('}', open);
    if (open == std::string::npos || close == std::string::npos) return result + text.substr(at);
    result += text.substr(at, open - at) + replace(text.substr(open + 1, close - open - 1));
    at = close + 1;
  }
  return result;
}

std::string filled(const Report& report, const ReportAxis& axis, const std::string& text) {
  return replaced(text, [&](const std::string& inside) { return replacement(report, axis, inside); });
}

std::string filled(const Report& report, const ReportVariant& variant, const std::string& text) {
  return replaced(text, [&](const std::string& inside) {
    for (const VariantRow& row : variant.rows)
      for (size_t i = 0; i < report.cases.size(); ++i) {
        std::string name = fmt::format("{}, {} @ {}", row.method, row.value, report.cases[i]);
        if (inside == name) return shownShare(row.errors[i]);
        if (inside == "change " + name) return shownError(row.changes[i]);
      }
    throw Error(
        fmt::format("the reading of variant '{}' has {{{}}}, which is none of {{LABEL, VALUE @ CASE}} and "
                    "{{change LABEL, VALUE @ CASE}}",
                    variant.name, inside));
  });
}

std::string pageOf(const Report& report) { return Page(report).text(); }

std::string markdownOf(const Report& report, const std::string& page) {
  std::string text =
      "<!-- Written by `" + report.command + "`; what it says is in the experiment. -->\n\n# " + report.title + "\n\n";
  text += report.note + " " + howErrors(report) + " " + deviceOf(report) + "\n\n";
  text += fmt::format(
      "The curves, every number and a command for every point are on [the page]({}), a file that a browser opens "
      "from disk. It, this text and the numbers as JSON beside it are made again by\n\n    {}\n\n",
      page, report.command);
  text += "## Where each method is as good as its samples allow\n\n" + howTrusted(report) + "\n\n" +
          markdownTable(rangeRows(report, Measure::floor));
  text += "\n## Where each method is no worse than usual\n\n" + howUsual(report) + "\n\n" +
          markdownTable(rangeRows(report, Measure::own)) + "\n";
  text += "Errors at the benign values:\n\n" + markdownTable(benignRows(report));
  for (const ReportAxis& axis : report.axes) {
    text += fmt::format("\n## {}\n\n{}\n", axis.title, axis.fixed);
    if (!axis.note.empty()) text += axis.note + "\n";
    if (axis.same_picture) text += driftOf(axis) + "\n";
    if (!axis.reading.empty()) text += "\n" + filled(report, axis, axis.reading) + "\n";
  }
  if (report.variants.empty()) return text;
  text += "\n## Numbers between passes\n\n" + howVariants(report) + "\n";
  for (const ReportVariant& variant : report.variants) {
    text += fmt::format("\n### {}: `{}`\n\n", variant.title, variant.name);
    if (!variant.reading.empty()) text += filled(report, variant, variant.reading) + "\n\n";
    text += markdownTable(variantRows(report, variant));
  }
  return text;
}

std::string textOf(const Report& report) {
  std::string text;
  for (const ReportAxis& axis : report.axes) {
    text += fmt::format("{}, {}: error at {:g} ({}); where it is at most {:g} times the floor; where it is as usual\n",
                        axis.title, axis.unit, axis.benign, axis.region, report.factor);
    for (size_t m = 0; m < report.methods.size(); ++m) {
      std::string label = report.methods[m];
      label += std::string(24 - std::min<size_t>(24, lengthOf(label)), ' ');
      text += fmt::format("  {} {:>9}   {:<38} {}\n", label, shownShare(axis.error(m, axis.benignIndex())),
                          rangeOf(report, axis, m, Measure::floor), rangeOf(report, axis, m, Measure::own));
    }
  }
  return text;
}

}  // namespace strobe::stability::curves
