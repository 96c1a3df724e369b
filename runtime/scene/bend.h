// SPDX-License-Identifier: MIT
// Deformed meshes: vertices that follow several joints of a skin, or morph targets (glTF 2.0, 3.7.2.2 and 3.7.3).
#pragma once

#include <array>

#include "math/bounds.h"
#include "scene/scene.h"

namespace strobe::scene {

// True if the vertices of the instance may move relative to each other.
bool bends(const Scene& scene, const Instance& instance);

// Number of vertices in all geometries of the instance's mesh.
size_t vertexCount(const Scene& scene, const Instance& instance);

// World-from-mesh of each joint of the skin of the instance's node. `worlds`: world-from-node of every node.
std::vector<dmat4> jointsOf(const Scene& scene, const Instance& instance, const std::vector<dmat4>& worlds);

// Position, normal and tangent of a vertex after skinning and morphing, in double precision.
struct BentVertex {
  dvec3 position;
  dvec3 normal;              // unit; 0: use the triangle's normal
  dvec4 tangent = dvec4(0);  // as in Geometry::tangents
};

// Vertices of an instance that deforms, all geometries in order, in the space of Pose::world_from_instance. Joints and
// targets of weight 0 leave a vertex exactly unchanged.
std::vector<BentVertex> bentVertices(const Scene& scene, const Instance& instance, const Bend& bend);

// Bounds of all vertices of `instances[index]` as posed, world space.
Bounds posedBounds(const Scene& scene, const std::vector<Instance>& instances, size_t index, const Pose& pose);

// Bounds of all vertices of a mesh, relative to its origin.
Bounds vertexBounds(const Mesh& mesh);

// Sets the bounds of all geometries, so that code that runs every frame need not read every vertex. The vertices must
// not change afterwards.
void findBounds(Scene& scene);

// Boxes that contain an instance at every pose: the vertices are means of points in the boxes. The number of boxes is
// constant.
class Hull {
 public:
  Hull(const Scene& scene, const Instance& instance);
  size_t boxes() const { return boxes_.size(); }
  // World-space corners of a box. `index` is the index of this instance in the pose.
  std::array<dvec3, 8> corners(const Pose& pose, size_t index, size_t box) const;

 private:
  struct Box : VertexBounds {  // vertices that follow the joint, mesh space
    int joint = -1;            // -1: all vertices, instance space
  };
  std::vector<Box> boxes_;
};

}  // namespace strobe::scene
