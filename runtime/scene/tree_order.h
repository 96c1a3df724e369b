// SPDX-License-Identifier: MIT
// The order of triangles and instances. Some drivers build a tree over them by halving the list as it is given
// (lavapipe up to Mesa 25.0), so that the order is the tree; to others it makes no difference. Here halves are made of
// what lies together: exact halves at the positions where such a driver cuts, on the best of three axes.
#pragma once

#include "math/bounds.h"
#include "scene/scene.h"

namespace strobe::scene {

// The indices of `boxes` in their new order; the same on every machine, ties by index. A box stays within its group:
// `ends` are the ends of consecutive groups, the last that of all. Empty boxes go anywhere.
std::vector<uint32_t> treeOrder(const std::vector<Bounds>& boxes, const std::vector<size_t>& ends);

// Orders the triangles of every geometry, once, and keeps which ones they were (`Geometry::source`).
void orderTriangles(Scene& scene);

// The triangle of a geometry as the scene's file has it.
uint32_t sourceTriangle(const Geometry& geometry, uint32_t triangle);
// The same by what the device calls it: the number of the instance from 1 (`instances`: those of the scene), that of
// the geometry from 0. Numbers that the scene does not have give the triangle back.
uint32_t sourceTriangle(const Scene& scene, const std::vector<Instance>& instances, uint32_t instance,
                        uint32_t geometry, uint32_t triangle);

// Around a box that is moved.
Bounds moved(const Bounds& box, const dmat4& transform);

// Nodes of such a tree that a random line through it meets, the leaves among them: the sum of the areas of all boxes
// over that of the outermost (the surface area heuristic; MacDonald and Booth 1990). 0 without boxes.
double treeCost(const std::vector<Bounds>& boxes);

// The same of a scene: a tree over instances as they stand, and in each the tree of its mesh, unbent.
struct SceneTree {
  size_t triangles = 0, instances = 0;     // triangles of all instances
  double visits = 0, visits_as_given = 0;  // as ordered; in the order of the scene's file
};
SceneTree treeOf(const Scene& scene, const Pose& pose);

}  // namespace strobe::scene
