// SPDX-License-Identifier: MIT
// The trees over the triangles of a scene's meshes, as the tracing backend `bvh` has them on the device.
#pragma once

#include <vector>

#include "scene/scene.h"
#include "world/bvh.h"

namespace strobe::world {

struct MeshTrees {
  std::vector<shared::BvhNode> nodes;          // of all meshes; children are numbered across them
  std::vector<shared::BvhTriangle> triangles;  // in the order of leaves
  std::vector<uint32_t> roots;                 // of each mesh; of one without triangles a node without children
  std::vector<Box> bounds;                     // of each mesh, object space; of one without triangles inside out
};

MeshTrees buildMeshTrees(const scene::Scene& scene);

}  // namespace strobe::world
