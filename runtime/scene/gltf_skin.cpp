// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "scene/gltf_parts.h"
#include "scene/motion.h"

namespace strobe::scene {

namespace {

class SkinReader {
 public:
  SkinReader(const GltfFile& file, Scene& scene) : file_(file), scene_(scene) {}

  void read() {
    const Json& skins = file_.all("skins");
    for (size_t i = 0; i < skins.size(); ++i) scene_.skins.push_back(readSkin(skins[i], fmt::format("skins[{}]", i)));
    for (size_t m = 0; m < file_.all("meshes").size(); ++m) {
      const std::vector<double> none(targetsOf(file_, int(m)), 0.0);
      weights_.push_back(file_.numbers(file_.all("meshes")[m], "weights", none, fmt::format("meshes[{}]", m)));
    }
    const Json& nodes = file_.all("nodes");
    for (size_t i = 0; i < nodes.size(); ++i) readNode(nodes[i], fmt::format("nodes[{}]", i), scene_.nodes[i]);
    for (size_t m = 0; m < scene_.meshes.size(); ++m) followNodes(int(m));
  }

 private:
  Skin readSkin(const Json& json, const std::string& where) {
    Skin skin;
    for (int node : file_.indexList(json, "joints", "nodes", where)) {
      if (std::count(skin.joints.begin(), skin.joints.end(), node))
        file_.refuse(where, fmt::format("lists joint {} twice", node));
      skin.joints.push_back(node);
    }
    skin.inverse_binds.assign(skin.joints.size(), dmat4(1));
    const int matrices = file_.index(json, "inverseBindMatrices", "accessors", where);
    if (matrices >= 0) readInverseBinds(matrices, where, skin);
    return skin;
  }

  void readInverseBinds(int index, const std::string& where, Skin& skin) {
    const Values values = file_.accessor(index, where, {"MAT4"});
    const size_t joints = skin.joints.size();
    if (values.count < joints)
      file_.refuse(where, fmt::format("has {} joints, but only {} inverse bind matrices", joints, values.count));
    for (size_t j = 0; j < joints; ++j) {
      dmat4& matrix = skin.inverse_binds[j];
      for (int k = 0; k < 16; ++k) matrix[k / 4][k % 4] = values.at(j, k);
      double sum = 0;
      for (int c = 0; c < 4; ++c) sum += glm::dot(glm::abs(matrix[c]), dvec4(1));
      if (!std::isfinite(sum)) file_.refuse(where, fmt::format("its inverse bind matrix {} is not finite", j));
      if (dvec4(matrix[0].w, matrix[1].w, matrix[2].w, matrix[3].w) != dvec4(0, 0, 0, 1))
        file_.refuse(where, fmt::format("its inverse bind matrix {} is not affine", j));
    }
  }

  void readNode(const Json& json, const std::string& where, Node& node) {
    node.skin = file_.index(json, "skin", "skins", where);
    for (const char* key : {"skin", "weights"})
      if (json.contains(key) && node.mesh < 0) file_.refuse(where, fmt::format("has {} but no mesh", key));
    if (node.mesh < 0) return;
    const std::string mesh_name = fmt::format("meshes[{}]", node.mesh);
    node.weights = file_.numbers(json, "weights", weights_[size_t(node.mesh)], where);
    if (node.skin < 0) return;
    const size_t joints = scene_.skins[size_t(node.skin)].joints.size();
    if (!hasJoints(node.mesh)) file_.refuse(where, fmt::format("has a skin, but {} has no joints", mesh_name));
    for (const Geometry& geometry : scene_.meshes[size_t(node.mesh)].geometries) {
      for (uint32_t joint : geometry.influences.joints)
        if (joint >= joints)
          file_.refuse(where, fmt::format("{} uses joint {}, but its skin has {} joints", mesh_name, joint, joints));
    }
  }

  bool hasJoints(int mesh) const {
    const Json& primitives = file_.all("meshes")[size_t(mesh)]["primitives"];
    return std::any_of(primitives.begin(), primitives.end(),
                       [](const Json& primitive) { return primitive["attributes"].contains("JOINTS_0"); });
  }

