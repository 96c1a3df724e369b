// SPDX-License-Identifier: MIT
#include "scene/facts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "scene/bend.h"
#include "scene/motion.h"

namespace strobe::scene {

// Pixel coordinates of a world position, nothing when it is not clearly in front of the camera.
static std::optional<dvec2> project(const dmat4& camera_from_world, const Camera& camera, const dvec3& position_ws,
                                    int width, int height) {
  dvec3 p = dvec3(camera_from_world * dvec4(position_ws, 1));
  double depth = -p.z;
  if (!camera.orthographic && depth < 2 * camera.near) return std::nullopt;
  double half_height = camera.orthographic ? camera.half_height : std::tan(camera.vertical_fov / 2) * depth;
  double pixels = height / (2 * half_height);
  return dvec2(0.5 * width + p.x * pixels, 0.5 * height - p.y * pixels);
}

namespace {

// Grows around what one instance covers over time.
struct Area {
  dvec2 low{INFINITY}, high{-INFINITY};
  double step_px = 0;  // the farthest a corner goes between two times

  void add(const std::array<dvec2, 8>& now, const std::array<dvec2, 8>* before) {
    for (size_t i = 0; i < 8; ++i) {
      low = glm::min(low, now[i]);
      high = glm::max(high, now[i]);
      if (before) step_px = std::max(step_px, glm::length(now[i] - (*before)[i]));
    }
  }
};

}  // namespace

// Does the clip repeat between two times?
static bool beginsAgain(const Animation& clip, double from_s, double to_s) {
  bool goes_round = to_s > clip.duration && to_s - from_s >= clip.duration;
  return goes_round || clipTime(to_s, clip.duration) < clipTime(from_s, clip.duration);
}

// Do poses at so many times show where everything comes? Not of what turns by more than a right angle from one to the
// next, which they may even show at rest.
static bool isFollowed(const Scene& scene, double open_s, double close_s, int times) {
  double step_s = (close_s - open_s) / (times - 1);
  for (const ConstantMotion& motion : scene.motions)
    if (std::abs(motion.angular_velocity) * step_s > 1.57) return false;
  for (const Animation& clip : scene.animations) {
    if (beginsAgain(clip, open_s, close_s)) return false;
    double from_s = clipTime(open_s, clip.duration), to_s = clipTime(close_s, clip.duration);
    // Two poses between keys, which are half a turn apart at most.
    auto is_dense = [&](const Track& track) {
      auto first = std::upper_bound(track.times.begin(), track.times.end(), from_s);
      auto last = std::lower_bound(track.times.begin(), track.times.end(), to_s);
      return last - first > times / 2;
    };
    if (std::any_of(clip.tracks.begin(), clip.tracks.end(), is_dense)) return false;
    for (const WeightTrack& track : clip.weights)
      if (is_dense(track.keys)) return false;
  }
  return true;
}

// The pixels around what an instance covers.
static void addTo(PixelArea& reach, const Area& area, int width, int height) {
  double margin = area.step_px + 2;
  PixelArea own = {int(std::floor(std::clamp(area.low.x - margin, 0.0, double(width)))),
                   int(std::floor(std::clamp(area.low.y - margin, 0.0, double(height)))),
                   int(std::ceil(std::clamp(area.high.x + margin, 0.0, double(width)))),
                   int(std::ceil(std::clamp(area.high.y + margin, 0.0, double(height))))};
  if (own.empty()) return;
  if (reach.empty()) reach = own;
  reach = {std::min(reach.x0, own.x0), std::min(reach.y0, own.y0), std::max(reach.x1, own.x1),
           std::max(reach.y1, own.y1)};
}

PixelArea reachOfMotion(const Scene& scene, const std::function<Pose(double)>& pose_at, double capture_s, double open_s,
                        double close_s, int width, int height) {
  constexpr int kTimes = 33;
  const PixelArea everywhere = {0, 0, width, height};
  if (!isFollowed(scene, open_s, close_s, kTimes)) return everywhere;
  std::vector<Instance> instances = instancesOf(scene);
  Pose capture = pose_at(capture_s);
  std::vector<Pose> poses;
  for (int i = 0; i < kTimes; ++i) poses.push_back(pose_at(open_s + (close_s - open_s) * i / (kTimes - 1)));
  for (const Pose& pose : poses)
    if (pose.world_from_camera != capture.world_from_camera || pose.camera != capture.camera) return everywhere;
  dmat4 camera_from_world = glm::inverse(capture.world_from_camera);

  PixelArea reach;
  for (size_t i = 0; i < instances.size(); ++i) {
    auto differs = [&](const Pose& pose) {
      return pose.world_from_instance[i] != capture.world_from_instance[i] || pose.bends[i] != capture.bends[i];
    };
    if (std::none_of(poses.begin(), poses.end(), differs)) continue;
    const Hull hull(scene, instances[i]);
    poses.push_back(capture);
    for (size_t box = 0; box < hull.boxes(); ++box) {
      Area area;
      std::array<dvec2, 8> before{};
      for (size_t k = 0; k < poses.size(); ++k) {
        std::array<dvec3, 8> corners = hull.corners(poses[k], i, box);
        std::array<dvec2, 8> now;
        for (size_t c = 0; c < 8; ++c) {
          std::optional<dvec2> pixel = project(camera_from_world, capture.camera, corners[c], width, height);
          if (!pixel) return everywhere;
          now[c] = *pixel;
        }
        bool consecutive = k > 0 && k + 1 < poses.size();
        area.add(now, consecutive ? &before : nullptr);
        before = now;
      }
      addTo(reach, area, width, height);
    }
    poses.pop_back();
  }
  return reach;
}

// ---- facts

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
