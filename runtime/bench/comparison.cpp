// SPDX-License-Identifier: MIT
#include "bench/comparison.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "base/error.h"

namespace strobe::bench {

namespace {

// Milliseconds by round of a part of a shot, or of its frame if `part` is "".
std::vector<double> msOf(const Run& run, size_t shot, const std::string& part) {
  const ShotTimes& of = run.shots[shot];
  for (PassTimes& one : of.parts())
    if (one.name == part) return std::move(one.ms);
  STROBE_ASSERT(part.empty(), "{}: {}", of.name(), part);
  return of.ms;
}

// 1: slower, -1: faster, 0: within `share` of 1, or the interval contains 1.
int directionOf(const Estimate& ratio, double share) {
  if (std::abs(ratio.value - 1) <= share) return 0;
  return ratio.low > 1 ? 1 : ratio.high < 1 ? -1 : 0;
}

// Names of the parts in both shots, the frame ("") first. Adds the other parts to the lists of the comparison.
std::vector<std::string> namesOf(const ShotTimes& now, const ShotTimes& before, TimeComparison& comparison) {
  const std::vector<PassTimes> present = now.parts(), earlier = before.parts();
  auto lists = [](const std::vector<PassTimes>& parts, const std::string& name) {
    return std::any_of(parts.begin(), parts.end(), [&](const PassTimes& part) { return part.name == name; });
  };
  std::vector<std::string> names = {""};
  for (const PassTimes& part : present)
    if (lists(earlier, part.name)) names.push_back(part.name);
    else comparison.added.push_back(part.name + " of " + now.name());
  for (const PassTimes& part : earlier)
    if (!lists(present, part.name)) comparison.gone.push_back(part.name + " of " + now.name());
  return names;
}

// Medians and ratios of a part of a shot.
using ChangeOf = std::function<Change(size_t shot, const std::string& part)>;

void addChanges(TimeComparison& comparison, const Run& now, const Run& before, const ChangeOf& change_of) {
  for (size_t s = 0; s < now.shots.size(); ++s)
    for (const std::string& part : namesOf(now.shots[s], before.shots[s], comparison)) {
      Change change = change_of(s, part);
      change.shot = &now.shots[s], change.pass = part;
      change.is_base = part.empty() && &now.baseOf(now.shots[s]) == &now.shots[s];
      int direction = directionOf(change.ratio, comparison.share);
      bool can_tell = comparison.kind != TimeComparison::Kind::base || !change.is_base;
      change.moved = can_tell && direction != 0 && direction == directionOf(change.ms_ratio, comparison.share);
      comparison.changes.push_back(std::move(change));
    }
}

std::string textOf(const std::map<std::string, std::string>& environment) {
  std::vector<std::string> texts;
  for (const auto& [name, value] : environment) texts.push_back(name + "=" + value);
  return texts.empty() ? "nothing" : fmt::format("{}", fmt::join(texts, " "));
}

std::vector<std::string> differencesOf(const Run& now, const Run& before) {
  std::vector<std::string> differ;
  auto compare = [&](const char* what, const std::string& present, const std::string& earlier) {
    if (present != earlier) differ.push_back(fmt::format("{} {}, now {}", what, earlier, present));
  };
  compare("device", now.device, before.device);
  compare("driver", now.driver, before.driver);
  compare("backend", now.backend, before.backend);
  compare("threads", std::to_string(now.threads), std::to_string(before.threads));
  compare("frames in flight", std::to_string(now.frames_in_flight), std::to_string(before.frames_in_flight));
  compare("environment", textOf(now.environment), textOf(before.environment));
  return differ;
}

Change changeOfRuns(const Run& now, const Run& before, size_t shot, const std::string& part, bool to_base) {
  const std::vector<double> now_ms = msOf(now, shot, part), before_ms = msOf(before, shot, part);
  const ShotTimes &now_base = now.baseOf(now.shots[shot]), &before_base = before.baseOf(before.shots[shot]);
  Change change;
  change.now_ms = median(now_ms), change.before_ms = median(before_ms);
  change.ratio = change.ms_ratio = ratioOfMedians(now_ms, before_ms);
  bool is_base = part.empty() && &now_base == &now.shots[shot];
  if (to_base && !is_base)
    change.ratio = ratioOfMedians(ratiosOf(now_ms, now_base.ms), ratiosOf(before_ms, before_base.ms));
  return change;
}

// Ratio of the median of each block to the median of its pair.
Change changeOfBlocks(const std::vector<Run>& now, const std::vector<Run>& before, size_t shot,
                      const std::string& part) {
  auto medians = [&](const std::vector<Run>& blocks) {
    std::vector<double> ms;
    for (const Run& block : blocks) ms.push_back(median(msOf(block, shot, part)));
    return ms;
  };
  const std::vector<double> now_ms = medians(now), before_ms = medians(before);
  Change change;
  change.now_ms = median(now_ms), change.before_ms = median(before_ms);
  change.ratio = change.ms_ratio = estimatedMedian(ratiosOf(now_ms, before_ms));
  return change;
}

}  // namespace

size_t TimeComparison::moved() const {
  return size_t(std::count_if(changes.begin(), changes.end(), [](const Change& change) { return change.moved; }));
}

TimeComparison compared(const Run& now, const Run& before, double share) {
  TimeComparison comparison;
  comparison.share = share;
  comparison.differ = differencesOf(now, before);
  bool same_device = now.device == before.device && now.driver == before.driver && !now.software;
  comparison.kind = same_device ? TimeComparison::Kind::milliseconds : TimeComparison::Kind::base;
  addChanges(comparison, now, before,
             [&](size_t shot, const std::string& part) { return changeOfRuns(now, before, shot, part, !same_device); });
  return comparison;
}

TimeComparison compared(const std::vector<Run>& now, const std::vector<Run>& before, double share) {
  STROBE_ASSERT(!now.empty() && now.size() == before.size(), "{} and {}", now.size(), before.size());
  TimeComparison comparison;
  comparison.share = share;
  comparison.kind = TimeComparison::Kind::blocks;
  comparison.blocks = now.size();
  comparison.differ = differencesOf(now.front(), before.front());
  addChanges(comparison, now.front(), before.front(),
             [&](size_t shot, const std::string& part) { return changeOfBlocks(now, before, shot, part); });
  return comparison;
}

// ---- as JSON

static Json toJson(const Change& change) {
  return {{"scene", change.shot->scene},
          {"width", change.shot->width},
          {"height", change.shot->height},
          {"method", change.shot->method},
          {"pass", change.pass.empty() ? Json() : Json(change.pass)},
          {"before_ms", change.before_ms},
          {"now_ms", change.now_ms},
          {"ratio", change.ratio.value},
          {"low", change.ratio.low},
          {"high", change.ratio.high},
          {"ms_ratio", change.ms_ratio.value},
          {"ms_low", change.ms_ratio.low},
          {"ms_high", change.ms_ratio.high},
          {"moved", change.moved}};
}

Json toJson(const TimeComparison& comparison) {
  static const char* const kKinds[] = {"relative to the base", "milliseconds", "alternating blocks"};
  Json json = {{"against", comparison.against}, {"compared", kKinds[int(comparison.kind)]},
               {"share", comparison.share},     {"blocks", comparison.blocks},
               {"differ", comparison.differ},   {"gone", comparison.gone},
               {"added", comparison.added},     {"moved", comparison.moved()},
               {"changes", Json::array()}};
  for (const Change& change : comparison.changes) json["changes"].push_back(toJson(change));
  return json;
}

}  // namespace strobe::bench
