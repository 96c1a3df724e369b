// SPDX-License-Identifier: MIT
#include "study/run.h"

#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <set>

#include "base/hash.h"
#include "base/interruption.h"
#include "base/log.h"
#include "lab/record.h"
#include "math/statistics.h"
#include "plan/plan.h"
#include "study/point_renderer.h"
#include "study/watch.h"

namespace strobe::study {

// Pass of each node in the plan, by the name of the node.
static std::map<std::string, std::string> passByNode(const plan::Plan& plan) {
  std::map<std::string, std::string> passes;
  for (const plan::PlanNode& node : plan.nodes) {
    const plan::NodeDesc& described = plan.descOf(node);
    passes[described.name] = described.pass;
  }
  return passes;
}

std::set<std::string> capturedNodes(lab::Batch& batch, const lab::Shot& shot) {
  lab::Shot sharp = shot;
  sharp.pipeline = batch.nameOf(plan::PipelineDesc::Kind::Sharp);
  sharp.sets = lab::sceneSettings(shot.sets);
  sharp.taps.clear();
  std::map<std::string, std::string> captured = passByNode(*batch.planOf(sharp));
  std::set<std::string> nodes;
  for (const auto& [name, pass] : passByNode(*batch.planOf(shot))) {
    auto same = captured.find(name);
    if (same != captured.end() && same->second == pass) nodes.insert(name);
  }
  return nodes;
}

namespace {

// ---- drawing

// Draws the remaining groups. Leaves a group for later if another program draws one of its points. At the end, waits
// for these points, and draws the points that an ended program has left.
void renderAll(PointRenderer& renderer, std::vector<const TaskGroup*> groups, const PointRenderer::Progress& progress) {
  constexpr double kPoll_s = 0.2;
  while (!groups.empty()) {
    std::vector<const TaskGroup*> left;
    for (const TaskGroup* group : groups)
      if (!renderer.render(*group, progress)) left.push_back(group);
    if (left.size() == groups.size()) waitFor(kPoll_s);
    groups = std::move(left);
  }
}

void renderHere(const Experiment& experiment, lab::Batch& batch, const Store& store,
                const std::vector<TaskGroup>& groups, Worker& worker, ProgressWatch& watch) {
  const Remaining remaining = remainingOf(groups, store);
  if (remaining.set_aside > 0 && watch.now)
    note(fmt::format("{} set aside after {} failed tries; --retry tries again",
                     remaining.set_aside == 1 ? "1 point is" : fmt::format("{} points are", remaining.set_aside),
                     kMostTries));
  if (remaining.groups.empty()) return;
  watch.begin("drawing", remaining.cost);
  PointRenderer renderer(experiment, batch, store, worker, remaining.tries);
  renderAll(renderer, remaining.groups, [&](int by) { watch.advance(by); });
  watch.end();
  if (!watch.now) return;
  const PointRenderer::Spent& spent = renderer.spent();
  note(fmt::format("{:.1f} s drawing, {:.1f} s measuring, {:.1f} s writing", spent.drawing_s, spent.measuring_s,
                   spent.keeping_s));
}

// ---- times

// Base of the time ratios of a shot: the first point of the base arm, else the first timed point. Points of other
// shares count as drawn, so that all programs choose the same base.
const Task* baseOf(const Experiment& experiment, const std::vector<TaskGroup>& groups, const Store& store,
                   size_t shot) {
  const Task* first = nullptr;
  for (const TaskGroup& group : groups)
    for (const Task& task : group.tasks) {
      if (group.group->shot != shot || !task.timed) continue;
      if (group.is_mine ? !store.has(task.key) : task.key.empty()) continue;
      if (task.arm->name == experiment.base) return &task;
      if (!first) first = &task;
    }
  return first;
}

// Text for the base in `Point::times`. Times with another base or with other rounds are measured again.
std::string baseTextOf(const Task& task, const Task& base) {
  bool is_ratio = std::any_of(task.measures.begin(), task.measures.end(),
                              [](const std::string& name) { return measureNamed(name).to_base; });
  return is_ratio ? ", base " + base.key : "";
}

std::string timesOf(const Experiment& experiment, const Task& task, const Task& base) {
  const lab::Rounds& rounds = experiment.rounds;
  return fmt::format("{} to {} rounds, {}{}", rounds.least, rounds.most, rounds.within, baseTextOf(task, base));
}

bool lacksTimes(const Experiment& experiment, const Task& task, const Task& base, const Store& store) {
  if (!task.timed || !store.has(task.key)) return false;
  Point point = store.point(task.key).value_or(Point());
  // In a search, times of more rounds are also valid (the text starts with their number), so that times of the last
  // step stay.
  bool enough = experiment.is_step && !point.times.empty() && std::stoi(point.times) >= experiment.rounds.least &&
                point.times.ends_with(baseTextOf(task, base));
  bool good = enough || point.times == timesOf(experiment, task, base);
  return !good || std::any_of(task.measures.begin(), task.measures.end(), [&](const std::string& name) {
    return measureNamed(name).isTime() && !point.values.count(name);
  });
}

std::vector<PassTime> passesOf(const lab::Timing& timing) {
  std::vector<PassTime> passes;
  for (const auto& [name, ms] : timing.passes)
    passes.push_back({name, median(ms), quantile(ms, 0.25), quantile(ms, 0.75)});
  return passes;
}

// Milliseconds of the passes that are the method's own, by round.
std::vector<double> ownMs(lab::Batch& batch, const lab::Shot& shot, const lab::Timing& timing) {
  std::set<std::string> captured = capturedNodes(batch, shot);
  std::vector<double> ms(timing.ms.size(), 0);
  for (const auto& [name, by_round] : timing.passes)
    for (size_t i = 0; i < ms.size() && !captured.count(name); ++i) ms[i] += by_round[i];
  return ms;
}

// Times of a frame, and of the passes that are the method's own.
struct Times {
  lab::Timing frame;
  std::vector<double> own_ms;
};

void keepTimes(const Store& store, const Task& task, const std::string& times, const Times& own, const Times& base) {
  const TimesInput input = {own.frame.ms, base.frame.ms, own.own_ms, base.own_ms};
  std::optional<Point> kept = store.point(task.key);
  if (!kept) return;  // damaged in the meantime; the next sweep makes the point again
  Point& point = *kept;
  point.failed.clear(), point.times = times;
  point.passes = passesOf(own.frame);
  for (const std::string& name : task.measures)
    if (measureNamed(name).isTime()) point.values[name]["all"] = measureNamed(name).of_times(input);
  store.keep(task.key, point);
  store.finish(task.key);
}

// Tasks that are timed in turn, with the base of their shot.
struct TimedTurn {
  const Task* base;
  std::vector<const Task*> tasks;
};

// Turns with tasks that lack times. The groups of one shot along one axis are one turn; in a search step, all groups of
// a shot. Every other group is a turn of its own.
std::vector<TimedTurn> remainingTurns(const Experiment& experiment, const std::vector<TaskGroup>& groups,
                                      const Store& store) {
  std::vector<TimedTurn> turns;
  std::map<size_t, const Task*> bases;  // by shot
  const Group* last = nullptr;
  for (const TaskGroup& of : groups) {
    const Group& group = *of.group;
    bool is_along = last && benignOf(experiment, group) && last->at.size() == 1 && last->at[0].axis == group.at[0].axis;
    bool is_same = last && last->shot == group.shot && (is_along || experiment.is_step);
    auto [base, is_new] = bases.try_emplace(group.shot);
    if (is_new) base->second = baseOf(experiment, groups, store, group.shot);
    if (!is_same) turns.push_back({base->second, {}});
    TimedTurn& turn = turns.back();
    for (const Task& task : of.tasks)
      if (turn.base && of.is_mine && lacksTimes(experiment, task, *turn.base, store)) turn.tasks.push_back(&task);
    last = &group;
  }
  std::erase_if(turns, [](const TimedTurn& turn) { return turn.tasks.empty(); });
  return turns;
}

// Times all tasks in turn, with the base among them, so that other load of the machine affects all tasks alike.
void timeInTurn(const Experiment& experiment, lab::Batch& batch, const Store& store, const TimedTurn& turn) {
  std::vector<lab::Shot> shots = {turn.base->shot};
  for (const Task* task : turn.tasks) shots.push_back(task->shot);
  std::vector<lab::Timing> timings = batch.timeInTurn(shots, experiment.rounds);
  auto times = [&](size_t i) { return Times{timings[i], ownMs(batch, shots[i], timings[i])}; };
  // A task with the key of the base gets the times of the base: directly after the base, its own times would be of a
  // warm device.
  for (size_t i = 0; i < turn.tasks.size(); ++i) {
    const Task& task = *turn.tasks[i];
    keepTimes(store, task, timesOf(experiment, task, *turn.base), times(task.key == turn.base->key ? 0 : i + 1),
              times(0));
  }
}

// Marks points as failed, with the reason, if their times cannot be measured. The values of their pictures stay.
void failTimes(const Store& store, const TimedTurn& turn, const std::string& reason) {
  for (const Task* task : turn.tasks) {
    std::optional<Point> point = store.point(task->key);
    if (!point) continue;  // damaged in the meantime
    std::erase_if(point->values, [](const auto& value) { return measureNamed(value.first).isTime(); });
    point->failed = "times: " + reason, point->times.clear(), point->passes.clear();
    store.keep(task->key, *point);
  }
  warn(fmt::format("times of {} points failed: {}", turn.tasks.size(), reason));
}

void timeTurns(const Experiment& experiment, lab::Batch& batch, const Store& store, const std::vector<TimedTurn>& turns,
               Worker& worker, ProgressWatch& watch) {
  size_t count = 0;
  for (const TimedTurn& turn : turns) count += turn.tasks.size();
  watch.begin("times", int(count));
  worker.begin("times");
  for (const TimedTurn& turn : turns) {
    stopIfRequested();
    const std::string failed = failureOf([&] { timeInTurn(experiment, batch, store, turn); });
    if (!failed.empty()) failTimes(store, turn, failed);
    watch.advance(int(turn.tasks.size()));
  }
  watch.end();
}

// One program at a time measures times, except that each share measures the times of its points.
void timeHere(const Experiment& experiment, lab::Batch& batch, const Store& store, const std::vector<TaskGroup>& groups,
              Worker& worker, ProgressWatch& watch) {
  constexpr double kPoll_s = 1;
  auto turns = [&] { return remainingTurns(experiment, groups, store); };
  if (turns().empty()) return;
  std::unique_ptr<Lease> claim;
  while (experiment.share.isWhole() && !(claim = store.claim("times"))) waitFor(kPoll_s);
  if (const std::vector<TimedTurn> left = turns(); !left.empty())
    timeTurns(experiment, batch, store, left, worker, watch);
}

// Packs the complete points of this program and of earlier runs.
void packHere(const Store& store, const std::vector<TaskGroup>& groups) {
  std::vector<std::string> complete;
  for (const TaskGroup& group : groups)
    for (const Task& task : group.tasks)
      if (group.is_mine && !task.key.empty() && store.has(task.key)) complete.push_back(task.key);
  store.packAll(complete);
}

// ---- results

PointGroup pointsOf(const Experiment& experiment, const TaskGroup& group, std::string anchor) {
  PointGroup result{group.studied->name, std::move(anchor), {}, {}};
  for (const At& at : group.group->at)
    result.at.emplace_back(experiment.axes[at.axis].name, experiment.axes[at.axis].values[at.value]);
  for (const Task& task : group.tasks) {
    Point point;
    point.key = task.key, point.failed = task.refused;
    point.arm = task.arm->name, point.role = task.arm->role;
    point.command = commandOf(*group.studied, task.shot);
    result.points.push_back(std::move(point));
  }
  return result;
}

// Results before a picture is drawn: every point with its key, or the reason why the point cannot be drawn. With
// `takePoints`, the current results at any time.
Results outlineOf(const Experiment& experiment, const std::vector<TaskGroup>& groups, lab::Batch& batch) {
  Results results = study::outlineOf(experiment);
  const gpu::DeviceInfo& device = batch.bench().device().info();
  results.device = device.name, results.driver = device.driver, results.software = device.software;
  for (const TaskGroup& group : groups) {
    std::string anchor;
    if (group.truth().refused.empty()) {
      lab::Shot shot = batch.filled(group.truth().shot);
      ShotSummary& summary = results.shots[group.group->shot];
      if (summary.fps == 0) summary.fps = shot.fps, summary.exposure = shot.exposure;
      anchor = shot.anchor;
    }
    results.groups.push_back(pointsOf(experiment, group, anchor));
  }
  for (const Path& file : batch.inputs()) addInput(results.inputs, batch.bench().home(), file);
  return results;
}

Results withPoints(Results results, const Store& store) {
  takePoints(results, store.folder());
  return results;
}

// Hash of the program and of the inputs of results.
std::string versionOf(const Results& results) { return hashText(lab::programHash() + Json(results.inputs).dump()); }

WorkerState stateOf(const Experiment& experiment, const Results& outline) {
  WorkerState state;
  state.device = outline.device, state.share = experiment.share.text(), state.version = versionOf(outline);
  return state;
}

// Keeps the groups of this program's share.
void keepShare(Results& results, const std::vector<TaskGroup>& groups) {
  std::vector<PointGroup> mine;
  for (size_t i = 0; i < groups.size(); ++i)
    if (groups[i].is_mine) mine.push_back(std::move(results.groups[i]));
  results.groups = std::move(mine);
}

}  // namespace

Results run(const Experiment& experiment, lab::Batch& batch, const Store& store,
            const std::function<void()>& on_drawn) {
  const bool is_quiet = experiment.is_step;
  for (const StudiedShot& shot : experiment.shots)
    if (!shot.missing.empty()) note(fmt::format("{}: skipped, {}", shot.title, shot.missing));
  std::vector<TaskGroup> groups = tasksOf(experiment, batch);
  Results results = outlineOf(experiment, groups, batch);
  Worker worker(store.folder(), stateOf(experiment, results));
  if (!is_quiet) store.agreeOn(results.inputs, versionOf(results));
  store.keepOutline(results);
  ProgressWatch watch;
  if (!experiment.share.isWhole()) keepShare(results, groups);
  if (!is_quiet) {
    announce(withPoints(results, store));
    watch.now = [&] { return withPoints(results, store); };
  }
  renderHere(experiment, batch, store, groups, worker, watch);
  if (on_drawn) on_drawn();
  timeHere(experiment, batch, store, groups, worker, watch);
  packHere(store, groups);
  takePoints(results, store.folder());
  if (experiment.expectations && experiment.share.isWhole())
    judgeResults(batch.bench().home(), results, experiment.file);
  return results;
}

// ---- several processes

// Draws the missing points in a process of its own, without reports.
[[noreturn]] static void help(const Experiment& experiment, const MakeBench& make, const Store& store) {
  int code = 0;
  try {
    std::unique_ptr<lab::Workbench> bench = make();
    lab::Batch batch(*bench);
    std::vector<TaskGroup> groups = tasksOf(experiment, batch);
    Worker worker(store.folder(), stateOf(experiment, outlineOf(experiment, groups, batch)));
    ProgressWatch watch;
    renderHere(experiment, batch, store, groups, worker, watch);
    bench->device().refuseMessages();
  } catch (const Stopped&) {
    code = kTryAgain;
  } catch (const std::exception& error) {
    warn(error.what());
    code = 1;
  }
  ::_exit(code);
}

Helpers::Helpers(const Experiment& experiment, const MakeBench& make, const Store& store, int count) {
  for (int i = 0; i < count; ++i) {
    pid_t child = ::fork();
    if (child == 0) {
      ::prctl(PR_SET_PDEATHSIG, SIGKILL);
      help(experiment, make, store);
    }
    if (child > 0) processes_.push_back(child);
    else warn(fmt::format("process {} of {} cannot be started: {}", i + 2, count + 1, std::strerror(errno)));
  }
}

// SIGUSR1 does not end a process at once that has the signal of the terminal already.
Helpers::~Helpers() {
  for (pid_t process : processes_) ::kill(process, SIGUSR1);
  wait();
}

bool Helpers::wait() {
  bool good = true;
  for (pid_t process : processes_) {
    int status = 0;
    while (::waitpid(process, &status, 0) < 0 && errno == EINTR) continue;
    if (WIFSIGNALED(status))
      warn(fmt::format("process {} of the sweep was ended by signal {} ({}); the others drew its points", process,
                       WTERMSIG(status), ::strsignal(WTERMSIG(status))));
    else good = good && (status == 0 || WEXITSTATUS(status) == kTryAgain);
  }
  processes_.clear();
  return good;
}

}  // namespace strobe::study
