// SPDX-License-Identifier: MIT
#include "stability/shrink.h"

#include <algorithm>

#include "plan/named.h"

namespace strobe::stability {

// Values to try for a setting, simplest first; "" removes the setting.
using Simple = std::vector<std::pair<std::string, std::vector<std::string>>>;

static Simple simpleValues(const plan::PipelineDesc& pipeline) {
  Simple simple = {{"scene.cards", {"0", "1", "2", "3", "4"}},
                   {"scene.boxes", {"", "1"}},
                   {"scene.balls", {""}},
                   {"scene.lit", {"0"}},
                   {"scene.textured", {"0"}},
                   {"scene.perspective", {"0"}},
                   {"scene.wall", {"", "0"}},
                   {"scene.reach", {"3", "4", "6", "8"}}};
  auto add = [&](plan::Role role, const std::vector<std::string>& values) {
    if (const plan::ParamDesc* param = plan::paramOf(pipeline, role)) simple.emplace_back(param->name, values);
  };
  add(plan::Role::SampleCount, {"1", "2", "3", "4", "8"});
  add(plan::Role::Tile, {"1", "2", "4", "8"});
  return simple;
}

static lab::Shot without(lab::Shot shot, const std::string& name) {
  std::erase_if(shot.sets, [&](const auto& set) { return set.first == name; });
  return shot;
}

// All shots that are one step simpler, most helpful first.
static std::vector<lab::Shot> simpler(const lab::Shot& shot, const plan::PipelineDesc& pipeline,
                                      const script::Settings& kept) {
  std::vector<lab::Shot> list;
  if (shot.anchor != "end") list.push_back(shot), list.back().anchor = "end";
  for (const auto& [name, value] : shot.sets) {
    bool drawn = !name.starts_with("scene.") && !plan::valueIn(kept, name);
    const plan::ParamDesc* param = plan::paramNamed(pipeline, name);
    if (drawn && !(param && isChosen(param->role))) list.push_back(without(shot, name));
  }
  for (const auto& [name, values] : simpleValues(pipeline)) {
    bool of_scene = name.starts_with("scene.");
    if (plan::valueIn(kept, name) || (!of_scene && !plan::valueIn(shot.sets, name))) continue;
    for (const std::string& value : values) {
      lab::Shot one = value.empty() ? without(shot, name) : with(shot, name, plan::valueFromText(value));
      if (one.sets == shot.sets) break;  // later values are less simple than the current one
      list.push_back(one);
    }
  }
  for (int size : {16, 24, 32, 48})
    if (size < std::max(shot.width, shot.height)) list.push_back(sized(shot, size, size));
  return list;
}

lab::Shot shrunk(lab::Shot shot, const plan::PipelineDesc& pipeline, const script::Settings& kept,
                 const StillFails& still_fails, int tries) {
  auto fails = [&](const lab::Shot& candidate) {
    try {
      return still_fails(candidate);
    } catch (const Error&) {
      return false;
    }
  };
  for (bool progress = true; progress;) {
    progress = false;
    for (const lab::Shot& candidate : simpler(shot, pipeline, kept)) {
      if (tries-- <= 0) return shot;
      if (!fails(candidate)) continue;
      shot = candidate;
      progress = true;
      break;
    }
  }
  return shot;
}

}  // namespace strobe::stability
