// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <set>

#include "scene/gltf_parts.h"
#include "scene/gltf_pointer.h"
#include "scene/motion.h"

namespace strobe::scene {

namespace {

class AnimationReader {
 public:
  AnimationReader(const GltfFile& file, Scene& scene) : file_(file), scene_(scene) {}

  void readAnimations() {
    const Json& animations = file_.all("animations");
    const std::vector<std::string> names = file_.uniqueNames(animations, "animation", {"all", "none"});
    for (size_t i = 0; i < animations.size(); ++i) {
      Animation animation;
      animation.name = names[i];
      const Json& channels = file_.list(animations[i], "channels", "");
      driven_.clear();
      for (size_t k = 0; k < channels.size(); ++k)
        readChannel(animations[i], channels[k], fmt::format("animations[{}].channels[{}]", i, k), animation);
      animation.cuts = readCuts(animations[i], fmt::format("animations[{}]", i), animation.duration);
      scene_.animations.push_back(std::move(animation));
    }
  }

 private:
  void warn(const std::string& text) { scene_.warnings.push_back(text); }

  std::vector<double> readCuts(const Json& json, const std::string& where, double duration_s) {
    std::vector<double> cuts = cutsOf(file_, json, where);
    for (double cut : cuts)
      if (cut < 0 || cut > duration_s)
        file_.refuse(
            where + ".extras",
            fmt::format("'cuts' has {}, which is not in the range from 0 to the clip's end at {} s", cut, duration_s));
    return cuts;
  }

  void readChannel(const Json& json, const Json& channel, const std::string& where, Animation& animation) {
    std::optional<PointerTarget> target = targetOf(channel, where);
    if (!target) return;
    const Json& sampler = json["samplers"][file_.size(channel, "sampler", std::nullopt, where)];
    if (target->target == Track::Target::Weight) return readWeights(sampler, where, *target, animation);
    Track track;
    track.object = target->object;
    track.target = target->target;
    readKeys(sampler, where, track);
    readValues(sampler, where, target->components, track);
    animation.duration = std::max(animation.duration, track.times.back());
    if (track.isOfTransform()) splitMatrix(scene_.nodes[track.object]);
    animation.tracks.push_back(std::move(track));
  }

  // Target of a channel; nothing, with a warning, for a target that cannot be animated.
  std::optional<PointerTarget> targetOf(const Json& channel, const std::string& where) {
    const Json& target = file_.object(channel, "target", where);
    std::string path = file_.text(target, "path", where);
    if (path == "pointer") return pointed(target, where);
    PointerTarget result;
    result.object = file_.index(target, "node", "nodes", where);
    if (result.object < 0) return warn(where + ": has no target node and is left out"), std::nullopt;
    if (path == "weights") return once(weightsOf(file_, {result.object}, where), pointerTo(result.object, path), where);
    if (path == "rotation") result.target = Track::Target::Rotation, result.components = 4;
    else if (path == "scale") result.target = Track::Target::Scale;
    else if (path != "translation")
      return warn(fmt::format("{}: path '{}' is not supported; the channel is left out", where, path)), std::nullopt;
    return once(result, pointerTo(result.object, path), where);
  }

  std::optional<PointerTarget> pointed(const Json& target, const std::string& where) {
    std::string pointer = file_.text(file_.extension(target, "KHR_animation_pointer"), "pointer");
    if (pointer.empty()) file_.refuse(where, "its path is 'pointer', but KHR_animation_pointer has no pointer");
    if (target.contains("node")) file_.refuse(where, "has both a pointer and a node");
    std::optional<PointerTarget> result = pointerTarget(file_, pointer, where);
    if (!result)
      return warn(fmt::format("{}: '{}' cannot be animated; the channel is left out", where, pointer)), std::nullopt;
    return once(*result, pointer, where);
  }

  static std::string pointerTo(int node, const std::string& path) { return fmt::format("/nodes/{}/{}", node, path); }

  // Returns the target. Refuses a target that another channel of the animation drives.
  std::optional<PointerTarget> once(const PointerTarget& target, const std::string& pointer, const std::string& where) {
    if (!driven_.insert(pointer).second)
      file_.refuse(where, fmt::format("drives {}, which another channel drives too", pointer));
    return target;
  }

  void readKeys(const Json& sampler, const std::string& where, Track& track) {
    int input = file_.index(sampler, "input", "accessors", where);
    std::string how = file_.text(sampler, "interpolation", where);
    if (how == "STEP") track.interpolation = Track::Interpolation::Step;
    else if (how == "CUBICSPLINE") track.interpolation = Track::Interpolation::CubicSpline;

    track.times = file_.accessor(input, where, {"SCALAR"}).numbers;
    for (size_t i = 0; i < track.times.size(); ++i) {
      bool sound = std::isfinite(track.times[i]) && (i == 0 || track.times[i] > track.times[i - 1]);
      if (!sound) file_.refuse(where, fmt::format("its key times do not increase at key {}", i));
    }
  }

  // Output values of the sampler: `each` per key, and three times as many for cubic splines.
  Values outputOf(const Json& sampler, const std::string& where, const std::string& type, size_t each,
                  const Track& track) {
    Values values = file_.accessor(file_.index(sampler, "output", "accessors", where), where, {type});
    size_t wanted = each * track.times.size() * (track.interpolation == Track::Interpolation::CubicSpline ? 3 : 1);
    if (values.count != wanted)
      file_.refuse(where, fmt::format("{} keys need {} values, not {}", track.times.size(), wanted, values.count));
    for (size_t i = 0; i < values.numbers.size(); ++i)
      if (!std::isfinite(values.numbers[i]))
        file_.refuse(where, fmt::format("its value {} is not finite", i / size_t(values.width)));
    return values;
  }

  void readValues(const Json& sampler, const std::string& where, int components, Track& track) {
    const std::string type = components == 1 ? "SCALAR" : fmt::format("VEC{}", components);
    const Values values = outputOf(sampler, where, type, 1, track);
    for (size_t i = 0; i < values.count; ++i) {
      dvec4 value(0);
      for (int c = 0; c < components; ++c) value[c] = values.at(i, c);
      track.values.push_back(value);
    }
  }

  // Adds a track for each weight. A key stores the values (or the tangents) of all weights in order.
  void readWeights(const Json& sampler, const std::string& where, const PointerTarget& target, Animation& animation) {
    Track keys;
    keys.target = Track::Target::Weight;
    readKeys(sampler, where, keys);
    const size_t count = size_t(target.components);
    const Values values = outputOf(sampler, where, "SCALAR", count, keys);
    animation.duration = std::max(animation.duration, keys.times.back());
    for (size_t w = 0; w < count; ++w) {
      keys.values.clear();
      for (size_t i = w; i < values.count; i += count) keys.values.push_back(dvec4(values.numbers[i], 0, 0, 0));
      keys.weight = target.first_weight + w;
      for (int node : target.morphed) {
        keys.object = node;
        animation.tracks.push_back(keys);
      }
    }
  }

  const GltfFile& file_;
  Scene& scene_;
  std::set<std::string> driven_;  // targets of the current animation, as pointers
};

}  // namespace

void readAnimations(const GltfFile& file, Scene& scene) { AnimationReader(file, scene).readAnimations(); }

}  // namespace strobe::scene
