// SPDX-License-Identifier: MIT
#include "bench/comparison.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "base/error.h"

namespace strobe::bench {

namespace {

// Milliseconds by round of a part of a shot, or of its frame if `name` is ""; null if the shot lacks the part.
const std::vector<double>* msOf(const ShotTimes& shot, const std::vector<PassTimes>& parts, const std::string& name) {
  if (name.empty()) return &shot.ms;
  auto found = std::find_if(parts.begin(), parts.end(), [&](const PassTimes& part) { return part.name == name; });
  return found == parts.end() ? nullptr : &found->ms;
}

// 1: slower, -1: faster, 0: within `share` of 1, or the interval contains 1.
int directionOf(const Estimate& ratio, double share) {
  if (std::abs(ratio.value - 1) <= share) return 0;
  return ratio.low > 1 ? 1 : ratio.high < 1 ? -1 : 0;
}

// A shot of a run, with its parts.
struct Side {
  const ShotTimes* shot;
  std::vector<PassTimes> parts;
};

Side sideOf(const Run& run, size_t shot) { return {&run.shots[shot], run.shots[shot].parts()}; }

// Names of the parts in both runs, the frame first. Adds the other parts to the lists of the comparison.
std::vector<std::string> namesOf(const Side& now, const Side& before, Comparison& comparison) {
  std::vector<std::string> names = {""};
  auto lists = [](const Side& side, const std::string& name) { return msOf(*side.shot, side.parts, name) != nullptr; };
  for (const PassTimes& part : now.parts)
    if (lists(before, part.name)) names.push_back(part.name);
    else comparison.added.push_back(part.name + " of " + now.shot->name());
  for (const PassTimes& part : before.parts)
    if (!lists(now, part.name)) comparison.gone.push_back(part.name + " of " + now.shot->name());
  return names;
}

// Times of a part of a shot in both runs: medians, ratios in the basis of the comparison, ratios of milliseconds.
struct Times {
  double now_ms = 0, before_ms = 0;
  Estimate compared, ms;
};
using TimesOf = std::function<Times(size_t shot, const std::string& part)>;

void addChanges(Comparison& comparison, const Run& now, const Run& before, const TimesOf& times_of) {
  for (size_t s = 0; s < now.shots.size(); ++s) {
    const Side present = sideOf(now, s), earlier = sideOf(before, s);
    for (const std::string& name : namesOf(present, earlier, comparison)) {
      Change change{present.shot, name};
      change.is_base = name.empty() && &now.baseOf(*present.shot) == present.shot;
      const Times times = times_of(s, name);
      change.now_ms = times.now_ms, change.before_ms = times.before_ms;
      change.ratio = times.compared, change.ms_ratio = times.ms;
      int direction = directionOf(times.compared, comparison.share);
      bool can_tell = comparison.kind != Comparison::Kind::base || !change.is_base;
      change.moved = can_tell && direction != 0 && direction == directionOf(times.ms, comparison.share);
      comparison.changes.push_back(std::move(change));
    }
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

Times timesOfRuns(const Run& now, const Run& before, size_t shot, const std::string& part, bool to_base) {
  const Side present = sideOf(now, shot), earlier = sideOf(before, shot);
  const std::vector<double>& now_ms = *msOf(*present.shot, present.parts, part);
  const std::vector<double>& before_ms = *msOf(*earlier.shot, earlier.parts, part);
  const ShotTimes &now_base = now.baseOf(*present.shot), &before_base = before.baseOf(*earlier.shot);
  Times times{median(now_ms), median(before_ms)};
  times.compared = times.ms = ratioOfMedians(now_ms, before_ms);
  bool is_base = part.empty() && &now_base == present.shot;
  if (to_base && !is_base)
    times.compared = ratioOfMedians(ratiosOf(now_ms, now_base.ms), ratiosOf(before_ms, before_base.ms));
  return times;
}

// Ratio of the median of each block to the median of its pair.
Times timesOfBlocks(const std::vector<Run>& now, const std::vector<Run>& before, size_t shot, const std::string& part) {
  auto medians = [&](const std::vector<Run>& blocks) {
    std::vector<double> ms;
    for (const Run& block : blocks) {
      const Side side = sideOf(block, shot);
      ms.push_back(median(*msOf(*side.shot, side.parts, part)));
    }
    return ms;
  };
  const std::vector<double> now_ms = medians(now), before_ms = medians(before);
  const Estimate ratio = estimatedMedian(ratiosOf(now_ms, before_ms));
  return {median(now_ms), median(before_ms), ratio, ratio};
}

}  // namespace

size_t Comparison::moved() const {
  return size_t(std::count_if(changes.begin(), changes.end(), [](const Change& change) { return change.moved; }));
}

Comparison compared(const Run& now, const Run& before, double share) {
  Comparison comparison;
  comparison.share = share;
  comparison.differ = differencesOf(now, before);
  bool same_device = now.device == before.device && now.driver == before.driver && !now.software;
  comparison.kind = same_device ? Comparison::Kind::milliseconds : Comparison::Kind::base;
  addChanges(comparison, now, before,
             [&](size_t shot, const std::string& part) { return timesOfRuns(now, before, shot, part, !same_device); });
  return comparison;
}

Comparison compared(const std::vector<Run>& now, const std::vector<Run>& before, double share) {
  STROBE_ASSERT(!now.empty() && now.size() == before.size(), "{} and {}", now.size(), before.size());
  Comparison comparison;
  comparison.share = share;
  comparison.kind = Comparison::Kind::blocks;
  comparison.blocks = now.size();
  comparison.differ = differencesOf(now.front(), before.front());
  addChanges(comparison, now.front(), before.front(),
             [&](size_t shot, const std::string& part) { return timesOfBlocks(now, before, shot, part); });
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

Json toJson(const Comparison& comparison) {
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
