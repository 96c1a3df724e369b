// SPDX-License-Identifier: MIT
#include "stability/curves_report.h"

#include <algorithm>

#include "base/error.h"

namespace strobe::stability::curves {

namespace {

constexpr double kNothing = std::numeric_limits<double>::quiet_NaN();

// JSON has no NaN: null is "not measured".
Json number(double value) {
  if (!std::isfinite(value)) return nullptr;
  return std::strtod(fmt::format("{:.6g}", value).c_str(), nullptr);
}

Json numbers(const PerRegion& values) {
  Json json = Json::array();
  for (double value : values) json.push_back(number(value));
  return json;
}

double numberOf(const Json& json) { return json.is_null() ? kNothing : json.get<double>(); }

PerRegion numbersOf(const Json& json) {
  PerRegion values{};
  for (size_t i = 0; i < values.size(); ++i) values[i] = numberOf(json.at(i));
  return values;
}

Json measuredJson(const Measured& measured) {
  Json json;
  json["rmse"] = numbers(measured.rmse);
  if (!measured.limits.empty()) json["limits"] = measured.limits;
  if (measured.broken) json["broken"] = measured.broken;
  json["command"] = measured.command;
  return json;
}

Measured measuredOf(const Json& json) {
  Measured measured;
  measured.rmse = numbersOf(json.at("rmse"));
  measured.limits = json.value("limits", std::vector<std::string>());
  measured.broken = json.value("broken", uint64_t(0));
  measured.command = json.at("command");
  return measured;
}

Json pointJson(const ReportPoint& point) {
  Json json;
  json["value"] = point.value;
  json["label"] = point.label;
  json["pixels"] = point.pixels;
  json["sigma"] = numbers(point.sigma);
  json["drift"] = number(point.drift);
  json["drifted"] = number(point.drifted);
  json["command"] = point.command;
  json["floor"] = measuredJson(point.floor);
  for (const Measured& measured : point.methods) json["methods"].push_back(measuredJson(measured));
  return json;
}

ReportPoint pointOf(const Json& json) {
  ReportPoint point;
  point.value = json.at("value");
  point.label = json.at("label");
  point.pixels = json.at("pixels").get<std::array<uint64_t, 4>>();
  point.sigma = numbersOf(json.at("sigma"));
  point.drift = numberOf(json.at("drift"));
  point.drifted = numberOf(json.at("drifted"));
  point.command = json.at("command");
  point.floor = measuredOf(json.at("floor"));
  for (const Json& one : json.at("methods")) point.methods.push_back(measuredOf(one));
  return point;
}

// Calls `visit` with the name and the member of each text of an axis.
template <class Axis, class Visit>
void forTexts(Axis& axis, const Visit& visit) {
  visit("name", axis.name);
  visit("title", axis.title);
  visit("unit", axis.unit);
  visit("scale", axis.scale);
  visit("region", axis.region);
  visit("fixed", axis.fixed);
  visit("note", axis.note);
  visit("reading", axis.reading);
}

Json axisJson(const ReportAxis& axis) {
  Json json;
  forTexts(axis, [&](const char* name, const std::string& text) { json[name] = text; });
  json["benign"] = axis.benign;
  json["same_picture"] = axis.same_picture;
  json["contrast"] = number(axis.contrast);
  for (const ReportPoint& point : axis.points) json["points"].push_back(pointJson(point));
  return json;
}

ReportAxis axisOf(const Json& json) {
  ReportAxis axis;
  forTexts(axis, [&](const char* name, std::string& text) { text = json.at(name); });
  axis.benign = json.at("benign");
  axis.same_picture = json.at("same_picture");
  axis.contrast = json.at("contrast");
  for (const Json& point : json.at("points")) axis.points.push_back(pointOf(point));
  return axis;
}

Json rowJson(const VariantRow& row) {
  Json json;
  json["method"] = row.method;
  json["value"] = row.value;
  json["mib"] = number(row.mib);
  json["ms"] = number(row.ms);
  json["least_ms"] = number(row.least_ms);
  for (double error : row.errors) json["errors"].push_back(number(error));
  for (double change : row.changes) json["changes"].push_back(number(change));
  json["limits"] = row.limits;
  return json;
}

VariantRow rowOf(const Json& json) {
  VariantRow row{json.at("method"), json.at("value"), json.at("mib"), json.at("ms"), json.at("least_ms"), {}, {}, {}};
  for (const Json& error : json.at("errors")) row.errors.push_back(numberOf(error));
  for (const Json& change : json.at("changes")) row.changes.push_back(numberOf(change));
  row.limits = json.at("limits").get<std::vector<std::vector<std::string>>>();
  return row;
}

Json variantJson(const ReportVariant& variant) {
  Json json = {
      {"name", variant.name}, {"title", variant.title}, {"reference", variant.reference}, {"reading", variant.reading}};
  for (const VariantRow& row : variant.rows) json["rows"].push_back(rowJson(row));
  return json;
}

ReportVariant variantOf(const Json& json) {
  ReportVariant variant{json.at("name"), json.at("title"), json.at("reference"), json.at("reading"), {}};
  for (const Json& row : json.at("rows")) variant.rows.push_back(rowOf(row));
  return variant;
}

}  // namespace

size_t ReportAxis::benignIndex() const {
  auto found =
      std::find_if(points.begin(), points.end(), [&](const ReportPoint& point) { return point.value == benign; });
  STROBE_ASSERT(found != points.end(), "axis '{}'", name);
  return size_t(found - points.begin());
}

size_t ReportAxis::regionIndex() const {
  auto found = std::find(kRegions.begin(), kRegions.end(), region);
  STROBE_ASSERT(found != kRegions.end(), "region '{}'", region);
  return size_t(found - kRegions.begin());
}

double ReportAxis::error(size_t method, size_t point) const {
  return points[point].methods[method].rmse[regionIndex()] / contrast;
}

double ReportAxis::floor(size_t point) const { return points[point].floor.rmse[regionIndex()] / contrast; }

double ReportAxis::sigma(size_t point) const { return points[point].sigma[regionIndex()] / contrast; }

// A region without pixels is no reason for doubt: fmax knows no NaN.
Doubt doubtOf(const Report& report, const ReportAxis& axis, size_t method, size_t point, Measure measure) {
  const Measured& measured = axis.points[point].methods[method];
  if (measured.broken) return Doubt::broken;
  if (!measured.limits.empty()) return Doubt::limit;
  double own = measure == Measure::own ? axis.error(method, axis.benignIndex()) : 0;
  double allowed = report.factor * std::fmax(own, axis.floor(point)) + 3 * axis.sigma(point);
  return axis.error(method, point) > allowed ? Doubt::error : Doubt::none;
}

Trusted trustedOf(const Report& report, const ReportAxis& axis, size_t method, Measure measure) {
  Trusted trusted{axis.benignIndex(), 0, Doubt::none, Doubt::none};
  auto doubt = [&](size_t point) { return doubtOf(report, axis, method, point, measure); };
  trusted.below = trusted.above = doubt(trusted.first);
  if (trusted.below != Doubt::none) return trusted;
  while (trusted.first > 0 && (trusted.below = doubt(trusted.first - 1)) == Doubt::none) --trusted.first;
  size_t end = axis.benignIndex() + 1;
  while (end < axis.points.size() && (trusted.above = doubt(end)) == Doubt::none) ++end;
  trusted.count = end - trusted.first;
  return trusted;
}

Json toJson(const Report& report) {
  Json json;
  json["strobe"] = report.strobe;
  json["title"] = report.title;
  json["note"] = report.note;
  json["command"] = report.command;
  json["device"] = {{"name", report.device}, {"driver", report.driver}, {"software", report.software}};
  json["size"] = {report.width, report.height};
  json["factor"] = report.factor;
  json["regions"] = kRegions;
  json["truth"] = report.truth;
  json["floor"] = report.floor;
  json["methods"] = report.methods;
  json["axes"] = json["variants"] = Json::array();
  for (const ReportAxis& axis : report.axes) json["axes"].push_back(axisJson(axis));
  json["cases"] = report.cases;
  for (const ReportVariant& variant : report.variants) json["variants"].push_back(variantJson(variant));
  return json;
}

Report reportFrom(const Json& json, const std::string& file) {
  Report report;
  try {
    report.strobe = json.at("strobe");
    report.title = json.at("title");
    report.note = json.at("note");
    report.command = json.at("command");
    report.device = json.at("device").at("name");
    report.driver = json.at("device").at("driver");
    report.software = json.at("device").at("software");
    report.width = json.at("size").at(0);
    report.height = json.at("size").at(1);
    report.factor = json.at("factor");
    report.truth = json.at("truth");
    report.floor = json.at("floor");
    report.methods = json.at("methods").get<std::vector<std::string>>();
    for (const Json& axis : json.at("axes")) report.axes.push_back(axisOf(axis));
    report.cases = json.at("cases").get<std::vector<std::string>>();
    for (const Json& variant : json.at("variants")) report.variants.push_back(variantOf(variant));
  } catch (const Json::exception& error) {
    throw Error(fmt::format("is no report of extremes: {}", error.what()), {file});
  }
  return report;
}

}  // namespace strobe::stability::curves
