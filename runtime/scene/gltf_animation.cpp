// SPDX-License-Identifier: MIT
#include "scene/gltf_animation.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "scene/gltf_pointer.h"

namespace strobe::scene {

namespace {

class AnimationReader {
 public:
  AnimationReader(const GltfFile& file, Scene& scene) : file_(file), scene_(scene) {}

  void readAnimations() {
    const Json& animations = file_.all("animations");
    std::set<std::string> taken;
    for (size_t i = 0; i < animations.size(); ++i) {
      Animation animation;
      animation.name = file_.uniqueName(animations[i], fmt::format("animation_{}", i), taken);
      const Json& channels = file_.list(animations[i], "channels", "");
      for (const char* key : {"channels", "samplers"})
        if (file_.list(animations[i], key, "").empty())
          file_.refuse(fmt::format("animations[{}]", i), fmt::format("has no {}", key));
      driven_.clear();
      for (size_t k = 0; k < channels.size(); ++k)
        readChannel(animations[i], channels[k], fmt::format("animations[{}].channels[{}]", i, k), animation);
      scene_.animations.push_back(std::move(animation));
    }
  }

  // A skin's vertices stand in its joints, not in the node that shows it: the mesh is put where the bind pose of the
  // joint of most weight has it, and moves with that joint. Where that joint has all the weight this is exact.
  void placeSkins() {
    const Json& nodes = file_.all("nodes");
    std::set<int> animated, parents;
    for (const Animation& animation : scene_.animations)
      for (const Track& track : animation.tracks) animated.insert(track.node);
    for (const Node& node : scene_.nodes) parents.insert(node.parent);
    for (size_t i = 0; i < nodes.size(); ++i) {
      std::string where = fmt::format("nodes[{}]", i);
      int skin_index = file_.index(nodes[i], "skin", "skins", where);
      Node& node = scene_.nodes[i];
      if (skin_index < 0 || node.mesh < 0) continue;
      const Json& skin = file_.all("skins").at(skin_index);
      const Json& joints = file_.list(skin, "joints", where);
      std::vector<double> weights = jointWeights(node.mesh, joints.size());
      size_t heaviest = std::max_element(weights.begin(), weights.end()) - weights.begin();
      double total = 0;
      for (double weight : weights) total += weight;
      bool exact = heaviest < weights.size() && weights[heaviest] >= 0.999 * total;
      if (!exact) warn(fmt::format("node '{}': bending by its skin is not supported; it is shown rigid", node.name));
      if (weights.empty() || animated.count(int(i)) || parents.count(int(i))) continue;
      Json holder = {{"joint", joints[heaviest]}};
      int joint = file_.index(holder, "joint", "nodes", fmt::format("skins[{}]", skin_index));
      if (joint == int(i)) continue;
      node.parent = joint;
      node.matrix = inverseBind(skin, heaviest, joints.size(), fmt::format("skins[{}]", skin_index));
    }
  }

 private:
  void warn(const std::string& text) { scene_.warnings.push_back(text); }

  void readChannel(const Json& json, const Json& channel, const std::string& where, Animation& animation) {
    std::optional<PointerTarget> target = targetOf(channel, where);
    if (!target) return;
    const Json& samplers = file_.list(json, "samplers", where);
    size_t sampler = file_.size(channel, "sampler", std::nullopt, where);
    if (sampler >= samplers.size()) file_.refuse(where, fmt::format("'sampler' is {} of {}", sampler, samplers.size()));
    Track track;
    track.node = target->node;
    track.target = target->target;
    readSampler(samplers[sampler], where, target->components, track);
    animation.duration = std::max(animation.duration, track.times.back());
    if (target->property) return animation.properties.push_back({*target->property, target->index, std::move(track)});
    splitMatrix(scene_.nodes[track.node]);
    animation.tracks.push_back(std::move(track));
  }

  // What a channel drives; nothing, and a warning, where that cannot be moved here.
  std::optional<PointerTarget> targetOf(const Json& channel, const std::string& where) {
    file_.require(channel, "target", where);
    const Json& target = file_.object(channel, "target", where);
    std::string path = file_.text(target, "path", where);
    if (path == "pointer") return pointed(target, where);
    PointerTarget result;
    result.node = file_.index(target, "node", "nodes", where);
    if (result.node < 0) return warn(where + ": names no node and is left out"), std::nullopt;
    if (path == "weights") return leftOut(result.node);
    if (path == "rotation") result.target = Track::Target::Rotation, result.components = 4;
    else if (path == "scale") result.target = Track::Target::Scale;
    else if (path != "translation") return warn(fmt::format("{}: path '{}' is left out", where, path)), std::nullopt;
    return once(result, fmt::format("/nodes/{}/{}", result.node, path), where);
  }

  std::optional<PointerTarget> pointed(const Json& target, const std::string& where) {
    std::string pointer = file_.text(file_.extension(target, "KHR_animation_pointer"), "pointer");
    if (pointer.empty()) file_.refuse(where, "its path is 'pointer', but KHR_animation_pointer names none");
    if (target.contains("node")) file_.refuse(where, "has both a pointer and a node");
    std::optional<PointerTarget> result = pointerTarget(file_, pointer, where);
    if (!result) return warn(fmt::format("{}: '{}' cannot be moved; it is left out", where, pointer)), std::nullopt;
    return once(*result, pointer, where);
  }

