// SPDX-License-Identifier: MIT
#include "study/results.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "base/lists.h"
#include "base/sealed_json.h"
#include "base/version.h"

namespace strobe::study {

namespace {

ArmRole roleOf(const std::string& name) {
  return name == "truth" ? ArmRole::truth : name == "floor" ? ArmRole::floor : ArmRole::method;
}

// Calls `visit` with the name and the member of each text field.
template <class It, class Visit>
void forTexts(It& axis, const Visit& visit, const AxisSummary*) {
  visit("name", axis.name), visit("title", axis.title), visit("unit", axis.unit), visit("scale", axis.scale);
  visit("region", axis.region), visit("fixed", axis.fixed), visit("note", axis.note), visit("reading", axis.reading);
}
template <class It, class Visit>
void forTexts(It& shot, const Visit& visit, const ShotSummary*) {
  visit("name", shot.name), visit("title", shot.title), visit("note", shot.note);
  visit("attribution", shot.attribution), visit("missing", shot.missing);
}
template <class It, class Visit>
void forTexts(It& point, const Visit& visit, const Point*) {
  visit("key", point.key), visit("arm", point.arm), visit("command", point.command), visit("failed", point.failed);
  visit("image", point.image), visit("preset", point.preset);
  visit("measured", point.measured);
  visit("shown", point.shown), visit("picture", point.picture), visit("record", point.record);
  visit("times", point.times), visit("device", point.device), visit("driver", point.driver);
}
template <class It, class Visit>
void forTexts(It& expectation, const Visit& visit, const Expectation*) {
  visit("text", expectation.text), visit("shot", expectation.shot), visit("axis", expectation.axis);
  visit("outcome", expectation.outcome), visit("detail", expectation.detail), visit("known", expectation.known);
}
template <class It, class Visit>
void forTexts(It& results, const Visit& visit, const Results*) {
  visit("strobe", results.strobe), visit("title", results.title), visit("question", results.question);
  visit("note", results.note), visit("command", results.command);
}

// Text fields that are not empty.
template <class It>
Json textsOf(const It& from) {
  Json json = Json::object();
  forTexts(
      from,
      [&](const char* name, const std::string& text) {
        if (!text.empty()) json[name] = text;
      },
      &from);
  return json;
}
template <class It>
void takeTexts(const Json& json, It& into) {
  forTexts(
      into, [&](const char* name, std::string& text) { text = json.value(name, ""); }, &into);
}

Point pointOf(const Json& json) {
  Point point;
  takeTexts(json, point);
  point.role = roleOf(json.at("role"));
  for (const auto& [measure, values] : json.at("values").items())
    for (const auto& [region, value] : values.items())
      if (!value.is_null()) point.values[measure][region] = value.get<double>();
  point.limits = json.value("limits", std::vector<std::string>());
  point.files = json.value("files", point.files);
  for (const Json& pass : json.value("passes", Json::array()))
    point.passes.push_back({pass.at(0), pass.at(1), pass.at(2), pass.at(3)});
  return point;
}

void require(bool sound, const std::string& mistake) {
  if (!sound) throw Error(mistake);
}

Json groupJson(const PointGroup& group) {
  Json json = {{"shot", group.shot}, {"anchor", group.anchor}, {"at", Json::object()}, {"points", Json::array()}};
  for (const auto& [axis, value] : group.at) json["at"][axis] = value;
  for (const Point& point : group.points) json["points"].push_back(toJson(point));
  return json;
}

PointGroup pointGroupFrom(const Json& json) {
  PointGroup group{json.at("shot"), json.at("anchor"), {}, {}};
  for (const auto& [axis, value] : json.at("at").items()) group.at.emplace_back(axis, value);
  for (const Json& point : json.at("points")) group.points.push_back(pointOf(point));
  require(!group.points.empty() && group.truth().role == ArmRole::truth, "a group of points has no truth");
  return group;
}

Json axisJson(const AxisSummary& axis) {
  Json json = textsOf(axis);
  if (axis.same_picture) json["same_picture"] = true;
  if (axis.benign) json["benign"] = *axis.benign;
  json["values"] = axis.values;
  json["labels"] = axis.labels;
  return json;
}

AxisSummary axisFrom(const Json& json) {
  AxisSummary axis;
  takeTexts(json, axis);
  axis.same_picture = json.value("same_picture", false);
  if (json.contains("benign")) axis.benign = json["benign"].get<size_t>();
  for (const Json& value : json.at("values")) axis.values.push_back(value);
  axis.labels = json.at("labels").get<std::vector<std::string>>();
  return axis;
}

Json shotJson(const ShotSummary& shot) {
  Json json = textsOf(shot);
  json["fps"] = numberJson(shot.fps);
  json["exposure"] = numberJson(shot.exposure);
  if (!shot.crops.empty()) json["crops"] = toJson(shot.crops);
  json["stops"] = shot.tone.stops;
  json["filmic"] = shot.tone.curve == image::ToneMap::Curve::filmic;
  return json;
}

ShotSummary shotOf(const Json& json) {
  ShotSummary shot;
  takeTexts(json, shot);
  shot.fps = json.at("fps");
  shot.exposure = json.at("exposure");
  shot.crops = cropsFrom(json.value("crops", Json::array()));
  shot.tone.stops = json.at("stops");
  if (json.at("filmic").get<bool>()) shot.tone.curve = image::ToneMap::Curve::filmic;
  return shot;
}

template <class It, class Of>
Json listOf(const std::vector<It>& from, const Of& of) {
  Json list = Json::array();
  for (const It& one : from) list.push_back(of(one));
  return list;
}

Json armJson(const ArmSummary& arm) {
  return {{"name", arm.name}, {"pipeline", arm.pipeline}, {"role", nameOf(arm.role)}, {"shown", arm.shown}};
}

Results read(const Json& json) {
  Results results;
  takeTexts(json, results);
  results.device = json.at("device").at("name");
  results.driver = json.at("device").at("driver");
  results.software = json.at("device").at("software");
  results.partial = json.value("partial", false);
  results.width = json.at("size").at(0);
  results.height = json.at("size").at(1);
  results.regions = json.at("regions").get<std::vector<std::string>>();
  results.measures = json.at("measures").get<std::vector<std::string>>();
  for (const Json& arm : json.at("arms"))
    results.arms.push_back({{arm.at("name"), arm.at("pipeline"), {}}, roleOf(arm.at("role")), arm.at("shown")});
  for (const Json& shot : json.at("shots")) results.shots.push_back(shotOf(shot));
  for (const Json& axis : json.at("axes")) results.axes.push_back(axisFrom(axis));
  results.layout = layoutFrom(json.at("layout"));
  for (const Json& group : json.at("groups")) results.groups.push_back(pointGroupFrom(group));
  for (const Json& expectation : json.at("expectations")) takeTexts(expectation, results.expectations.emplace_back());
  results.inputs = json.value("inputs", results.inputs);
  return results;
}

template <class It>
auto find(const std::vector<It>& all, const std::string& name) {
  return std::find_if(all.begin(), all.end(), [&](const It& one) { return one.name == name; });
}

template <class It>
const It& named(const std::vector<It>& all, const std::string& name) {
  auto found = find(all, name);
  STROBE_ASSERT(found != all.end(), "{}", name);
  return *found;
}

// ---- soundness of the names and numbers that reports use. Each check throws `Error` for the first mistake.

void requireMeasures(const Results& results) {
  std::vector<std::string> names = results.measures, known = measureNames();
  if (const auto& front = results.layout.front) names.insert(names.end(), {front->x, front->y});
  if (const auto& table = results.layout.table)
    for (const auto* list : {&table->cells, &table->once}) names.insert(names.end(), list->begin(), list->end());
  for (const std::string& name : names) require(contains(known, name), fmt::format("unknown measure '{}'", name));
}

void requireSound(const Results& results, const AxisSummary& axis) {
  const size_t count = axis.values.size();
  require(axis.labels.size() == count && axis.benign.value_or(0) < std::max<size_t>(count, 1),
          fmt::format("axis '{}' has {} values and {} labels", axis.name, count, axis.labels.size()));
  bool numbers = std::all_of(axis.values.begin(), axis.values.end(), [](const Json& one) { return one.is_number(); });
  require(numbers || !axis.hasCurves() || !results.layout.curves,
          fmt::format("axis '{}' has curves, but values that are not numbers", axis.name));
}

void requireSound(const Results& results, const ShotSummary& shot) {
  for (const image::Rectangle& crop : shot.crops)
    require(crop.x >= 0 && crop.y >= 0 && crop.width > 0 && crop.height > 0 &&
                int64_t(crop.x) + crop.width <= results.width && int64_t(crop.y) + crop.height <= results.height,
            fmt::format("a crop of shot '{}' lies outside the picture", shot.name));
}

void requireSound(const Results& results, const PointGroup& group) {
  require(find(results.shots, group.shot) != results.shots.end(), fmt::format("unknown shot '{}'", group.shot));
  for (const Point& point : group.points)
    require(find(results.arms, point.arm) != results.arms.end(), fmt::format("unknown arm '{}'", point.arm));
  for (const auto& [name, value] : group.at) {
    auto axis = find(results.axes, name);
    bool known =
        axis != results.axes.end() && std::find(axis->values.begin(), axis->values.end(), value) != axis->values.end();
    require(known, fmt::format("axis '{}' has no value {}", name, value.dump()));
  }
}

void requireSound(const Results& results) {
  require(std::min(results.width, results.height) >= 1 && std::max(results.width, results.height) <= plan::kMaxSide,
          fmt::format("the size is {}x{}", results.width, results.height));
  require(!results.arms.empty(), "the list of arms is empty");
  requireMeasures(results);
  for (const AxisSummary& axis : results.axes) requireSound(results, axis);
  for (const ShotSummary& shot : results.shots) requireSound(results, shot);
  for (const PointGroup& group : results.groups) requireSound(results, group);
}

// Cell of a CSV file, quoted if necessary.
std::string csvCell(const std::string& text) {
  if (text.find_first_of(",\"\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + "\"";
}

std::string csvNumber(const Json& value) {
  if (value.is_string()) return csvCell(value.get<std::string>());
  return value.is_number_float() ? fmt::format("{:.9g}", value.get<double>()) : value.dump();
}

// Value of every axis at a group, each after a comma.
std::string csvAxes(const Results& results, const PointGroup& group) {
  std::string text;
  for (const AxisSummary& axis : results.axes) {
    const Json* at = group.valueOn(axis.name);
    text += "," + (at ? csvNumber(*at) : "");
  }
  return text;
}

std::string csvHead(const Results& results, const std::string& fourth) {
  std::string text = "point,arm,shot," + fourth;
  for (const AxisSummary& axis : results.axes) text += "," + csvCell(axis.name);
  return text;
}

// Calls `row` with the number, group and point of each point except truths.
template <class Row>
void forPoints(const Results& results, const Row& row) {
  size_t number = 0;
  for (const PointGroup& group : results.groups)
    for (const Point& point : group.points)
      if (point.role != ArmRole::truth) row(++number, group, point);
}

}  // namespace

double Point::value(const std::string& measure, const std::string& region) const {
  constexpr double kNothing = std::numeric_limits<double>::quiet_NaN();
  auto values_of = values.find(measure);
  if (values_of == values.end()) return kNothing;
  auto found = values_of->second.find(measureNamed(measure).per_region ? region : "all");
  return found == values_of->second.end() ? kNothing : found->second;
}

std::string Point::lack() const {
  if (!failed.empty()) return "failed";
  if (isMissing()) return "not drawn";
  double pixels = value("broken");
  return pixels > 0 ? fmt::format("{:g} px not finite", pixels) : "";
}

std::string PointGroup::lackOf(const Point& point) const {
  std::string own = point.lack(), of_truth = truth().lack();
  if (!own.empty() || &point == &truth() || of_truth.empty()) return own;
  return "truth: " + of_truth;
}

const Json* PointGroup::valueOn(const std::string& axis) const {
  for (const auto& [name, value] : at)
    if (name == axis) return &value;
  return nullptr;
}

const Point* PointGroup::floor() const {
  for (const Point& point : points)
    if (point.role == ArmRole::floor) return &point;
  return nullptr;
}

const Point* PointGroup::find(const std::string& arm) const {
  for (const Point& point : points)
    if (point.arm == arm) return &point;
  return nullptr;
}

const ArmSummary& Results::arm(const std::string& name) const { return named(arms, name); }
const ShotSummary& Results::shot(const std::string& name) const { return named(shots, name); }

std::string Results::deviceOf(const Point& point) const {
  return fmt::format("{}, {}", point.device.empty() ? device : point.device,
                     point.driver.empty() ? driver : point.driver);
}

std::vector<std::string> Results::timedDevices() const {
  std::vector<std::string> devices;
  for (const PointGroup& group : groups)
    for (const Point& point : group.points)
      if (!point.times.empty()) addOnce(devices, deviceOf(point));
  return devices;
}

Results Results::onDevice(const std::string& wanted) const {
  Results own = *this;
  own.expectations.clear();
  own.partial = true;
  std::set<std::string> shown;
  for (PointGroup& group : own.groups) {
    std::erase_if(group.points,
                  [&](const Point& point) { return point.role != ArmRole::truth && deviceOf(point) != wanted; });
    if (group.points.size() > 1) shown.insert(group.shot);
  }
  std::erase_if(own.groups, [](const PointGroup& group) { return group.points.size() < 2; });
  std::erase_if(own.shots, [&](const ShotSummary& shot) { return shot.missing.empty() && !shown.count(shot.name); });
  return own;
}

std::vector<std::string> Results::contradicted() const {
  std::vector<std::string> contradictions;
  for (const Expectation& one : expectations) {
    if (!one.contradicts()) continue;
    std::string what = one.known.empty() ? "" : "; known to fail: " + one.known;
    contradictions.push_back(fmt::format("expectation {}{}: {}{}", one.outcome, what, one.text,
                                         one.detail.empty() ? "" : " (" + one.detail + ")"));
  }
  return contradictions;
}

std::string describe(const PointGroup& group, const std::string& without) {
  std::vector<std::string> parts;
  for (const auto& [axis, value] : group.at)
    if (axis != without) parts.push_back(axis + " " + (value.is_string() ? value.get<std::string>() : value.dump()));
  return fmt::format("{}", fmt::join(parts, ", "));
}

std::string afterComma(const std::string& text) { return text.empty() ? "" : ", " + text; }

std::string describe(const PointGroup& group, const Point& point) {
  return fmt::format("{}{}, {}: {}", group.shot, afterComma(describe(group)), point.arm, point.failed);
}

std::vector<std::string> Results::failed() const {
  std::vector<std::string> failures;
  for (const PointGroup& group : groups)
    for (const Point& point : group.points)
      if (!point.failed.empty()) failures.push_back(describe(group, point));
  return failures;
}

size_t Results::missing() const {
  size_t count = 0;
  for (const PointGroup& group : groups)
    for (const Point& point : group.points) count += point.role != ArmRole::truth && point.isMissing();
  return count;
}

size_t Results::points() const {
  size_t count = 0;
  for (const PointGroup& group : groups) count += group.points.size() - 1;
  return count;
}

size_t Results::truths(bool missing) const {
  std::set<std::string> commands;
  for (const PointGroup& group : groups)
    if (!missing || group.truth().isMissing()) commands.insert(group.truth().key.empty() ? "" : group.truth().command);
  return countTruths(commands);
}

std::string Results::missingText() const {
  std::vector<std::string> parts;
  if (size_t left = missing()) parts.push_back(fmt::format("{} of {} points", left, points()));
  if (size_t left = truths(true)) parts.push_back(fmt::format("{} of {} truths", left, truths()));
  return fmt::format("{}", fmt::join(parts, ", "));
}

Json numberJson(double value) {
  if (!std::isfinite(value)) return nullptr;
  return std::strtod(fmt::format("{:.9g}", value).c_str(), nullptr);
}

void takeTexts(const Json& json, AxisSummary& axis) { takeTexts<AxisSummary>(json, axis); }
void takeTexts(const Json& json, ShotSummary& shot) { takeTexts<ShotSummary>(json, shot); }

Json toJson(const std::vector<image::Rectangle>& crops) {
  return listOf(crops, [](const image::Rectangle& crop) { return Json{crop.x, crop.y, crop.width, crop.height}; });
}

std::vector<image::Rectangle> cropsFrom(const Json& json) {
  std::vector<image::Rectangle> crops;
  for (const Json& crop : json) crops.push_back({crop.at(0), crop.at(1), crop.at(2), crop.at(3)});
  return crops;
}

Json toJson(const Point& point) {
  Json json = textsOf(point);
  json["role"] = nameOf(point.role);
  json["values"] = Json::object();
  for (const auto& [measure, values] : point.values)
    for (const auto& [region, value] : values) json["values"][measure][region] = numberJson(value);
  if (!point.limits.empty()) json["limits"] = point.limits;
  if (!point.files.empty()) json["files"] = point.files;
  for (const PassTime& pass : point.passes)
    json["passes"].push_back({pass.pass, numberJson(pass.ms), numberJson(pass.low), numberJson(pass.high)});
  return json;
}

Point pointFrom(const Json& json, const std::string& file) {
  try {
    return pointOf(json);
  } catch (const Json::exception&) {
    throw Error("is not a point of an experiment", {file});
  }
}

Json toJson(const Results& results) {
  Json json = textsOf(results);
  json["device"] = {{"name", results.device}, {"driver", results.driver}, {"software", results.software}};
  json["size"] = {results.width, results.height};
  if (results.partial) json["partial"] = true;
  if (results.missing() > 0) json["missing"] = results.missing();
  json["regions"] = results.regions;
  json["measures"] = results.measures;
  json["arms"] = listOf(results.arms, armJson);
  json["shots"] = listOf(results.shots, shotJson);
  json["axes"] = listOf(results.axes, axisJson);
  json["layout"] = results.layout.json;
  json["expectations"] = listOf(results.expectations, [](const Expectation& one) { return textsOf(one); });
  if (!results.inputs.empty()) json["inputs"] = results.inputs;
  json["groups"] = listOf(results.groups, groupJson);
  return json;
}

Results resultsFrom(const Json& json, const std::string& file) {
  auto refuse = [&](const std::string& reason) {
    throw Error(
        fmt::format("is not a result of an experiment, or is damaged{}; the same sweep writes it again", reason),
        {file});
  };
  Results results;
  try {
    results = read(json);
    requireSound(results);
  } catch (const Json::exception&) {
    refuse("");
  } catch (const Error& error) {
    refuse(": " + error.message());
  }
  return results;
}

Results resultsIn(const Path& file) {
  std::string text = readText(file);
  Json json = Json::parse(text, nullptr, false);
  if (json.is_object() && json.contains("sum")) json = unsealed(text).value_or(Json());
  return resultsFrom(json, file.string());
}

std::string textOf(const Results& results) { return sealed(toJson(results)); }

Results outlineOf(const Experiment& experiment) {
  Results results{experiment};
  results.strobe = kVersion;
  results.arms.assign(experiment.arms.begin(), experiment.arms.end());
  results.arms.push_back(experiment.truth);
  results.shots.assign(experiment.shots.begin(), experiment.shots.end());
  results.axes.assign(experiment.axes.begin(), experiment.axes.end());
  return results;
}

void relabel(const Home& home, Results& results, const Experiment& experiment) {
  results.title = experiment.title, results.question = experiment.question, results.note = experiment.note;
  results.layout = experiment.layout;
  for (AxisSummary& axis : results.axes)
    for (AxisSummary now : experiment.axes) {
      if (axis.name != now.name) continue;
      now.values = axis.values, now.labels = axis.labels;
      axis = now;
    }
  for (ShotSummary& shot : results.shots)
    for (const ShotSummary& now : experiment.shots)
      if (shot.name == now.name) shot.title = now.title, shot.note = now.note;
  judgeResults(home, results, experiment.file);
}

// Results as expectations read them. Times of several devices are not comparable, so they are left out, and the field
// `incomparable` names their measures.
static Json judgedJson(Results results) {
  if (results.timedDevices().size() < 2) return toJson(results);
  std::set<std::string> times;
  for (PointGroup& group : results.groups)
    for (Point& point : group.points)
      std::erase_if(point.values, [&](const auto& value) {
        return measureNamed(value.first).isTime() && (times.insert(value.first), true);
      });
  Json json = toJson(results);
  json["incomparable"] = times;
  return json;
}

void judgeResults(const Home& home, Results& results, const std::string& file) {
  results.expectations.clear();
  for (const Json& one : judge(home, file, judgedJson(results))) takeTexts(one, results.expectations.emplace_back());
}

static std::string csvMeasured(double value) { return std::isnan(value) ? "" : fmt::format("{:.9g}", value); }

// Standard error of truth, stored as the RMSE or MSE of truth itself.
static double truthError(const PointGroup& group, const std::string& region) {
  double rmse = group.truth().value("rmse", region);
  return std::isnan(rmse) ? std::sqrt(group.truth().value("mse", region)) : rmse;
}

static std::string csvMethod(const Results& results, const PointGroup& group, const Point& point,
                             const std::string& region) {
  if (point.isMissing()) return ",,,";
  return fmt::format(",{},{},{}", csvMeasured(truthError(group, region)), csvCell(results.arm(point.arm).pipeline),
                     csvCell(point.preset));
}

std::string csvOf(const Results& results) {
  std::string text = csvHead(results, "region");
  for (const std::string& measure : results.measures) text += "," + measure;
  text += ",truth_error,pipeline,preset";
  bool has_notes = false;
  forPoints(results, [&](size_t, const PointGroup& group, const Point& point) {
    has_notes = has_notes || !group.lackOf(point).empty();
  });
  const bool has_devices = results.timedDevices().size() > 1;
  text += has_devices ? ",device" : "";
  text += has_notes ? ",note\n" : "\n";
  forPoints(results, [&](size_t number, const PointGroup& group, const Point& point) {
    std::string note = group.lackOf(point) + (point.failed.empty() || point.isMissing() ? "" : ": " + point.failed);
    for (const std::string& region : results.regions) {
      text += fmt::format("{},{},{},{}{}", number, csvCell(point.arm), csvCell(group.shot), region,
                          csvAxes(results, group));
      for (const std::string& measure : results.measures) text += "," + csvMeasured(point.value(measure, region));
      text += csvMethod(results, group, point, region);
      if (has_devices) text += "," + (point.isMissing() ? "" : csvCell(results.deviceOf(point)));
      text += (has_notes ? "," + csvCell(note) : "") + "\n";
    }
  });
  return text;
}

std::string passesCsvOf(const Results& results) {
  std::string text;
  const bool has_devices = results.timedDevices().size() > 1;
  forPoints(results, [&](size_t number, const PointGroup& group, const Point& point) {
    for (const PassTime& pass : point.passes)
      text += fmt::format("{},{},{},{}{},{:.9g},{:.9g},{:.9g}{}\n", number, csvCell(point.arm), csvCell(group.shot),
                          csvCell(pass.pass), csvAxes(results, group), pass.ms, pass.low, pass.high,
                          has_devices ? "," + csvCell(results.deviceOf(point)) : "");
  });
  return text.empty() ? ""
                      : csvHead(results, "pass") + ",ms,ms_low,ms_high" + (has_devices ? ",device\n" : "\n") + text;
}

}  // namespace strobe::study
