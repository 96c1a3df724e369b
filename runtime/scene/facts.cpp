// SPDX-License-Identifier: MIT
#include "scene/facts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

#include "scene/bend.h"
#include "scene/motion.h"

namespace strobe::scene {

// True if the value of a track changes between two times of the clip. STEP tracks do not change within a frame.
static bool varies(const Track& track, double from_s, double to_s) {
  if (track.interpolation == Track::Interpolation::Step) return false;
  if (to_s <= track.times.front() || from_s >= track.times.back()) return false;
  bool cubic = track.interpolation == Track::Interpolation::CubicSpline;
  size_t first = size_t(std::upper_bound(track.times.begin(), track.times.end(), from_s) - track.times.begin());
  size_t last = size_t(std::lower_bound(track.times.begin(), track.times.end(), to_s) - track.times.begin());
  first -= first > 0 ? 1 : 0;
  last = std::min(last, track.times.size() - 1);
  auto value = [&](size_t key) { return track.values[cubic ? 3 * key + 1 : key]; };
  auto slopes = [&](size_t key) {
    return cubic && (track.values[3 * key] != dvec4(0) || track.values[3 * key + 2] != dvec4(0));
  };
  for (size_t key = first; key <= last; ++key)
    if (value(key) != value(first) || slopes(key)) return true;
  return false;
}

static bool varies(const Animation& clip, const Track& track, double from_s, double to_s) {
  if (beginsAgain(clip, from_s, to_s)) return varies(track, -INFINITY, INFINITY);
  return varies(track, clipTime(from_s, clip.duration), clipTime(to_s, clip.duration));
}

static bool isMotion(const ConstantMotion& motion) {
  return motion.velocity != dvec3(0) || motion.angular_velocity != 0;
}

// By node: true if the node or an ancestor may move between two times.
static std::vector<bool> movingNodes(const Scene& scene, const std::string& animation, double from_s, double to_s) {
  std::vector<bool> moves(scene.nodes.size(), false);
  for (const Animation* clip : clipsOf(scene, animation))
    for (const Track& track : clip->tracks)
      if (track.isOfTransform() && varies(*clip, track, from_s, to_s)) moves[size_t(track.object)] = true;
  for (const ConstantMotion& motion : scene.motions)
    if (isMotion(motion)) moves[size_t(motion.node)] = true;
  markDescendants(scene, moves);
  return moves;
}

// By node: true if the weights of its morph targets may change between two times.
static std::vector<bool> morphingNodes(const Scene& scene, const std::string& animation, double from_s, double to_s) {
  std::vector<bool> morphs(scene.nodes.size(), false);
  for (const Animation* clip : clipsOf(scene, animation))
    for (const Track& track : clip->tracks)
      if (track.target == Track::Target::Weight && varies(*clip, track, from_s, to_s))
        morphs[size_t(track.object)] = true;
  return morphs;
}

// True if the mesh of a node may move. `moves`: the nodes that may move. The joints of a skin decide, not the node.
static bool showsMotion(const Scene& scene, int index, const std::vector<bool>& moves) {
  const Node& node = scene.nodes[size_t(index)];
  if (node.skin < 0) return moves[size_t(index)];
  for (const ConstantMotion& motion : scene.motions)
    if (motion.node == index && isMotion(motion)) return true;
  const std::vector<int>& joints = scene.skins[size_t(node.skin)].joints;
  return std::any_of(joints.begin(), joints.end(), [&](int joint) { return moves[size_t(joint)]; });
}

static bool hasTriangles(const Geometry& geometry) { return !geometry.indices.empty(); }

static bool isEmpty(const Mesh& mesh) {
  return std::none_of(mesh.geometries.begin(), mesh.geometries.end(), hasTriangles);
}

// Adds the requirements of the materials of a mesh's triangles.
static void addMaterials(const Scene& scene, const Mesh& mesh, Facts& facts) {
  for (const Geometry& geometry : mesh.geometries) {
    if (!hasTriangles(geometry)) continue;
    const Material& material = scene.materials[size_t(geometry.material)];
    facts.alpha = facts.alpha || material.alpha != Material::Alpha::Opaque;
    facts.blend = facts.blend || material.alpha == Material::Alpha::Blend;
    facts.one_sided = facts.one_sided || !material.double_sided;
  }
}

// First and last time of an object's poses.
using Span = std::pair<double, double>;

// Moving parts of a scene, cached by time span, because each object may have another span.
class Driven {
 public:
  Driven(const Scene& scene, const std::string& animation) : scene_(scene), animation_(animation) {}

