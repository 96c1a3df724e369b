// SPDX-License-Identifier: MIT
#include "study/tune.h"

#include <algorithm>
#include <cmath>

#include "base/hash.h"
#include "base/lists.h"
#include "base/log.h"
#include "lab/shot_options.h"
#include "script/lua_text.h"
#include "study/run.h"
#include "study/watch.h"

namespace strobe::study {

namespace {

// Precision of a level: size as a share of the picture, time samples of truth, timed frames.
struct Level {
  double scale;
  int64_t truth_samples;
  lab::Rounds rounds;
};
const std::vector<Level> kLevels = {{0.5, 64, {5, 5, 0}}, {1, 64, {5, 5, 0}}, {1, 256, {5, 11, 0.05}}};
// Timed frames for the final choice among a few settings.
const lab::Rounds kAtLast = {15, 45, 0.02};
constexpr size_t kChosenAmong = 5, kTimedAgain = 20;
constexpr double kSaidEvery_s = 20;  // interval of progress reports
constexpr int kStartsTried = 6;      // generated starts per evaluation; some are refused or equal

bool isSet(const lab::Shot& shot, const std::string& name) {
  return std::any_of(shot.sets.begin(), shot.sets.end(), [&](const auto& set) { return set.first == name; });
}

bool isOfMethod(const plan::ParamDesc& param) {
  using plan::Role;
  return param.role != Role::Shading && param.role != Role::SampleTimes && param.role != Role::Regions;
}

// True if one of the nodes uses the parameter.
bool isFollowed(const plan::PipelineDesc& pipeline, const std::set<std::string>& nodes, const std::string& name) {
  for (const plan::NodeDesc& node : pipeline.nodes)
    for (const auto& [param, bound] : node.params)
      if (bound.follows == name && nodes.count(node.name)) return true;
  return false;
}

std::string labelOf(const plan::Value& value) {
  return std::holds_alternative<std::string>(value) ? std::get<std::string>(value) : plan::textOf(value);
}

class Tuner {
 public:
  Tuner(const TuneRequest& request, lab::Workbench& bench, const Store& store)
      : request_(request), bench_(bench), store_(store), batch_(bench) {}

  Tuned tune();

 private:
  bool isErrorLimited() const {
    return request_.limits == TuneRequest::Limit::error || request_.limits == TuneRequest::Limit::error_ratio;
  }
  void prepare();
  void addShots(const lab::Shot& filled);
  std::vector<Spot> starts() const;
  std::string identityOf(const Spot& spot);
  Group groupOf(const Spot& spot, int level);
  const PointGroup& groupSeen(const Spot& spot, int level);
  std::vector<const PointGroup*> see(const std::vector<Spot>& spots, int level, const lab::Rounds& rounds);
  void keep(Results seen);
  Score scoreOf(const Point& point, int level);
  const Point& basePoint(int level);
  Goal goalOf();
  Measured measuredOf(const Point& point, const Spot& spot) const;
  script::Settings changedBy(const Spot& spot) const;
  void choose(const Search& search, Tuned& tuned);
  void report(const std::string& what, const Search& search);

