// SPDX-License-Identifier: MIT
#include "live/moments.h"

#include <algorithm>
#include <set>

#include "lab/shot_options.h"

namespace strobe::live {

std::map<std::string, plan::Value> settingsOf(const lab::Shot& shot) {
  std::map<std::string, plan::Value> last;
  for (const auto& [name, value] : shot.sets) last[name] = value;
  return last;
}

namespace {

// Names of options and settings that differ between two shots.
std::set<std::string> differences(const lab::Shot& one, const lab::Shot& other) {
  std::set<std::string> names;
  for (const lab::ShotOption& option : lab::shotOptions())
    if (!option.is(lab::ShotOption::kNoPicture) && lab::jsonOf(option, one) != lab::jsonOf(option, other))
      names.insert(option.name);
  if (one.pipeline != other.pipeline) names.insert("pipeline");
  auto values = settingsOf(one), others = settingsOf(other);
  for (const auto* side : {&values, &others})
    for (const auto& [name, value] : *side) {
      auto a = values.find(name), b = others.find(name);
      if (a == values.end() || b == others.end() || a->second != b->second) names.insert(name);
    }
  return names;
}

std::vector<std::string> differences(const Moment& before, const Moment& now) {
  std::set<std::string> names;
  if (before.shots.size() != now.shots.size()) names.insert("comparison");
  for (size_t i = 0; i < std::min(before.shots.size(), now.shots.size()); ++i)
    names.merge(differences(before.shots[i], now.shots[i]));
  if (before.images != now.images) names.insert("image");
  if (before.files != now.files) names.insert("files");
  return {names.begin(), names.end()};
}

bool isOnly(const Moment& moment, const char* what) { return moment.changed == std::vector<std::string>{what}; }

int frameOf(const Moment& moment) { return moment.shots.front().frame; }

}  // namespace

void Moments::add(Moment now) {
  now.first_frame = frameOf(now);
  if (all_.empty()) return all_.push_back(std::move(now));
  Moment& last = all_.back();
  now.changed = differences(last, now);
  if (now.changed.empty()) {
    last.goes_on = last.goes_on && now.goes_on;
    return;
  }
  if (isOnly(now, "frame") && !last.saved) {
    // Extend a played sequence by its next frame; ignore a replay.
    bool next = frameOf(now) == frameOf(last) + 1;
    if (now.goes_on && frameOf(now) >= last.first_frame && frameOf(now) < frameOf(last)) return;
    if (next && (last.changed.empty() || isOnly(last, "frame") || last.first_frame < frameOf(last))) {
      last.shots = std::move(now.shots);
      return;
    }
  }
  bool drags = now.goes_on && last.goes_on && last.first_frame == frameOf(last);
  bool flies = isOnly(now, "view") || isOnly(now, "image");
  if (!last.saved && all_.size() > 1 && now.changed == last.changed && (drags || flies)) {
    now.changed = differences(all_[all_.size() - 2], now);
    if (now.changed.empty()) return all_.pop_back();
    last = std::move(now);
    return;
  }
  all_.push_back(std::move(now));
}

void Moments::markSaved() {
  if (!all_.empty()) all_.back().saved = true;
}

}  // namespace strobe::live
