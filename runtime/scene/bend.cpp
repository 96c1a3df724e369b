// SPDX-License-Identifier: MIT
#include "scene/bend.h"

#include <algorithm>

#include "base/cores.h"

namespace strobe::scene {

static const Mesh& meshOf(const Scene& scene, const Instance& instance) { return scene.meshes[size_t(instance.mesh)]; }

// True if the vertices follow several joints of a skin.
static bool followsJoints(const Scene& scene, const Instance& instance) {
  const Node& node = scene.nodes[size_t(instance.node)];
  return node.skin >= 0 && node.sole_joint < 0;
}

bool bends(const Scene& scene, const Instance& instance) {
  bool may = followsJoints(scene, instance) || instance.flattens || !scene.nodes[size_t(instance.node)].weights.empty();
  return may && vertexCount(scene, instance) > 0;
}

size_t vertexCount(const Scene& scene, const Instance& instance) {
  size_t count = 0;
  for (const Geometry& geometry : meshOf(scene, instance).geometries) count += geometry.vertices.size();
  return count;
}

std::vector<dmat4> jointsOf(const Scene& scene, const Instance& instance, const std::vector<dmat4>& worlds) {
  const Skin& skin = scene.skins[size_t(scene.nodes[size_t(instance.node)].skin)];
  std::vector<dmat4> joints;
  for (size_t j = 0; j < skin.joints.size(); ++j)
    joints.push_back(worlds[size_t(skin.joints[j])] * skin.inverse_binds[j]);
  return joints;
}

// ---- vertices

namespace {

// Transforms a normal by the cofactors of the matrix. A matrix that mirrors keeps the side of the normal. Returns 0 for
// a normal in the plane of a sheet.
dvec3 normalBy(const dmat4& matrix, const dvec3& normal) {
  dvec3 x(matrix[0]), y(matrix[1]), z(matrix[2]);
  dvec3 along_x = glm::cross(y, z) * normal.x, along_y = glm::cross(z, x) * normal.y,
        along_z = glm::cross(x, y) * normal.z;
  dvec3 turned = along_x + along_y + along_z;
  const double largest = glm::length(glm::cross(y, z)) + glm::length(glm::cross(z, x)) + glm::length(glm::cross(x, y));
  if (glm::length(turned) < 1e-8 * largest) return dvec3(0);
  return glm::dot(x, glm::cross(y, z)) < 0 ? -turned : turned;
}

double handednessOf(const dmat4& matrix) {
  return glm::dot(dvec3(matrix[0]), glm::cross(dvec3(matrix[1]), dvec3(matrix[2]))) < 0 ? -1 : 1;
}

dvec3 unitOrNone(const dvec3& normal) {
  double largest = std::max({std::abs(normal.x), std::abs(normal.y), std::abs(normal.z)});
  return largest > 0 && std::isfinite(largest) ? glm::normalize(normal / largest) : dvec3(0);
}

// Deformed vertices of one geometry.
class Bending {
 public:
  Bending(const Mesh& mesh, const Geometry& geometry, const Bend& bend)
      : mesh_(mesh), geometry_(geometry), bend_(bend) {}

  BentVertex at(size_t v) const {
    BentVertex vertex = morphed(v);
    if (geometry_.faceted) vertex.normal = dvec3(0);
    const dvec4 tangent = vertex.tangent;
    if (bend_.joints.empty()) return {vertex.position, unitOrNone(vertex.normal), tangentOf(dvec3(tangent), tangent.w)};
    const dmat4 matrix = matrixOf(v);
    vertex.position = dvec3(matrix * dvec4(mesh_.origin + vertex.position, 1));
    vertex.normal = unitOrNone(normalBy(matrix, vertex.normal));
    if (tangent.w != 0) vertex.tangent = tangentOf(dmat3(matrix) * dvec3(tangent), tangent.w * handednessOf(matrix));
    if (!bend_.mirrored) return vertex;
    vertex.position.x = -vertex.position.x, vertex.normal.x = -vertex.normal.x;
    vertex.tangent.x = -vertex.tangent.x, vertex.tangent.w = -vertex.tangent.w;
    return vertex;
  }

 private:
  // Returns 0 for a direction without a length.
  static dvec4 tangentOf(const dvec3& direction, double handedness) {
    const dvec3 unit = unitOrNone(direction);
    return unit == dvec3(0) ? dvec4(0) : dvec4(unit, handedness);
  }

  BentVertex morphed(size_t v) const {
    BentVertex vertex{dvec3(geometry_.vertices[v].position), dvec3(geometry_.vertices[v].normal)};
    if (!geometry_.tangents.empty()) vertex.tangent = dvec4(geometry_.tangents[v]);
    for (size_t t = 0; t < bend_.weights.size() && t < geometry_.targets.size(); ++t) {
      const MorphTarget& target = geometry_.targets[t];
      if (!target.positions.empty()) vertex.position += bend_.weights[t] * dvec3(target.positions[v]);
      if (!target.normals.empty()) vertex.normal += bend_.weights[t] * dvec3(target.normals[v]);
      if (!target.tangents.empty()) vertex.tangent += bend_.weights[t] * dvec4(target.tangents[v], 0);
    }
    return vertex;
  }

