// SPDX-License-Identifier: MIT
#include "lab/warnings.h"

#include <algorithm>
#include <map>

#include "image/regions.h"
#include "lab/limits.h"
#include "plan/named.h"
#include "scene/clips.h"
#include "scene/motion.h"

namespace strobe::lab {

static uint64_t countOf(const graph::FrameResult& frame, const std::string& name) {
  const uint64_t* count = plan::valueIn(frame.counters, name);
  return count ? *count : 0;
}

std::vector<LimitMet> limitsMet(const plan::Plan& plan, const graph::FrameResult& frame) {
  std::vector<LimitMet> met;
  for (const auto& planned : plan.nodes) {
    const std::string& node = plan.descOf(planned).name;
    for (const auto& counter : plan.passOf(planned).counters) {
      uint64_t count = countOf(frame, node + "." + counter.name);
      if (count == 0 || counter.limit.empty()) continue;
      met.push_back({fmt::format("{}: {} {}", node, count, counter.doc), counter.limit});
    }
  }
  return met;
}

std::vector<LimitMet> limitsMet(const graph::FrameResult& frame) {
  auto color = frame.outputs.find("color");
  if (color == frame.outputs.end()) return {};
  const image::Image& image = color->second.floats;
  const image::NotFinite found = image::notFiniteIn(image);
  if (found.pixels == 0) return {};
  return {kNotFiniteLimit.metBy(fmt::format("color: {} of {} pixels {} not finite, the first at {},{} ({})",
                                            found.pixels, image.width * image.height, found.pixels == 1 ? "is" : "are",
                                            found.x, found.y, found.value))};
}

// Limits of clips that do not play because an earlier clip drives the same target.
static std::vector<LimitMet> sharedTargets(const scene::Scene& scene) {
  constexpr size_t kMostNames = 12;
  std::map<std::pair<int, std::string>, std::vector<std::string>> yielding;  // names, by playing clip and target
  for (const scene::Animation& clip : scene.animations)
    if (clip.yields_to >= 0) yielding[{clip.yields_to, clip.shared_target}].push_back(clip.name);
  std::vector<LimitMet> met;
  for (auto& [shared, names] : yielding) {
    names.insert(names.begin(), scene.animations[size_t(shared.first)].name);
    const size_t more = names.size() - std::min(names.size(), kMostNames);
    names.resize(names.size() - more);
    met.push_back(kSharedTargetLimit.metBy(fmt::format("clips '{}'{} drive {}", fmt::join(names, "', '"),
                                                       more ? fmt::format(" and {} more", more) : "", shared.second)));
  }
  return met;
}

// True if a cut of the scene, the clip or the shot lies in the exposure. The scene or the clip is then static during
// the exposure.
static bool isCut(const Shot& shot, const scene::Scene& scene, const scene::Animation& clip, double open_s,
                  double close_s) {
  return scene::comesToACut(scene.cuts, open_s, close_s) || scene::comesToACut(clip, open_s, close_s) ||
         scene::comesToACut(scene::cutsFromOption(shot.cuts), open_s, close_s);
}

// Time of the first key without STEP interpolation, seconds; the end of the clip without such a key.
static double firstKey(const scene::Animation& clip) {
  double first_s = clip.duration;
  for (const scene::Track& track : clip.tracks)
    if (track.interpolation != scene::Track::Interpolation::Step) first_s = std::min(first_s, track.times.front());
  return first_s;
}

static bool jumpsAtTheEnd(const scene::Animation& clip) {
  return std::any_of(clip.tracks.begin(), clip.tracks.end(),
                     [&](const scene::Track& track) { return scene::jumpsAtTheEnd(clip, track); });
}

std::vector<LimitMet> limitsMet(const Shot& shot, const scene::Scene& scene) {
  std::vector<LimitMet> met;
  if (shot.animation == "all") met = sharedTargets(scene);
  auto [open_s, close_s] = shot.window();
  if (!(close_s > open_s)) return met;
  const std::string times = fmt::format("the exposure from {:.6g} s to {:.6g} s", open_s, close_s);
  for (const scene::Animation* clip : scene::clipsOf(scene, shot.animation)) {
    if (isCut(shot, scene, *clip, open_s, close_s)) continue;
    const double first_s = firstKey(*clip);
    if (first_s < clip->duration && scene::isBefore(open_s, first_s) && scene::isBefore(first_s, close_s))
      met.push_back(kBeforeClipLimit.metBy(
          fmt::format("{} begins before the first key of '{}' at {:.6g} s", times, clip->name, first_s)));
    if (scene::beginsAgain(*clip, open_s, close_s) && jumpsAtTheEnd(*clip))
      met.push_back(
          kClipSeamLimit.metBy(fmt::format("{} spans the end of '{}' at {:.6g} s", times, clip->name, clip->duration)));
  }
  return met;
}

}  // namespace strobe::lab
