// SPDX-License-Identifier: MIT
// Order of triangles and instances. Some drivers build a tree by halving the given list (lavapipe up to Mesa 25.0), so
// the order defines the tree. Other drivers do not depend on the order. The list is split at the positions where such a
// driver splits it, on the best of three axes, so that each half is compact.
#pragma once

#include "math/bounds.h"
#include "scene/scene.h"

namespace strobe::scene {

// Indices of `boxes` in their new order, the same on every machine; ties by index. A box stays within its group: `ends`
// are the ends of consecutive groups, the last one is the end of the list. Empty boxes may be anywhere.
std::vector<uint32_t> treeOrder(const std::vector<Bounds>& boxes, const std::vector<size_t>& ends);

// Orders the triangles of every geometry, once, and stores their numbers in the file (`Geometry::source`).
void orderTriangles(Scene& scene);

// Number of a triangle of a geometry in the scene's file.
uint32_t sourceTriangle(const Geometry& geometry, uint32_t triangle);
// Number of a triangle in the scene's file, from device ids: instance from 1 (`instances`: all instances of the scene),
// geometry from 0. Returns `triangle` for ids that the scene does not have.
uint32_t sourceTriangle(const Scene& scene, const std::vector<Instance>& instances, uint32_t instance,
                        uint32_t geometry, uint32_t triangle);

// Bounds of a transformed box.
Bounds moved(const Bounds& box, const dmat4& transform);

// Expected number of nodes of such a tree, including leaves, that a random line through the tree hits: the sum of the
// areas of all boxes over the area of the outermost box (surface area heuristic; MacDonald and Booth 1990). 0 without
// boxes.
double treeCost(const std::vector<Bounds>& boxes);

// Cost of a scene: a tree over the posed instances, and in each instance the tree of its mesh, not deformed.
struct SceneTree {
  size_t triangles = 0, instances = 0;     // triangles of all instances
  double visits = 0, visits_as_given = 0;  // in the new order; in the order of the scene's file
};
SceneTree treeOf(const Scene& scene, const Pose& pose);

}  // namespace strobe::scene
