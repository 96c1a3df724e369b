// SPDX-License-Identifier: MIT
#include "stability/cases.h"

#include <algorithm>
#include <cmath>

#include "base/hash.h"

namespace strobe::stability {

Random::Random(uint64_t seed, const std::string& text) : state_(seed) {
  for (char c : text) state_ = (state_ ^ uint64_t(uint8_t(c))) * 0x100000001B3ull;
  bits();
}

// splitmix64.
uint64_t Random::bits() {
  uint64_t z = (state_ += 0x9E3779B97F4A7C15ull);
  z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9ull;
  z = (z ^ (z >> 27)) * 0x94D049BB133111EBull;
  return z ^ (z >> 31);
}

lab::Shot with(lab::Shot shot, const std::string& name, const plan::Value& value) {
  for (auto& [set, held] : shot.sets)
    if (set == name) {
      held = value;
      return shot;
    }
  shot.sets.push_back({name, value});
  return shot;
}

lab::Shot with(lab::Shot shot, const std::string& name, double value) {
  bool whole = value == std::floor(value) && std::abs(value) < 1e15;
  return with(std::move(shot), name, whole ? plan::Value(int64_t(value)) : plan::Value(value));
}

lab::Shot with(lab::Shot shot, const plan::PipelineDesc& pipeline, plan::Role role, double value) {
  const plan::ParamDesc* param = plan::paramOf(pipeline, role);
  return param ? with(std::move(shot), param->name, value) : shot;
}

double knob(const lab::Shot& shot, const std::string& name, double otherwise) {
  for (const auto& [set, value] : shot.sets)
    if (set == "scene." + name) return std::stod(plan::textOf(value));
  return otherwise;
}

lab::Shot by(lab::Shot shot, const std::string& pipeline) {
  shot.pipeline = pipeline;
  shot.sets = lab::sceneSettings(shot.sets);
  return shot;
}

lab::Shot sized(lab::Shot shot, int width, int height) {
  shot.width = width;
  shot.height = height;
  return with(with(std::move(shot), "scene.width", width), "scene.height", height);
}

// A picture size, and tile sizes that divide both sides.
struct CaseSize {
  int width, height;
  std::vector<int> tiles;
};
static const std::vector<CaseSize> kFrames = {
    {64, 40, {8, 4, 2, 1}}, {48, 48, {16, 12, 6, 48}}, {60, 40, {20, 10, 5}}, {64, 64, {64, 32, 16}}};

// Scene of a case; equal for all variants.
static lab::Shot sceneOf(uint64_t seed, int index) {
  Random random(seed * 1000003 + uint64_t(index), "scene");
  lab::Shot shot;
  shot.scene = kScene;
  shot.fps = 24;
  shot.frame = 0;
  shot.exposure = 0.5;
  const CaseSize& frame = kFrames[size_t(index) % kFrames.size()];
  shot = sized(shot, frame.width, frame.height);
  shot = with(shot, "scene.seed", random.whole(1, 9999));
  shot = with(shot, "scene.cards", random.whole(2, 7));
  shot = with(shot, "scene.reach", random.whole(5, 11));
  if (random.chance(.4)) shot = with(shot, "scene.perspective", 0);
  if (random.chance(.3)) shot = with(shot, "scene.lit", 0);
  if (random.chance(.4)) shot = with(shot, "scene.boxes", random.whole(1, 2));
  if (random.chance(.3)) shot = with(shot, "scene.balls", 1);
  if (random.chance(.3)) shot = with(shot, "scene.wall", 2);
  if (random.chance(.2)) shot = with(shot, "scene.textured", 0);
  return shot;
}

bool isChosen(plan::Role role) {
  return role == plan::Role::SampleCount || role == plan::Role::Tile || role == plan::Role::Reach;
}

// Changes some of the other numbers by a factor from 1/4 to 4.
static lab::Shot withNumbers(lab::Shot shot, const plan::PipelineDesc& pipeline, Random& random) {
  for (const auto& param : pipeline.params) {
    bool number = param.type == plan::ParamDesc::Type::Int || param.type == plan::ParamDesc::Type::Float;
    if (!number || isChosen(param.role) || !random.chance(.25)) continue;
    double value = numberOf(pipeline, param.name, 0) * std::exp2(random.whole(-2, 2));
    value = std::clamp(value, *param.min, *param.max);
    if (param.type == plan::ParamDesc::Type::Int) value = std::round(value);
    shot = with(shot, param.name, value);
  }
  return shot;
}

lab::Shot generated(const Variant& variant, uint64_t seed, int index) {
  lab::Shot shot = sceneOf(seed, index);
  const plan::PipelineDesc& pipeline = *variant.description;
  Random random(seed * 1000003 + uint64_t(index), variant.pipeline + variant.name());
  shot.pipeline = variant.pipeline;
  shot.anchor = std::vector<std::string>{"end", "end", "centre", "start"}[size_t(random.whole(0, 3))];
  script::Settings of_scene = shot.sets;
  shot.sets = variant.sets;
  for (const auto& set : of_scene) shot.sets.push_back(set);

  const CaseSize& frame = kFrames[size_t(index) % kFrames.size()];
  if (const auto* samples = plan::paramOf(pipeline, plan::Role::SampleCount))
    shot = with(shot, samples->name, random.chance(.3) ? random.whole(1, 33) : 16);
  if (const auto* tile = plan::paramOf(pipeline, plan::Role::Tile))
    shot = with(shot, tile->name, frame.tiles[size_t(random.whole(0, int(frame.tiles.size()) - 1))]);
  // In image widths: 12 px, more than any displacement.
  shot = with(shot, pipeline, plan::Role::Reach, 12.0 / frame.width);
  return withNumbers(shot, pipeline, random);
}

}  // namespace strobe::stability