  const TuneRequest request_;
  lab::Workbench& bench_;
  const Store& store_;
  lab::Batch batch_;
  std::shared_ptr<const plan::PipelineDesc> pipeline_;
  Space space_;
  Experiment experiment_;  // without groups; axes get values when settings are measured
  Results results_;        // results of all measured settings
  double said_s_ = 0;      // time of the last progress report
};

// ---- the experiment

// Adds a shot for each level, best first, which is the order in reports.
void Tuner::addShots(const lab::Shot& filled) {
  for (size_t i = kLevels.size(); i-- > 0;) {
    const Level& level = kLevels[i];
    StudiedShot studied;
    studied.shot = filled;
    studied.shot.pipeline.clear();
    studied.shot.sets = lab::sceneSettings(filled.sets);
    studied.shot.width = std::max(1, int(std::lround(filled.width * level.scale)));
    studied.shot.height = std::max(1, int(std::lround(filled.height * level.scale)));
    studied.name = fmt::format("level {}", i + 1);
    studied.title =
        fmt::format("{}x{}, truth of {} samples", studied.shot.width, studied.shot.height, level.truth_samples);
    std::shared_ptr<const plan::PipelineDesc> truth = batch_.evaluate(experiment_.truth.pipeline, {});
    lab::putRole(studied.truth, *truth, plan::Role::SampleCount, level.truth_samples);
    experiment_.shots.push_back(std::move(studied));
  }
}

void Tuner::prepare() {
  lab::Shot filled = batch_.filled(request_.shot);
  try {
    pipeline_ = batch_.evaluate(filled.pipeline, filled.sets);
  } catch (const lab::Refusal& refusal) {
    throw Error(refusal.message(), {}, 2);
  }
  space_ = spaceOf(*pipeline_, capturedNodes(batch_, filled), request_);
  script::Settings own;
  std::remove_copy_if(filled.sets.begin(), filled.sets.end(), std::back_inserter(own), lab::isOfScene);
  StudiedArm tuned{{{pipeline_->name, filled.pipeline, own}}}, base{{{"base", filled.pipeline}}};
  if (request_.base.empty()) base.name = pipeline_->name + " as it is", base.sets = own;
  else base.name = "base " + request_.base, base.pipeline = request_.base;
  experiment_.arms = {tuned, base};
  experiment_.base = base.name;
  experiment_.truth = {{{"truth", batch_.nameOf(plan::PipelineDesc::Kind::Truth)}, ArmRole::truth}};
  experiment_.title = fmt::format("{} tuned on {}", pipeline_->name, Path(filled.scene).stem().string());
  store_.belongTo(experiment_.title);
  experiment_.width = experiment_.file_width = filled.width;
  experiment_.height = experiment_.file_height = filled.height;
  experiment_.regions = {request_.region};
  if (request_.region != "whole") experiment_.regions.insert(experiment_.regions.begin(), "whole");
  experiment_.measures = {request_.measure, "ms", "ms_ratio", "ms_own", "own_ratio"};
  experiment_.is_step = true;
  experiment_.layout =
      layoutFrom({{"front", {{"x", request_.ratioName()}, {"y", request_.measure}, {"region", request_.region}}}});
  for (const Dimension& dimension : space_) {
    Axis axis;
    axis.name = axis.title = dimension.param.name, axis.unit = dimension.param.unit;
    experiment_.axes.push_back(axis);
  }
  addShots(filled);
}

// Group of a setting. Its axes are the parameters that differ from the request.
Group Tuner::groupOf(const Spot& spot, int level) {
  Group group;
  group.shot = kLevels.size() - 1 - size_t(level);
  group.arms = {0};
  for (size_t d = 0; d < space_.size(); ++d) {
    if (spot[d] == space_[d].start) continue;
    Axis& axis = experiment_.axes[d];
    const Json value = plan::toJson(spot[d]);
    size_t at = size_t(std::find(axis.values.begin(), axis.values.end(), value) - axis.values.begin());
    if (at == axis.values.size()) {
      axis.values.push_back(value), axis.labels.push_back(labelOf(spot[d]));
      axis.settings.emplace_back().sets = {{space_[d].param.name, spot[d]}};
    }
    group.at.push_back({d, at});
  }
  if (group.at.empty()) group.arms = {0, 1};
  return group;
}

// ---- measurement

void Tuner::keep(Results seen) {
  std::vector<PointGroup> groups = std::move(seen.groups);
  seen.groups = std::move(results_.groups);
  seen.inputs.merge(results_.inputs);
  for (size_t i = 0; i < results_.shots.size(); ++i)
    if (results_.shots[i].fps > 0) seen.shots[i] = results_.shots[i];  // shots of levels without points in this step
  results_ = std::move(seen);
  for (PointGroup& group : groups) {
    auto same = std::find_if(results_.groups.begin(), results_.groups.end(),
                             [&](const PointGroup& known) { return known.shot == group.shot && known.at == group.at; });
    if (same == results_.groups.end()) results_.groups.push_back(std::move(group));
    else *same = std::move(group);
  }
}

const PointGroup& Tuner::groupSeen(const Spot& spot, int level) {
  Group wanted = groupOf(spot, level);
  std::vector<std::pair<std::string, Json>> at;
  for (const At& one : wanted.at)
    at.emplace_back(experiment_.axes[one.axis].name, experiment_.axes[one.axis].values[one.value]);
  auto found = std::find_if(results_.groups.begin(), results_.groups.end(), [&](const PointGroup& known) {
    return known.shot == experiment_.shots[wanted.shot].name && known.at == at;
  });
  STROBE_ASSERT(found != results_.groups.end());
  return *found;
}

// Draws, measures and times settings and the base in turn. Returns the groups in the given order.
std::vector<const PointGroup*> Tuner::see(const std::vector<Spot>& spots, int level, const lab::Rounds& rounds) {
  Experiment step = experiment_;
  step.groups = {groupOf(startOf(space_), level)};
  for (const Spot& spot : spots)
    if (spot != startOf(space_)) step.groups.push_back(groupOf(spot, level));
  step.axes = experiment_.axes;
  step.rounds = rounds;
  lab::Batch batch(bench_);
  keep(run(step, batch, store_));
  std::vector<const PointGroup*> seen;
  for (const Spot& spot : spots) seen.push_back(&groupSeen(spot, level));
  return seen;
}

const Point& Tuner::basePoint(int level) {
  const Point& point = groupSeen(startOf(space_), level).points.back();
  if (!point.failed.empty()) throw Error(fmt::format("{}: {}", point.arm, point.failed));
  return point;
}

Score Tuner::scoreOf(const Point& point, int level) {
  double error = point.value(request_.measure, request_.region), cost = point.value(request_.ratioName());
  if (request_.limits == TuneRequest::Limit::error_ratio)
    error /= basePoint(level).value(request_.measure, request_.region);
  return {std::isfinite(error) && std::isfinite(cost), error, cost};
}

// Converts a limit in milliseconds to a multiple of the base's time.
Goal Tuner::goalOf() {
  if (isErrorLimited()) return {Goal::Kind::least_cost, request_.limit};
  double base_ms =
      request_.limits == TuneRequest::Limit::ms ? basePoint(int(kLevels.size()) - 1).value(request_.msName()) : 1;
  return {Goal::Kind::least_error, request_.limit / base_ms};
}

// ---- the search

// Equal for settings with equal passes, wiring and values.
std::string Tuner::identityOf(const Spot& spot) {
  lab::Shot shot = shotOf(experiment_, groupOf(spot, int(kLevels.size()) - 1), experiment_.arms[0]);
  try {
    return hashText(lab::identityOf(*batch_.planOf(shot)));
  } catch (const lab::Refusal&) {
    return "";
  }
}

// Start settings: the request, each preset, then points of the Sobol sequence around each of these in turn.
std::vector<Spot> Tuner::starts() const {
  std::vector<Spot> centres = {startOf(space_)};
  for (const plan::PresetDesc& preset : pipeline_->presets) {
    Spot spot;
    for (const Dimension& one : space_) {
      auto set = std::find_if(preset.values.begin(), preset.values.end(),
                              [&](const auto& value) { return value.first == one.param.name; });
      spot.push_back(set == preset.values.end() ? one.param.default_value : set->second);
    }
    addOnce(centres, spot);
  }
  const Home& home = bench_.home();
  Json points = script::evaluateData(home, home.at("scripts/tune/starts.lua").string(),
                                     {{"count", kStartsTried * request_.evaluations}, {"width", space_.size()}});
  std::vector<Spot> starts = centres;
  for (size_t i = 0; i < points.size(); ++i)
    starts.push_back(spotAt(space_, centres[i % centres.size()], points[i].get<std::vector<double>>()));
  return starts;
}

// Prints progress, and the front of the first shot at the last level.
void Tuner::report(const std::string& what, const Search& search) {
  said_s_ = clockSeconds();
  Results last = results_;
  std::erase_if(last.groups, [&](const PointGroup& group) { return group.shot != experiment_.shots[0].name; });
  std::string front = frontSoFar(last);
  note(fmt::format("{}; {} of {} evaluations\n{}", what, search.evaluations(), request_.evaluations,
                   front.substr(0, front.find('\n'))));
}

script::Settings Tuner::changedBy(const Spot& spot) const {
  script::Settings changed;
  for (size_t d = 0; d < space_.size(); ++d)
    if (spot[d] != space_[d].start) changed.emplace_back(space_[d].param.name, spot[d]);
  return changed;
}

Measured Tuner::measuredOf(const Point& point, const Spot& spot) const {
  return {changedBy(spot),
          point.value(request_.measure, request_.region),
          point.value(request_.measure),
          point.value(request_.msName()),
          point.value(request_.ratioName()),
          point.command};
}

// Final choice. Times the few best settings once more, because a single short time may be low by chance. Continues with
// the next few settings if none meets the limit.
void Tuner::choose(const Search& search, Tuned& tuned) {
  const int last = int(kLevels.size()) - 1;
  const bool by_ms = request_.limits == TuneRequest::Limit::ms;
  Goal goal = goalOf();
  std::vector<Search::Found> found = search.found();
  std::stable_sort(found.begin(), found.end(),
                   [&](const Search::Found& a, const Search::Found& b) { return goal.isBetter(a.score, b.score); });
  if (found.size() > kTimedAgain) found.resize(kTimedAgain);
  const Spot* best = nullptr;
  Score least;
  for (size_t first = 0; first < found.size() && !(best && goal.holds(least)); first += kChosenAmong) {
    std::vector<Spot> spots;
    for (size_t i = first; i < std::min(first + kChosenAmong, found.size()); ++i) spots.push_back(found[i].spot);
    see(spots, last, kAtLast);
    goal = goalOf();
    if (by_ms) goal.limit = request_.limit;  // milliseconds, not a ratio to the base
    for (size_t i = 0; i < spots.size(); ++i) {
      const Point& point = groupSeen(spots[i], last).points[1];
      Score score = scoreOf(point, last);
      if (by_ms) score.cost = point.value(request_.msName());
      if (!best || goal.isBetter(score, least)) best = &found[first + i].spot, least = score;
    }
  }
  tuned.start = measuredOf(groupSeen(startOf(space_), last).points[1], startOf(space_));
  tuned.base = measuredOf(basePoint(last), startOf(space_));
  if (!best) return;
  Measured measured = measuredOf(groupSeen(*best, last).points[1], *best);
  if (!goal.holds(least)) {
    tuned.nearest = measured;
    return;
  }
  tuned.chosen = measured;
  script::Settings sets = joined(experiment_.arms[0].sets, measured.changed);
  std::shared_ptr<const plan::PipelineDesc> chosen = batch_.evaluate(request_.shot.pipeline, sets);
  for (const auto& [name, value] : chosen->values)
    if (value != plan::paramNamed(*chosen, name)->default_value) tuned.values.emplace_back(name, value);
}

Tuned Tuner::tune() {
  prepare();
  const int last = int(kLevels.size()) - 1;
  const Spot start = startOf(space_);
  see({start}, last, kLevels.back().rounds);
  for (const Point& point : groupSeen(start, last).points)
    if (!point.failed.empty()) throw Error(fmt::format("{}: {}", point.arm, point.failed));
  if (!std::isfinite(basePoint(last).value(request_.measure, request_.region)))
    throw Error(fmt::format("the region '{}' has no pixels in this shot: use another --region", request_.region), {},
                2);

  Search* running = nullptr;
  auto identity = [&](const Spot& spot) { return identityOf(spot); };
  auto measure = [&](const std::vector<Spot>& spots, int level) {
    std::vector<Score> scores;
    for (const PointGroup* group : see(spots, level, kLevels[size_t(level)].rounds))
      scores.push_back(group->points[1].failed.empty() ? scoreOf(group->points[1], level) : Score());
    if (clockSeconds() - said_s_ > kSaidEvery_s) this->report("searching", *running);
    return scores;
  };
  auto report = [&](const std::string& what) { this->report(what, *running); };
  Search search(space_, goalOf(), {request_.evaluations, int(kLevels.size()), 3}, identity, measure, report);
  running = &search;
  search.run(starts());

  Tuned tuned;
  choose(search, tuned);
  tuned.evaluations = search.evaluations(), tuned.finished = search.finished();
  std::erase_if(results_.groups, [](const PointGroup& group) { return !group.points[1].failed.empty(); });
  tuned.results = std::move(results_);
  tuned.results.axes = outlineOf(experiment_).axes;
  std::erase_if(tuned.results.axes, [](const AxisSummary& axis) { return axis.values.empty(); });
  return tuned;
}

}  // namespace

Space spaceOf(const plan::PipelineDesc& pipeline, const std::set<std::string>& captured, const TuneRequest& request) {
  if (pipeline.kind == plan::PipelineDesc::Kind::Truth)
    throw Error(fmt::format("'{}' is truth and has no reference for its error", pipeline.name), {}, 2);
  std::vector<std::string> names;
  for (const plan::ParamDesc& param : pipeline.params)
    if (!isSet(request.shot, param.name)) names.push_back(param.name);
  for (const std::string& name : request.vary) {
    if (contains(names, name)) continue;
    if (isSet(request.shot, name)) throw Error(fmt::format("--vary: '{}' is also set", name), {}, 2);
    throw Error(fmt::format("--vary: '{}' has no parameter '{}'{}", pipeline.name, name, didYouMean(name, names)), {},
                2);
  }
  Space space;
  for (const plan::ParamDesc& param : pipeline.params) {
    bool asked = contains(request.vary, param.name);
    if (request.vary.empty()) asked = isOfMethod(param) && !isFollowed(pipeline, captured, param.name);
    if (asked && !isSet(request.shot, param.name)) space.push_back({param, *plan::valueOf(pipeline, param.name)});
  }
  if (space.empty()) throw Error(fmt::format("'{}' has no parameter to vary", pipeline.name), {}, 2);
  return space;
}

Tuned tune(const TuneRequest& request, lab::Workbench& bench, const Store& store) {
  return Tuner(request, bench, store).tune();
}

std::string presetText(const std::vector<std::string>& doc, const script::Settings& values) {
  std::vector<std::string> lines;
  for (const std::string& line : doc) lines.push_back(script::quoted(line));
  std::string text =
      "-- Written by `strobe tune`. Use it with `--set preset=` and the name of this file.\nlocal preset = require "
      "\"strobe.preset\"\n\nreturn preset {\n";
  text += fmt::format("  doc = {},\n  set = {{\n", fmt::join(lines, " ..\n    "));
  for (const auto& [name, value] : values) text += fmt::format("    {},\n", script::field(name, script::luaOf(value)));
  return text + "  },\n}\n";
}

}  // namespace strobe::study