  bool isNode(int node, Span span) { return within(span).nodes[size_t(node)]; }

  bool isInstance(const Instance& instance, Span span) {
    const Moving& moving = within(span);
    return showsMotion(scene_, instance.node, moving.nodes) || moving.morphs[size_t(instance.node)];
  }

  // True if keys change the lens of a camera or the emission of a light.
  bool isProperty(bool of_camera, int index, Span span) const {
    for (const Animation* clip : clipsOf(scene_, animation_))
      for (const Track& track : clip->tracks)
        if ((of_camera ? track.isOfCamera() : track.isOfLight()) && track.object == index && isTime(span) &&
            varies(*clip, track, span.first, span.second))
          return true;
    return false;
  }

  static bool isTime(Span span) { return span.first < span.second; }

 private:
  struct Moving {
    std::vector<bool> nodes, morphs;
  };

  const Moving& within(Span span) {
    auto [found, is_new] = moving_.try_emplace(span);
    if (!is_new) return found->second;
    const std::vector<bool> none(scene_.nodes.size(), false);
    if (!isTime(span)) found->second = {none, none};
    else
      found->second = {movingNodes(scene_, animation_, span.first, span.second),
                       morphingNodes(scene_, animation_, span.first, span.second)};
    return found->second;
  }

  const Scene& scene_;
  const std::string& animation_;
  std::map<Span, Moving> moving_;
};

Facts factsOf(const FramePoser& poser, std::optional<bool> camera_moves) {
  const Scene& scene = poser.scene();
  const FrameView& view = poser.view();
  const std::array<double, 4> times = {view.raster_s, view.open_s, view.close_s, view.previous_s};
  std::vector<Pose> poses;
  for (double time_s : times) poses.push_back(poser.at(time_s));
  auto differs = [&](auto part) {
    return std::any_of(poses.begin(), poses.end(), [&](const Pose& pose) { return part(pose) != part(poses[0]); });
  };
  auto spanOf = [&](auto own) {
    std::array<double, 4> owned;
    std::transform(times.begin(), times.end(), owned.begin(), own);
    auto [from, to] = std::minmax_element(owned.begin(), owned.end());
    return Span(*from, *to);
  };
  Driven driven(scene, poser.animation());

  Facts facts;
  const Span span = spanOf([&](double time_s) { return poser.cameraTime(time_s); });
  if (camera_moves) facts.camera_moves = *camera_moves && Driven::isTime(span);
  else
    facts.camera_moves =
        driven.isNode(poser.cameraNode(), span) || differs([](const Pose& pose) { return pose.world_from_camera; });
  facts.camera_moves = facts.camera_moves ||
                       driven.isProperty(true, scene.nodes[size_t(poser.cameraNode())].camera, span) ||
                       differs([](const Pose& pose) { return pose.camera; });
  facts.motion = facts.camera_moves;
  facts.alpha = facts.blend = facts.one_sided = facts.shadows = facts.deforms = false;
  const std::vector<Instance> instances = instancesOf(scene);
  for (size_t i = 0; i < instances.size(); ++i) {
    const Mesh& mesh = scene.meshes[size_t(instances[i].mesh)];
    const bool empty = isEmpty(mesh);
    const Span own = spanOf([&](double time_s) { return poser.instanceTime(i, time_s); });
    facts.moves.push_back(!empty && (driven.isInstance(instances[i], own) ||
                                     differs([&](const Pose& pose) { return pose.world_from_instance[i]; }) ||
                                     differs([&](const Pose& pose) { return pose.bends[i]; })));
    if (empty) continue;
    facts.deforms = facts.deforms || bends(scene, instances[i]);
    addMaterials(scene, mesh, facts);
    facts.motion = facts.motion || facts.moves[i];
  }
  const std::vector<int> lights = lightsOf(scene);
  for (size_t i = 0; i < lights.size(); ++i) {
    const int light = scene.nodes[size_t(lights[i])].light;
    const Span own = spanOf([&](double time_s) { return poser.lightTime(i, time_s); });
    facts.shadows = facts.shadows || scene.lights[size_t(light)].shadow;
    facts.motion = facts.motion || driven.isNode(lights[i], own) || driven.isProperty(false, light, own) ||
                   differs([&](const Pose& pose) { return pose.lights[i]; }) ||
                   differs([&](const Pose& pose) { return pose.world_from_light[i]; });
  }
  return facts;
}

}  // namespace strobe::scene
