// SPDX-License-Identifier: MIT
#include "scene/facts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "scene/bend.h"
#include "scene/motion.h"

namespace strobe::scene {

// Does its value change between two times of the clip? Jumps never do within a frame.
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

// By node: may it, or what it hangs on, move between two times?
static std::vector<bool> movingNodes(const Scene& scene, const std::string& animation, double from_s, double to_s) {
  std::vector<bool> moves(scene.nodes.size(), false);
  for (const Animation* clip : clipsOf(scene, animation))
    for (const Track& track : clip->tracks)
      if (varies(*clip, track, from_s, to_s)) moves[size_t(track.node)] = true;
  for (const ConstantMotion& motion : scene.motions)
    if (isMotion(motion)) moves[size_t(motion.node)] = true;
  for (int node : hierarchyOrder(scene)) {
    int parent = scene.nodes[size_t(node)].parent;
    if (parent >= 0 && moves[size_t(parent)]) moves[size_t(node)] = true;
  }
  return moves;
}

// By node: may the weights of its morph targets change between two times?
static std::vector<bool> morphingNodes(const Scene& scene, const std::string& animation, double from_s, double to_s) {
  std::vector<bool> morphs(scene.nodes.size(), false);
  for (const Animation* clip : clipsOf(scene, animation))
    for (const WeightTrack& track : clip->weights)
      if (varies(*clip, track.keys, from_s, to_s)) morphs[size_t(track.node)] = true;
  return morphs;
}

// May what a node shows move, given which nodes do? The joints of a skin decide, not the node.
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

// What the materials of a mesh's triangles ask for.
static void addMaterials(const Scene& scene, const Mesh& mesh, Facts& facts) {
  for (const Geometry& geometry : mesh.geometries) {
    if (!hasTriangles(geometry)) continue;
    const Material& material = scene.materials[size_t(geometry.material)];
    facts.alpha = facts.alpha || material.alpha != Material::Alpha::Opaque;
    facts.blend = facts.blend || material.alpha == Material::Alpha::Blend;
    facts.one_sided = facts.one_sided || !material.double_sided;
  }
}

// Do keys of the lens, or of a light that shines, change between two times?
struct VaryingProperties {
  bool lens = false, lights = false;
};

static VaryingProperties varyingProperties(const Scene& scene, const FrameView& view, double from_s, double to_s) {
  VaryingProperties varying;
  const int camera = scene.nodes[size_t(view.camera_node)].camera;
  for (const Animation* clip : clipsOf(scene, view.animation)) {
    for (const PropertyTrack& track : clip->properties) {
      if (!varies(*clip, track.keys, from_s, to_s)) continue;
      if (!track.isOfCamera()) varying.lights = true;
      else if (track.index == camera) varying.lens = true;
    }
  }
  return varying;
}

Facts factsOf(const Scene& scene, const FrameView& view) {
  const std::array<double, 4> times = {view.capture_s, view.open_s, view.close_s, view.previous_s};
  auto [from, to] = std::minmax_element(times.begin(), times.end());
  std::vector<bool> moves = movingNodes(scene, view.animation, *from, *to);
  std::vector<bool> morphs = morphingNodes(scene, view.animation, *from, *to);
  Poser poser(scene, view.camera_node, view.animation);
  std::vector<Pose> poses;
  for (double time_s : times) poses.push_back(poser.at(time_s, view.capture_s));
  auto differs = [&](auto part) {
    return std::any_of(poses.begin(), poses.end(), [&](const Pose& pose) { return part(pose) != part(poses[0]); });
  };

  Facts facts;
  VaryingProperties varying = varyingProperties(scene, view, *from, *to);
  bool camera_moves = view.camera_moves.value_or(moves[size_t(view.camera_node)] ||
                                                 differs([](const Pose& pose) { return pose.world_from_camera; }));
  facts.camera_moves = camera_moves || varying.lens || differs([](const Pose& pose) { return pose.camera; });
  facts.motion = facts.camera_moves || varying.lights || differs([](const Pose& pose) { return pose.lights; });
  facts.alpha = facts.blend = facts.one_sided = facts.shadows = facts.bends = false;
  std::vector<Instance> instances = instancesOf(scene);
  for (size_t i = 0; i < instances.size(); ++i) {
    const Mesh& mesh = scene.meshes[size_t(instances[i].mesh)];
    const bool empty = isEmpty(mesh);
    facts.moves.push_back(!empty &&
                          (showsMotion(scene, instances[i].node, moves) || morphs[size_t(instances[i].node)] ||
                           differs([&](const Pose& pose) { return pose.world_from_instance[i]; }) ||
                           differs([&](const Pose& pose) { return pose.bends[i]; })));
    if (empty) continue;
    facts.bends = facts.bends || bends(scene, instances[i]);
    addMaterials(scene, mesh, facts);
    facts.motion = facts.motion || facts.moves[i];
  }
  std::vector<int> lights = lightsOf(scene);
  for (size_t i = 0; i < lights.size(); ++i) {
    const Node& node = scene.nodes[size_t(lights[i])];
    facts.shadows = facts.shadows || scene.lights[size_t(node.light)].shadow;
    facts.motion =
        facts.motion || moves[size_t(lights[i])] || differs([&](const Pose& pose) { return pose.world_from_light[i]; });
  }
  return facts;
}

}  // namespace strobe::scene
