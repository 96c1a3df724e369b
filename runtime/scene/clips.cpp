// SPDX-License-Identifier: MIT
#include "scene/clips.h"

#include <algorithm>
#include <array>
#include <map>

#include "scene/motion.h"

namespace strobe::scene {

bool jumpsAtTheEnd(const Animation& clip, const Track& track) {
  if (track.interpolation == Track::Interpolation::Step) return false;
  const dvec4 first = valueAt(track, 0), last = valueAt(track, clip.duration);
  double largest = 0;
  for (double time_s : track.times) largest = std::max(largest, glm::length(valueAt(track, time_s)));
  double distance = glm::length(last - first);
  if (track.target == Track::Target::Rotation) distance = std::min(distance, glm::length(last + first));
  return distance > 1e-6 * largest;
}

namespace {

// A target as a key of maps, and a target with its name.
using TargetKey = std::array<int, 3>;
using NamedTarget = std::pair<TargetKey, std::string>;

NamedTarget targetOf(const Scene& scene, const Track& track) {
  static const char* const kNames[] = {"translation", "rotation", "scale",     "weight", "field of view", "half height",
                                       "near plane",  "colour",   "intensity", "range",  "inner cone",    "outer cone"};
  const size_t object = size_t(track.object);
  std::string name = kNames[int(track.target)];
  if (track.target == Track::Target::Weight) name += fmt::format(" {}", track.weight);
  name += track.isOfNode()     ? fmt::format(" of node '{}'", scene.nodes[object].name)
          : track.isOfCamera() ? fmt::format(" of camera '{}'", scene.cameras[object].name)
                               : fmt::format(" of light '{}'", scene.lights[object].name);
  return {{int(track.target), track.object, int(track.weight)}, name};
}

std::vector<NamedTarget> targetsOf(const Scene& scene, const Animation& clip) {
  std::vector<NamedTarget> targets;
  for (const Track& track : clip.tracks) targets.push_back(targetOf(scene, track));
  return targets;
}

}  // namespace

void yieldClips(Scene& scene) {
  std::map<TargetKey, int> driven;  // index of the clip that plays and drives the target
  for (size_t i = 0; i < scene.animations.size(); ++i) {
    Animation& clip = scene.animations[i];
    const std::vector<NamedTarget> targets = targetsOf(scene, clip);
    auto shared = std::find_if(targets.begin(), targets.end(),
                               [&](const NamedTarget& one) { return driven.contains(one.first); });
    clip.yields_to = shared == targets.end() ? -1 : driven.at(shared->first);
    clip.shared_target = shared == targets.end() ? "" : shared->second;
    if (clip.yields_to < 0)
      for (const NamedTarget& target : targets) driven[target.first] = int(i);
  }
}

int loopFrames(const Scene& scene, double fps) {
  double seconds = scene.loop_s;
  if (seconds == 0)
    for (const Animation& clip : scene.animations) seconds = std::max(seconds, clip.duration);
  if (seconds == 0) seconds = 2;
  return std::max(1, int(seconds * fps * (1 + kTimeRounding)));
}

}  // namespace strobe::scene