  // Primitives without joints, in a mesh that has primitives with joints, follow the node that shows the mesh. The node
  // becomes a joint, with the same number in each skin of the mesh.
  void followNodes(int mesh) {
    size_t own = 0;
    std::vector<int> nodes;
    for (size_t i = 0; i < scene_.nodes.size(); ++i) {
      if (scene_.nodes[i].mesh != mesh || scene_.nodes[i].skin < 0) continue;
      nodes.push_back(int(i));
      own = std::max(own, scene_.skins[size_t(scene_.nodes[i].skin)].joints.size());
    }
    bool any = false;
    for (Geometry& geometry : scene_.meshes[size_t(mesh)].geometries) {
      if (nodes.empty() || geometry.influences.count > 0) continue;
      any = true;
      geometry.influences = {1, std::vector<uint32_t>(geometry.vertices.size(), uint32_t(own)),
                             std::vector<double>(geometry.vertices.size(), 1.0)};
    }
    for (int node : nodes) {
      if (!any) continue;
      Skin skin = scene_.skins[size_t(scene_.nodes[size_t(node)].skin)];
      skin.joints.resize(own + 1, node);
      skin.inverse_binds.resize(own + 1, dmat4(1));
      scene_.nodes[size_t(node)].skin = int(scene_.skins.size());
      scene_.skins.push_back(std::move(skin));
    }
  }

  const GltfFile& file_;
  Scene& scene_;
  std::vector<std::vector<double>> weights_;  // by mesh
};

}  // namespace

void readSkins(const GltfFile& file, Scene& scene) { SkinReader(file, scene).read(); }

// Joint that all vertices of a mesh follow alone; -1 for several joints or no joint.
static int soleJoint(const Mesh& mesh) {
  int sole = -1;
  for (const Geometry& geometry : mesh.geometries)
    for (size_t k = 0; k < geometry.influences.shares.size(); ++k) {
      const int joint = int(geometry.influences.joints[k]);
      if (geometry.influences.shares[k] == 0 || joint == sole) continue;
      if (sole >= 0) return -1;
      sole = joint;
    }
  return sole;
}

// By node: true if keys may change the sign of the determinant of the node or of an ancestor.
static std::vector<bool> nodesThatMayMirror(const Scene& scene) {
  std::vector<bool> may(scene.nodes.size(), false);
  for (const Animation& clip : scene.animations)
    for (const Track& track : clip.tracks) {
      if (track.target != Track::Target::Scale) continue;
      const dvec3 rest = glm::sign(scene.nodes[size_t(track.object)].transform.scale);
      const bool keeps = track.interpolation != Track::Interpolation::CubicSpline &&
                         std::all_of(track.values.begin(), track.values.end(), [&](const dvec4& value) {
                           return glm::sign(dvec3(value)) == rest && value.x * value.y * value.z != 0;
                         });
      if (!keeps) may[size_t(track.object)] = true;
    }
  markDescendants(scene, may);
  return may;
}

void findSoleJoints(Scene& scene) {
  const std::vector<dmat4> worlds = restWorlds(scene);
  const std::vector<bool> may_mirror = nodesThatMayMirror(scene);
  for (size_t i = 0; i < scene.nodes.size(); ++i) {
    Node& node = scene.nodes[i];
    node.sole_joint = -1;
    if (node.skin < 0 || node.mesh < 0) continue;  // nodes outside of the file's scene have no mesh
    const int sole = soleJoint(scene.meshes[size_t(node.mesh)]);
    if (sole < 0 || may_mirror[i]) continue;
    const Skin& skin = scene.skins[size_t(node.skin)];
    const size_t joint = size_t(skin.joints[size_t(sole)]);
    const dmat4 posed = worlds[joint] * skin.inverse_binds[size_t(sole)];
    const bool same = (glm::determinant(dmat3(posed)) < 0) == (glm::determinant(dmat3(worlds[i])) < 0);
    if (same && !may_mirror[joint]) node.sole_joint = sole;
  }
}

size_t targetsOf(const GltfFile& file, int mesh) {
  const Json& primitives = file.list(file.all("meshes").at(mesh), "primitives", "");
  return primitives.empty() ? 0 : file.list(primitives[0], "targets", "").size();
}

void dropIdleWeights(Scene& scene) {
  std::vector<bool> driven(scene.nodes.size(), false);
  for (const Animation& clip : scene.animations)
    for (const Track& track : clip.tracks)
      if (track.target == Track::Target::Weight) driven[size_t(track.object)] = true;
  for (size_t i = 0; i < scene.nodes.size(); ++i) {
    std::vector<double>& weights = scene.nodes[i].weights;
    bool idle = std::all_of(weights.begin(), weights.end(), [](double weight) { return weight == 0; });
    if (idle && !driven[i]) weights.clear();
  }
}

}  // namespace strobe::scene
