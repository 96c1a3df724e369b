// SPDX-License-Identifier: MIT
#include "lab/warnings.h"

#include <algorithm>

#include "image/regions.h"
#include "lab/limits.h"
#include "scene/motion.h"

namespace strobe::lab {

static uint64_t countOf(const graph::FrameResult& frame, const std::string& name) {
  auto found =
      std::find_if(frame.counters.begin(), frame.counters.end(), [&](const auto& c) { return c.first == name; });
  return found == frame.counters.end() ? 0 : found->second;
}

std::vector<std::string> limitsMet(const plan::Plan& plan, const graph::FrameResult& frame) {
  std::vector<std::string> met;
  for (const auto& planned : plan.nodes) {
    const std::string& node = plan.pipeline.nodes[size_t(planned.node)].name;
    for (const auto& counter : plan.pipeline.passes[size_t(planned.pass)].counters) {
      uint64_t count = countOf(frame, node + "." + counter.name);
      if (count == 0 || counter.limit.empty()) continue;
      met.push_back(fmt::format("{}: {} {}; {}", node, count, counter.doc, counter.limit));
    }
  }
  return met;
}

std::vector<std::string> limitsMet(const graph::FrameResult& frame) {
  auto color = frame.outputs.find("color");
  if (color == frame.outputs.end()) return {};
  const image::Image& image = color->second.floats;
  const image::NotFinite found = image::notFiniteIn(image);
  if (found.pixels == 0) return {};
  return {kNotFiniteLimit.text(fmt::format("color: {} of {} pixels {} not finite, the first at {},{} ({})",
                                           found.pixels, image.width * image.height, found.pixels == 1 ? "is" : "are",
                                           found.x, found.y, found.value))};
}

// Is a clip in another pose at its end than where it begins again?
static bool jumps(const scene::Animation& clip) {
  return std::any_of(clip.tracks.begin(), clip.tracks.end(), [&](const scene::Track& track) {
    dvec4 first = scene::valueAt(track, 0), last = scene::valueAt(track, clip.duration);
    return glm::length(first - last) > 1e-9 * glm::length(first);
  });
}

static double firstKey(const scene::Animation& clip) {
  double first_s = clip.duration;
  for (const scene::Track& track : clip.tracks) first_s = std::min(first_s, track.times.front());
  return first_s;
}

std::vector<std::string> limitsMet(const Shot& shot, const scene::Scene& scene) {
  std::vector<std::string> met;
  auto [open_s, close_s] = shot.window();
  if (!(close_s > open_s)) return met;
  for (const scene::Animation& clip : scene.animations) {
    bool plays = shot.animation == "all" || shot.animation == clip.name;
    if (!plays || clip.tracks.empty()) continue;
    std::string times = fmt::format("the exposure from {:.6g} s to {:.6g} s", open_s, close_s);
    double first_s = firstKey(clip);
    if (open_s < first_s && close_s >= first_s)
      met.push_back(
          kBeforeClipLimit.text(fmt::format("{} begins before '{}' does at {:.6g} s", times, clip.name, first_s)));
    bool seam = scene::clipTime(close_s, clip.duration) < scene::clipTime(open_s, clip.duration);
    if (seam && jumps(clip))
      met.push_back(
          kClipSeamLimit.text(fmt::format("{} spans the end of '{}' at {:.6g} s", times, clip.name, clip.duration)));
  }
  return met;
}

}  // namespace strobe::lab