  std::optional<PointerTarget> leftOut(int node) {
    warn(fmt::format("node '{}': its morph animation is left out", scene_.nodes[node].name));
    return std::nullopt;
  }

  // Channels of one animation drive different things.
  std::optional<PointerTarget> once(const PointerTarget& target, const std::string& pointer, const std::string& where) {
    if (!driven_.insert(pointer).second)
      file_.refuse(where, fmt::format("drives {}, as another channel does", pointer));
    return target;
  }

  void readSampler(const Json& sampler, const std::string& where, int components, Track& track) {
    int input = file_.index(sampler, "input", "accessors", where);
    int output = file_.index(sampler, "output", "accessors", where);
    if (input < 0 || output < 0) file_.refuse(where, "its sampler lacks input or output");
    std::string how = file_.text(sampler, "interpolation", where);
    if (how == "STEP") track.interpolation = Track::Interpolation::Step;
    else if (how == "CUBICSPLINE") track.interpolation = Track::Interpolation::CubicSpline;
    else if (!how.empty() && how != "LINEAR") file_.refuse(where, fmt::format("interpolation '{}' is unknown", how));

    track.times = file_.accessor(input, where, {"SCALAR"}).numbers;
    for (size_t i = 0; i < track.times.size(); ++i) {
      bool sound = std::isfinite(track.times[i]) && (i == 0 || track.times[i] > track.times[i - 1]);
      if (!sound) file_.refuse(where, fmt::format("its key times do not increase at key {}", i));
    }
    Values values = file_.accessor(output, where, {components == 1 ? "SCALAR" : fmt::format("VEC{}", components)});
    size_t wanted = track.times.size() * (track.interpolation == Track::Interpolation::CubicSpline ? 3 : 1);
    if (values.count != wanted)
      file_.refuse(where, fmt::format("{} keys need {} values, not {}", track.times.size(), wanted, values.count));
    for (size_t i = 0; i < values.count; ++i) {
      dvec4 value(0);
      for (int c = 0; c < components; ++c) value[c] = values.at(i, c);
      if (!std::isfinite(glm::dot(value, value))) file_.refuse(where, fmt::format("its value {} is not finite", i));
      track.values.push_back(value);
    }
  }

  // An animated node needs its transform in parts.
  static void splitMatrix(Node& node) {
    if (!node.matrix) return;
    dmat3 linear(*node.matrix);
    node.translation = dvec3((*node.matrix)[3]);
    node.scale = {glm::length(linear[0]), glm::length(linear[1]), glm::length(linear[2])};
    if (glm::determinant(linear) < 0) node.scale.x = -node.scale.x;
    bool flat = node.scale.x == 0 || node.scale.y == 0 || node.scale.z == 0;
    if (!flat)
      node.rotation =
          glm::quat_cast(dmat3(linear[0] / node.scale.x, linear[1] / node.scale.y, linear[2] / node.scale.z));
    node.matrix.reset();
  }

  // The weight of each joint, summed over the mesh's vertices.
  std::vector<double> jointWeights(int mesh, size_t joints) {
    std::vector<double> sums(joints, 0.0);
    for (const Json& primitive : file_.list(file_.all("meshes").at(mesh), "primitives", "")) {
      std::string where = fmt::format("meshes[{}]", mesh);
      const Json& attributes = file_.object(primitive, "attributes", where);
      int index = file_.index(attributes, "JOINTS_0", "accessors", where);
      int weight = file_.index(attributes, "WEIGHTS_0", "accessors", where);
      if (index < 0 || weight < 0) continue;
      Values indices = file_.accessor(index, where, {"VEC4"}), weights = file_.accessor(weight, where, {"VEC4"});
      for (size_t i = 0; i < std::min(indices.count, weights.count); ++i) {
        for (int c = 0; c < 4; ++c) {
          double joint = indices.at(i, c), amount = weights.at(i, c);
          if (!(amount > 0) || !std::isfinite(amount)) continue;
          if (!(joint >= 0 && joint < double(joints)))
            file_.refuse(where, fmt::format("joint {} of {}", joint, joints));
          sums[size_t(joint)] += amount;
        }
      }
    }
    return sums;
  }

  dmat4 inverseBind(const Json& skin, size_t joint, size_t joints, const std::string& where) {
    int index = file_.index(skin, "inverseBindMatrices", "accessors", where);
    if (index < 0) return dmat4(1);
    Values values = file_.accessor(index, where, {"MAT4"});
    if (values.count < joints) file_.refuse(where, fmt::format("{} joints have {} matrices", joints, values.count));
    dmat4 matrix;
    for (int k = 0; k < 16; ++k) {
      matrix[k / 4][k % 4] = values.at(joint, k);
      if (!std::isfinite(values.at(joint, k))) file_.refuse(where, "an inverse bind matrix is not finite");
    }
    return matrix;
  }

  const GltfFile& file_;
  Scene& scene_;
  std::set<std::string> driven_;  // by channels of the animation that is read, as pointers
};

}  // namespace

void readAnimations(const GltfFile& file, Scene& scene) {
  AnimationReader reader(file, scene);
  reader.readAnimations();
  reader.placeSkins();
}

}  // namespace strobe::scene
