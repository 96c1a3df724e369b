// SPDX-License-Identifier: MIT
#include "scene/motion.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "scene/bend.h"
#include "scene/flat.h"

namespace strobe::scene {

// A scale that is 0 along exactly one axis becomes the limit of positive scales, so that a sheet keeps its front.
static dvec3 sheetScale(dvec3 scale) {
  const bool is_flat = int(scale.x == 0) + int(scale.y == 0) + int(scale.z == 0) == 1;
  const double thickness = std::ldexp(glm::length(scale), -40);
  for (int axis = 0; axis < 3 && is_flat; ++axis)
    if (scale[axis] == 0) scale[axis] = thickness;
  return scale;
}

dmat4 Transform::matrix() const {
  dmat4 matrix = glm::mat4_cast(rotation);
  const dvec3 scales = sheetScale(scale);
  matrix[0] *= scales.x;
  matrix[1] *= scales.y;
  matrix[2] *= scales.z;
  matrix[3] = dvec4(translation, 1);
  return matrix;
}

static dmat4 sheared(const Node& node, const dmat4& matrix) {
  return node.shear ? matrix * dmat4(*node.shear) : matrix;
}

// Transform of the node itself, at rest.
static dmat4 restMatrix(const Node& node) {
  if (node.matrix) return *node.matrix;
  return sheared(node, node.transform.matrix());
}

// Unit vector along `column`, orthogonal to `axes`; nothing if `column` is in their span.
static std::optional<dvec3> axisAlong(dvec3 column, const std::vector<dvec3>& axes) {
  const double length = glm::length(column);
  for (const dvec3& axis : axes) column -= glm::dot(axis, column) * axis;
  if (!(glm::length(column) > 1e-12 * length)) return std::nullopt;
  return glm::normalize(column);
}

// Splits the matrix into rotation, scale and shear by Gram-Schmidt: linear = Q * U with an upper triangle U. The scale
// is the diagonal of U. Columns in the span of earlier columns have scale 0 and the remaining axis.
void splitMatrix(Node& node) {
  if (!node.matrix) return;
  const dmat3 linear(*node.matrix);
  std::vector<dvec3> found;
  std::array<std::optional<dvec3>, 3> axes;
  for (int c = 0; c < 3; ++c)
    if ((axes[c] = axisAlong(linear[c], found))) found.push_back(*axes[c]);
  for (int c = 0; c < 3; ++c)
    for (int k = 0; k < 3 && !axes[c]; ++k)
      if ((axes[c] = axisAlong(dmat3(1)[k], found))) found.push_back(*axes[c]);
  dmat3 turned(*axes[0], *axes[1], *axes[2]);
  if (glm::determinant(turned) < 0) turned[0] = -turned[0];
  const dmat3 upper = glm::transpose(turned) * linear;
  dmat3 shear(1);
  for (int row = 0; row < 3; ++row) {
    const bool flat = std::abs(upper[row][row]) <= 1e-12 * glm::length(linear[row]);
    node.transform.scale[row] = flat ? 0 : upper[row][row];
    for (int c = row + 1; c < 3 && !flat; ++c) shear[c][row] = upper[c][row] / upper[row][row];
  }
  node.transform.translation = dvec3((*node.matrix)[3]);
  node.transform.rotation = glm::quat_cast(turned);
  node.matrix.reset();
  // Matrices are stored as floats, so a smaller shear is rounding.
  bool square = true;
  for (int c = 0; c < 3; ++c) square = square && glm::length(shear[c] - dmat3(1)[c]) < 1e-6;
  if (!square) node.shear = shear;
}

static dquat quaternion(const dvec4& xyzw) { return dquat(xyzw.w, xyzw.x, xyzw.y, xyzw.z); }

static dvec4 unitIfRotation(const Track& track, const dvec4& value) {
  if (track.target != Track::Target::Rotation) return value;
  double length = glm::length(value);
  return length > 0 ? value / length : dvec4(0, 0, 0, 1);
}

// Hermite segment of glTF 2.0, appendix C. p0 and m0 are the value and the out-tangent of the first key; p1 and m1 are
// the value and the in-tangent of the second key.
static dvec4 hermite(const dvec4& p0, const dvec4& m0, const dvec4& p1, const dvec4& m1, double t, double length) {
  double t2 = t * t, t3 = t2 * t;
  return (2 * t3 - 3 * t2 + 1) * p0 + length * (t3 - 2 * t2 + t) * m0 + (-2 * t3 + 3 * t2) * p1 +
         length * (t3 - t2) * m1;
}

// Interpolates along the shorter arc. Nearly equal rotations are mixed, because the sine of their arc is near 0.
static dvec4 slerp(const dvec4& a, dvec4 b, double t) {
  double cosine = glm::dot(a, b);
  if (cosine < 0) b = -b, cosine = -cosine;
  if (cosine > 1 - 1e-12) return glm::normalize(glm::mix(a, b, t));
  double angle = std::acos(std::min(cosine, 1.0));
  return (std::sin((1 - t) * angle) * a + std::sin(t * angle) * b) / std::sin(angle);
}

dvec4 valueAt(const Track& track, double time_s) {
  const bool cubic = track.interpolation == Track::Interpolation::CubicSpline;
  auto value = [&](size_t key) { return track.values[cubic ? 3 * key + 1 : key]; };
  size_t after = std::upper_bound(track.times.begin(), track.times.end(), time_s) - track.times.begin();
  if (after == 0) return unitIfRotation(track, value(0));
  size_t key = after - 1;
  if (after == track.times.size() || track.interpolation == Track::Interpolation::Step)
    return unitIfRotation(track, value(key));
  double length = track.times[after] - track.times[key];
  double t = (time_s - track.times[key]) / length;
  if (cubic) {
    dvec4 out_tangent = track.values[3 * key + 2], in_tangent = track.values[3 * after];
    return unitIfRotation(track, hermite(value(key), out_tangent, value(after), in_tangent, t, length));
  }
  if (track.target != Track::Target::Rotation) return glm::mix(value(key), value(after), t);
  return slerp(unitIfRotation(track, value(key)), unitIfRotation(track, value(after)), t);
}

// Largest rounding error of the two times.
static double slackOf(double from_s, double to_s) { return kTimeRounding * std::max(std::abs(from_s), std::abs(to_s)); }

bool isBefore(double time_s, double other_s) { return time_s + slackOf(time_s, other_s) < other_s; }

double clipTime(double time_s, double duration_s) {
  if (!isBefore(duration_s, time_s)) return std::min(time_s, duration_s);
  if (duration_s <= 0) return 0;
  const double folded_s = std::fmod(time_s, duration_s);
  return folded_s + slackOf(time_s, time_s) < duration_s ? folded_s : 0;
}

bool beginsAgain(const Animation& clip, double from_s, double to_s) {
  if (!isBefore(clip.duration, to_s)) return false;
  if (to_s - from_s + slackOf(from_s, to_s) >= clip.duration) return true;
  return clipTime(to_s, clip.duration) < clipTime(from_s, clip.duration);
}

bool comesToACut(const std::vector<double>& cuts, double from_s, double to_s) {
  return std::any_of(cuts.begin(), cuts.end(),
                     [&](double cut_s) { return isBefore(from_s, cut_s) && !isBefore(to_s, cut_s); });
}

bool comesToACut(const Animation& clip, double from_s, double to_s) {
  if (clip.cuts.empty()) return false;
  const bool again = beginsAgain(clip, from_s, to_s);
  const double slack_s = slackOf(from_s, to_s);
  if (again && to_s - from_s + slack_s >= clip.duration) return true;
  const double from = clipTime(from_s, clip.duration) + slack_s, to = clipTime(to_s, clip.duration) + slack_s;
  return std::any_of(clip.cuts.begin(), clip.cuts.end(), [&](double cut) {
    if (cut <= 0 || cut >= clip.duration) return again;
    return again ? from < cut || cut <= to : from < cut && cut <= to;
  });
}

// Time of a key at most `slack_s` after `time_s`; `time_s` if no key is there.
static double keyTime(const Track& track, double time_s, double slack_s) {
  auto next = std::lower_bound(track.times.begin(), track.times.end(), time_s);
  return next != track.times.end() && *next <= time_s + slack_s ? *next : time_s;
}

dvec4 valueAt(const Animation& clip, const Track& track, double time_s, double held_time_s) {
  if (track.interpolation != Track::Interpolation::Step) return valueAt(track, clipTime(time_s, clip.duration));
  const double own_s = clipTime(held_time_s, clip.duration);
  return valueAt(track, keyTime(track, own_s, slackOf(held_time_s, held_time_s)));
}

bool increase(const std::vector<double>& numbers) {
  return std::adjacent_find(numbers.begin(), numbers.end(), [](double a, double b) { return !(a < b); }) ==
         numbers.end();
}

std::vector<int> hierarchyOrder(const Scene& scene) {
  enum { New, Open, Done };
  std::vector<int> state(scene.nodes.size(), New), order, chain;
  for (size_t start = 0; start < scene.nodes.size(); ++start) {
    for (int node = int(start); node >= 0 && state[node] != Done; node = scene.nodes[node].parent) {
      STROBE_ASSERT(scene.nodes[node].parent < int(scene.nodes.size()), "node {}", node);
      if (state[node] == Open)
        throw Error(fmt::format("{}: node '{}' is its own ancestor", scene.name, scene.nodes[node].name));
      state[node] = Open;
      chain.push_back(node);
    }
    for (; !chain.empty(); chain.pop_back()) {
      order.push_back(chain.back());
      state[chain.back()] = Done;
    }
  }
  return order;
}

void markDescendants(const Scene& scene, std::vector<bool>& marks) {
  for (int node : hierarchyOrder(scene)) {
    const int parent = scene.nodes[size_t(node)].parent;
    if (parent >= 0 && marks[size_t(parent)]) marks[size_t(node)] = true;
  }
}

std::vector<dmat4> restWorlds(const Scene& scene) {
  std::vector<dmat4> worlds(scene.nodes.size());
  for (int node : hierarchyOrder(scene)) {
    int parent = scene.nodes[node].parent;
    dmat4 own = restMatrix(scene.nodes[node]);
    worlds[node] = parent < 0 ? own : worlds[parent] * own;
  }
  return worlds;
}

// `world` after the motion up to `time_s`.
static dmat4 movedBy(const ConstantMotion& motion, const dmat4& world, double time_s) {
  double elapsed_s = time_s - motion.rest_time;
  dvec3 pivot = dvec3(world[3]);
  dmat4 moved = world;
  if (motion.angular_velocity != 0) {
    dmat4 turn = glm::mat4_cast(glm::angleAxis(motion.angular_velocity * elapsed_s, glm::normalize(motion.axis)));
    moved = turn * dmat4(world[0], world[1], world[2], dvec4(0, 0, 0, 1));
  }
  moved[3] = dvec4(pivot + motion.velocity * elapsed_s, 1);
  return moved;
}

// True if the node or the sole joint of a rigid instance may flatten it. `nodes`: flatteningNodes of the scene.
static bool flattens(const Scene& scene, const Instance& instance, const std::vector<dmat4>& worlds,
                     const std::vector<bool>& nodes) {
  const Node& node = scene.nodes[size_t(instance.node)];
  if (node.skin < 0)
    return nodes[size_t(instance.node)] ||
           isFlat(dmat3(worlds[size_t(instance.node)]) * dmat3(instance.node_from_instance));
  if (node.sole_joint < 0) return false;
  const Skin& skin = scene.skins[size_t(node.skin)];
  const size_t joint = size_t(skin.joints[size_t(node.sole_joint)]);
  return nodes[joint] || isFlat(dmat3(worlds[joint]) * dmat3(skin.inverse_binds[size_t(node.sole_joint)]));
}

std::vector<Instance> instancesOf(const Scene& scene) {
  std::vector<dmat4> worlds = restWorlds(scene);
  const std::vector<bool> flattening = flatteningNodes(scene);
  std::vector<Instance> instances;
  for (size_t i = 0; i < scene.nodes.size(); ++i) {
    const Node& node = scene.nodes[i];
    if (node.mesh < 0) continue;
    std::vector<dmat4> copies = node.instances.empty() ? std::vector<dmat4>{dmat4(1)} : node.instances;
    for (const dmat4& copy : copies) {
      instances.push_back({int(i), node.mesh, copy});
      instances.back().flattens = flattens(scene, instances.back(), worlds, flattening);
    }
  }
  return instances;
}

std::vector<int> lightsOf(const Scene& scene) {
  std::vector<int> lights;
  for (size_t i = 0; i < scene.nodes.size(); ++i)
    if (scene.nodes[i].light >= 0) lights.push_back(int(i));
  return lights;
}

int cameraNode(const Scene& scene, const std::string& name) {
  std::vector<std::string> names;
  for (size_t i = 0; i < scene.nodes.size(); ++i) {
    const Node& node = scene.nodes[i];
    if (node.camera < 0) continue;
    const std::string& camera = scene.cameras[node.camera].name;
    if (name.empty() || name == camera || name == node.name) return int(i);
    names.push_back(camera.empty() ? node.name : camera);
  }
  if (names.empty()) throw Error(fmt::format("{} has no camera", scene.name));
  throw Error(fmt::format("{} has no camera '{}'{}; it has {}", scene.name, name, didYouMean(name, names),
                          fmt::join(names, ", ")),
              {}, 2);
}

std::vector<const Animation*> clipsOf(const Scene& scene, const std::string& animation) {
  std::vector<const Animation*> clips;
  std::vector<std::string> names = {"all", "none"};
  for (const Animation& clip : scene.animations) {
    if (animation == "all" ? clip.yields_to < 0 : animation == clip.name) clips.push_back(&clip);
    names.push_back(clip.name);
  }
  if (!clips.empty() || animation == "all" || animation == "none") return clips;
  throw Error(fmt::format("{} has no animation '{}'{}; it has {}", scene.name, animation, didYouMean(animation, names),
                          fmt::join(names, ", ")),
              {}, 2);
}

static void applyTrack(const Track& track, const dvec4& value, Transform& transform) {
  if (track.target == Track::Target::Rotation) transform.rotation = quaternion(value);
  else (track.target == Track::Target::Scale ? transform.scale : transform.translation) = dvec3(value);
}

std::vector<dmat4> Poser::nodesAt(double time_s, double held_time_s) const {
  std::vector<Transform> transforms(scene_.nodes.size());
  for (const Driven& driven : driven_) {
    const Node& node = scene_.nodes[size_t(driven.node)];
    if (driven.keyed) transforms[size_t(driven.node)] = node.transform;
  }
  for (const Animation* clip : clips_)
    for (const Track& track : clip->tracks)
      if (track.isOfTransform())
        applyTrack(track, valueAt(*clip, track, time_s, held_time_s), transforms[size_t(track.object)]);

  std::vector<dmat4> worlds = rest_worlds_;
  for (const auto& [node, keyed, motions] : driven_) {
    const Node& its = scene_.nodes[size_t(node)];
    const int parent = its.parent;
    dmat4 own = keyed ? sheared(its, transforms[size_t(node)].matrix()) : restMatrix(its);
    dmat4& world = worlds[size_t(node)];
    world = parent < 0 ? own : worlds[size_t(parent)] * own;
    for (const ConstantMotion* motion : motions) world = movedBy(*motion, world, time_s);
  }
  return worlds;
}

std::vector<std::vector<double>> Poser::weightsAt(double time_s, double held_time_s) const {
  std::vector<std::vector<double>> weights;
  for (const Node& node : scene_.nodes) weights.push_back(node.weights);
  for (const Animation* clip : clips_)
    for (const Track& track : clip->tracks)
      if (track.target == Track::Target::Weight)
        weights[size_t(track.object)][track.weight] = valueAt(*clip, track, time_s, held_time_s).x;
  return weights;
}

// Applies the constant motions of a node with a skin to the joints of the skin. The pivot is the mesh's origin at the
// first joint. A joint that is the node itself has moved already.
static void moveJoints(const Scene& scene, int node, double time_s, std::vector<dmat4>& joints) {
  const Skin& skin = scene.skins[size_t(scene.nodes[size_t(node)].skin)];
  for (const ConstantMotion& motion : scene.motions) {
    if (motion.node != node) continue;
    const dmat4 pivot = glm::translate(dmat4(1), dvec3(joints[0][3]));
    const dmat4 step = movedBy(motion, pivot, time_s) * glm::inverse(pivot);
    for (size_t j = 0; j < joints.size(); ++j)
      if (skin.joints[j] != node) joints[j] = step * joints[j];
  }
}

// Poses an instance for the given transforms of nodes. Constant motions are applied if `time_s` is set.
static void place(const Scene& scene, const Instance& instance, const std::vector<dmat4>& worlds,
                  const std::vector<double>& weights, std::optional<double> time_s, dmat4& world, Bend& bend) {
  const Node& node = scene.nodes[size_t(instance.node)];
  world = worlds[size_t(instance.node)] * instance.node_from_instance;
  bend = {{}, weights};
  if (node.skin >= 0) {
    std::vector<dmat4> joints = jointsOf(scene, instance, worlds);
    if (time_s) moveJoints(scene, instance.node, *time_s, joints);
    if (node.sole_joint >= 0) world = joints[size_t(node.sole_joint)];
    else bend.joints = std::move(joints);
  }
  if (instance.flattens) bend.joints = {world};
  if (bend.joints.empty()) {
    world = glm::translate(world, scene.meshes[size_t(instance.mesh)].origin);
    return;
  }
  bend.mirrored = glm::determinant(dmat3(world)) < 0;
  world = glm::scale(dmat4(1), dvec3(bend.mirrored ? -1 : 1, 1, 1));
}

static Pose restPose(const Scene& scene, const std::vector<Instance>& instances, const std::vector<dmat4>& worlds) {
  Pose pose;
  pose.world_from_instance.resize(instances.size());
  pose.bends.resize(instances.size());
  for (size_t i = 0; i < instances.size(); ++i)
    place(scene, instances[i], worlds, scene.nodes[size_t(instances[i].node)].weights, std::nullopt,
          pose.world_from_instance[i], pose.bends[i]);
  return pose;
}

Pose restPose(const Scene& scene) { return restPose(scene, instancesOf(scene), restWorlds(scene)); }

// Camera frame of unit scale. The view direction is kept, the up direction is made orthogonal to it, and mirroring is
// dropped.
static dmat4 unitFrame(const dmat4& world, const std::string& name) {
  dvec3 z = dvec3(world[2]), y = dvec3(world[1]);
  dvec3 x = glm::cross(y, z);
  if (glm::length(z) == 0 || glm::length(x) == 0) throw Error(fmt::format("camera node '{}' has scale 0", name));
  z = glm::normalize(z);
  x = glm::normalize(x);
  return dmat4(dvec4(x, 0), dvec4(glm::cross(z, x), 0), dvec4(z, 0), world[3]);
}

static void applyTrack(const Track& track, const dvec4& value, Camera& camera) {
  using T = Track::Target;
  (track.target == T::FieldOfView  ? camera.vertical_fov
   : track.target == T::HalfHeight ? camera.half_height
                                   : camera.near) = value.x;
}

static void applyTrack(const Track& track, const dvec4& value, Light& light) {
  using T = Track::Target;
  if (track.target == T::Color) light.color = vec3(value);
  else
    (track.target == T::Intensity   ? light.intensity
     : track.target == T::Range     ? light.range
     : track.target == T::InnerCone ? light.inner_cone
                                    : light.outer_cone) = value.x;
}

// Applies the keys of the lens and of lights.
void Poser::keyProperties(Pose& pose, double time_s, double held_time_s) const {
  for (const Animation* clip : clips_) {
    for (const Track& track : clip->tracks) {
      if (track.isOfNode()) continue;
      dvec4 value = valueAt(*clip, track, time_s, held_time_s);
      bool ours = camera_node_ >= 0 && scene_.nodes[camera_node_].camera == track.object;
      if (track.isOfCamera() && ours) applyTrack(track, value, pose.camera);
      for (size_t i = 0; i < lights_.size() && track.isOfLight(); ++i)
        if (scene_.nodes[lights_[i]].light == track.object) applyTrack(track, value, pose.lights[i]);
    }
  }
}

Poser::Poser(const Scene& scene, int camera_node, const std::string& animation)
    : scene_(scene),
      instances_(instancesOf(scene)),
      lights_(lightsOf(scene)),
      camera_node_(camera_node),
      clips_(clipsOf(scene, animation)),
      rest_worlds_(restWorlds(scene)),
      rest_(restPose(scene, instances_, rest_worlds_)),
      driven_(drivenNodes()),
      driven_instances_(drivenInstances()) {}

std::vector<Poser::Driven> Poser::drivenNodes() const {
  std::vector<Driven> all(scene_.nodes.size());
  for (const Animation* clip : clips_)
    for (const Track& track : clip->tracks)
      if (track.isOfTransform()) all[size_t(track.object)].keyed = true;
  for (const ConstantMotion& motion : scene_.motions) all[size_t(motion.node)].motions.push_back(&motion);
  std::vector<Driven> driven;
  for (int node : hierarchyOrder(scene_)) {
    const int parent = scene_.nodes[size_t(node)].parent;
    Driven& own = all[size_t(node)];
    const bool is_below = parent >= 0 && all[size_t(parent)].node >= 0;
    if (!own.keyed && own.motions.empty() && !is_below) continue;
    own.node = node;
    driven.push_back(own);
  }
  return driven;
}

std::vector<size_t> Poser::drivenInstances() const {
  std::vector<bool> may_move(scene_.nodes.size());
  for (const Driven& driven : driven_) may_move[size_t(driven.node)] = true;
  for (const Animation* clip : clips_)
    for (const Track& track : clip->tracks)
      if (track.target == Track::Target::Weight) may_move[size_t(track.object)] = true;
  std::vector<size_t> driven;
  for (size_t i = 0; i < instances_.size(); ++i) {
    const size_t node = size_t(instances_[i].node);
    if (may_move[node] || scene_.nodes[node].skin >= 0) driven.push_back(i);
  }
  return driven;
}

Pose Poser::at(double time_s) const { return at(time_s, time_s); }

Pose Poser::at(double time_s, double held_time_s) const {
  std::vector<dmat4> worlds = nodesAt(time_s, held_time_s);
  const std::vector<std::vector<double>> weights = weightsAt(time_s, held_time_s);
  Pose pose = rest_;
  for (size_t i : driven_instances_)
    place(scene_, instances_[i], worlds, weights[size_t(instances_[i].node)], time_s, pose.world_from_instance[i],
          pose.bends[i]);
  for (int light : lights_) {
    pose.world_from_light.push_back(worlds[light]);
    pose.lights.push_back(scene_.lights[scene_.nodes[light].light]);
  }
  if (camera_node_ >= 0) {
    pose.world_from_camera = unitFrame(worlds[camera_node_], scene_.nodes[camera_node_].name);
    int camera = scene_.nodes[camera_node_].camera;
    if (camera >= 0) pose.camera = scene_.cameras[camera];
  }
  keyProperties(pose, time_s, held_time_s);
  return pose;
}

// The first names of a list, and the number of further names.
static std::string firstOf(std::vector<std::string> names, size_t count) {
  size_t more = names.size() > count ? names.size() - count : 0;
  names.resize(names.size() - more);
  return fmt::format("{}{}", fmt::join(names, ", "), more ? fmt::format(" and {} more", more) : "");
}

int nodeByName(const Scene& scene, const std::string& name) {
  std::vector<std::string> names;
  for (size_t i = 0; i < scene.nodes.size(); ++i) {
    if (scene.nodes[i].name == name) return int(i);
    names.push_back(scene.nodes[i].name);
  }
  std::string hint = didYouMean(name, names);
  if (hint.empty()) hint = "; it has " + firstOf(names, 12);
  throw Error(fmt::format("{} has no node '{}'{}", scene.name, name, hint), {}, 2);
}

}  // namespace strobe::scene