  // Weighted mean of the matrices of the vertex's joints; the only matrix of an instance that flattens.
  dmat4 matrixOf(size_t v) const {
    const Influences& influences = geometry_.influences;
    if (bend_.joints.size() == 1) return bend_.joints[0];
    dmat4 matrix(0);
    for (size_t k = v * size_t(influences.count), end = k + size_t(influences.count); k < end; ++k)
      if (influences.shares[k] != 0) matrix += influences.shares[k] * bend_.joints[influences.joints[k]];
    return matrix;
  }

  const Mesh& mesh_;
  const Geometry& geometry_;
  const Bend& bend_;
};

constexpr size_t kBlock = 10000;  // vertices that one thread deforms at a time

}  // namespace

std::vector<BentVertex> bentVertices(const Scene& scene, const Instance& instance, const Bend& bend) {
  const Mesh& mesh = meshOf(scene, instance);
  std::vector<BentVertex> vertices(vertexCount(scene, instance));
  BentVertex* to = vertices.data();
  for (const Geometry& geometry : mesh.geometries) {
    const Bending bending(mesh, geometry, bend);
    const size_t count = geometry.vertices.size();
    forEachOnAllCores((count + kBlock - 1) / kBlock, [&](size_t block) {
      for (size_t v = block * kBlock; v < std::min(count, (block + 1) * kBlock); ++v) to[v] = bending.at(v);
    });
    to += count;
  }
  return vertices;
}

// ---- bounds

Bounds posedBounds(const Scene& scene, const std::vector<Instance>& instances, size_t index, const Pose& pose) {
  const dmat4& world = pose.world_from_instance[index];
  Bounds bounds;
  auto add = [&](const dvec3& position) { bounds.add(dvec3(world * dvec4(position, 1))); };
  if (bends(scene, instances[index])) {
    for (const BentVertex& vertex : bentVertices(scene, instances[index], pose.bends[index])) add(vertex.position);
    return bounds;
  }
  for (const Geometry& geometry : meshOf(scene, instances[index]).geometries)
    for (const Vertex& vertex : geometry.vertices) add(dvec3(vertex.position));
  return bounds;
}

// Adds a vertex, and its offsets in the morph targets, to `bounds`.
static void addVertex(const Geometry& geometry, size_t vertex, const dvec3& origin, VertexBounds& bounds) {
  bounds.rest.add(origin + dvec3(geometry.vertices[vertex].position));
  std::vector<Bounds>& targets = bounds.targets;
  targets.resize(std::max(targets.size(), geometry.targets.size()), Bounds{dvec3(0), dvec3(0)});
  for (size_t t = 0; t < geometry.targets.size(); ++t)
    if (!geometry.targets[t].positions.empty()) targets[t].add(dvec3(geometry.targets[t].positions[vertex]));
}

static VertexBounds boundsOf(const Geometry& geometry) {
  VertexBounds bounds;
  for (size_t v = 0; v < geometry.vertices.size(); ++v) addVertex(geometry, v, dvec3(0), bounds);
  return bounds;
}

Bounds vertexBounds(const Mesh& mesh) {
  Bounds bounds;
  for (const Geometry& geometry : mesh.geometries)
    for (const Vertex& vertex : geometry.vertices) bounds.add(dvec3(vertex.position));
  return bounds;
}

void findBounds(Scene& scene) {
  for (Mesh& mesh : scene.meshes)
    for (Geometry& geometry : mesh.geometries) geometry.bounds = boundsOf(geometry);
}

Hull::Hull(const Scene& scene, const Instance& instance) {
  const Mesh& mesh = meshOf(scene, instance);
  const bool follows = followsJoints(scene, instance);
  const int skin = scene.nodes[size_t(instance.node)].skin;
  boxes_.resize(follows ? scene.skins[size_t(skin)].joints.size() : 1);
  for (size_t j = 0; j < boxes_.size() && follows; ++j) boxes_[j].joint = int(j);
  for (const Geometry& geometry : mesh.geometries) {
    const size_t count = follows ? size_t(geometry.influences.count) : 0;
    for (size_t k = 0; k < geometry.vertices.size() * count; ++k)
      if (geometry.influences.shares[k] != 0)
        addVertex(geometry, k / count, mesh.origin, boxes_[geometry.influences.joints[k]]);
    if (!follows) boxes_[0].add(geometry.bounds ? *geometry.bounds : boundsOf(geometry));
  }
  if (instance.flattens) {
    boxes_[0].joint = 0;
    boxes_[0].rest.low += mesh.origin, boxes_[0].rest.high += mesh.origin;
  }
  std::erase_if(boxes_, [](const Box& box) { return box.rest.empty(); });
}

std::array<dvec3, 8> Hull::corners(const Pose& pose, size_t index, size_t box) const {
  const Box& own = boxes_[box];
  const Bend& bend = pose.bends[index];
  Bounds bounds = own.rest;
  for (size_t t = 0; t < std::min(own.targets.size(), bend.weights.size()); ++t) {
    const dvec3 low = bend.weights[t] * own.targets[t].low, high = bend.weights[t] * own.targets[t].high;
    bounds.low += glm::min(low, high), bounds.high += glm::max(low, high);
  }
  const dmat4& world = own.joint < 0 ? pose.world_from_instance[index] : bend.joints[size_t(own.joint)];
  std::array<dvec3, 8> corners;
  for (size_t c = 0; c < 8; ++c) corners[c] = dvec3(world * dvec4(bounds.corner(int(c)), 1));
  return corners;
}

}  // namespace strobe::scene
