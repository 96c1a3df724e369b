// SPDX-License-Identifier: MIT
// What bends: meshes whose vertices follow several joints of a skin, or morph targets (glTF 2.0, 3.7.2.2 and 3.7.3).
#pragma once

#include <array>

#include "math/bounds.h"
#include "scene/scene.h"

namespace strobe::scene {

// May its vertices move against each other?
bool bends(const Scene& scene, const Instance& instance);

// Vertices of all geometries of its mesh.
size_t vertexCount(const Scene& scene, const Instance& instance);

// World from mesh, of each joint of the skin of its node. `worlds`: world from node, of every node.
std::vector<dmat4> jointsOf(const Scene& scene, const Instance& instance, const std::vector<dmat4>& worlds);

struct BentVertex {
  dvec3 position;
  dvec3 normal;              // unit; 0: use the triangle's normal
  dvec4 tangent = dvec4(0);  // as Geometry::tangents has it
};

// The vertices of an instance that bends, of all geometries one after the other, as Pose::world_from_instance takes
// them. What a vertex does not follow does not change it by a bit.
std::vector<BentVertex> bentVertices(const Scene& scene, const Instance& instance, const Bend& bend);

// Around all vertices of `instances[index]` as posed, world space.
Bounds posedBounds(const Scene& scene, const std::vector<Instance>& instances, size_t index, const Pose& pose);

// Finds the bounds of all geometries, whose vertices stay what they are from then on: what follows their motion, at
// each frame, does not look at each of them.
void findBounds(Scene& scene);

// Boxes that an instance never leaves: its vertices are means of points in them. As many at every pose.
class Hull {
 public:
  Hull(const Scene& scene, const Instance& instance);
  size_t boxes() const { return boxes_.size(); }
  // Corners of a box where the pose has instance `index`, which is this one; world space.
  std::array<dvec3, 8> corners(const Pose& pose, size_t index, size_t box) const;

 private:
  struct Box : VertexBounds {  // of what follows the joint, in its mesh
    int joint = -1;            // -1: all, in the instance's space
  };
  std::vector<Box> boxes_;
};

}  // namespace strobe::scene
