// SPDX-License-Identifier: MIT
// The runtime's own bounding volume hierarchy of a scene, which shaders traverse without the driver's ray tracing. It consists
// of an upper tree over the instances, and of one tree over the triangles of each mesh. A node has up to four children. Their
// bounds are quantised to 8 bits per plane (Ylitie, Karras, Laine, "Efficient Incoherent Ray Traversal on GPUs Through
// Compressed Wide BVHs", HPG 2017). The sizes of the structures are multiples of 8 bytes, because shaders load two 32-bit words
// at once.
#ifndef STROBE_SHARED_BVH_H
#define STROBE_SHARED_BVH_H
#include "shared/types.h"
STROBE_SHARED_BEGIN

// Reference to a child: the index of a node or, if the highest bit (BVH_LEAF) is set, a leaf. A leaf of the upper tree has the
// index of an instance. A leaf of a mesh's tree has 1 to 4 triangles: the bits from BVH_LEAF_COUNT on have their number minus
// 1, and the bits below have the index of the first triangle.
#define BVH_LEAF 0x80000000u
#define BVH_LEAF_COUNT 29u
// Largest number of nodes; entries of a ray's stack have 24 bits for a node.
#define BVH_MOST_NODES 0x1000000u
// Largest depth of a tree over triangles, and of the tree over instances, in levels. They bound a ray's stack, which has at
// most one entry per level.
#define BVH_MESH_DEPTH 40
#define BVH_TOP_DEPTH 20

// Node with the bounds of its children. The bounds of child c are origin + step * (byte c of `low`) and origin + step * (byte c
// of `high`), per axis, rounded outwards.
struct BvhNode {
  vec3 origin;
  uint steps;  // bytes from the lowest: exponent of the step (a power of two), plus 127, in x, y, z; number of children
  uvec3 low, high;
  uint children[4];  // references to nodes or leaves
  float reach;       // in a tree's first node: upper bound of the magnitudes of all coordinates of the tree's bounds
  uint unused;
};

// Triangle of a mesh. The triangles of a mesh are stored in the order of the leaves of its tree.
struct BvhTriangle {
  vec3 corner[3];  // object space
  uint geometry;   // number within the instance; plus BVH_OPAQUE if every hit counts, without a test of alpha or side
  uint primitive;  // number of the triangle within the geometry
  uint unused;
};
#define BVH_OPAQUE 0x80000000u

// Instance at one time: transform of rays into object space, and tree.
struct BvhInstance {
  vec4 row_x, row_y, row_z;  // object-from-world transform
  uint root;                 // first node of the tree of the instance's mesh
  float reach;               // `reach` of that node
};

STROBE_SHARED_END
#ifdef __cplusplus
static_assert(sizeof(strobe::shared::BvhNode) == 64);
static_assert(sizeof(strobe::shared::BvhTriangle) == 48);
static_assert(sizeof(strobe::shared::BvhInstance) == 56);
#endif
#endif
