// SPDX-License-Identifier: MIT
// The runtime's own bounding volume hierarchy over a scene: an upper tree over the instances, and for each mesh a tree over its
// triangles. A node has up to four children. Bounds are quantised to 8 bits per plane (Ylitie, Karras, Laine, "Efficient
// Incoherent Ray Traversal on GPUs Through Compressed Wide BVHs", HPG 2017). Sizes of structures are multiples of 8 bytes,
// because shaders load two words at once.
#ifndef STROBE_SHARED_BVH_H
#define STROBE_SHARED_BVH_H
#include "shared/types.h"
STROBE_SHARED_BEGIN

// A child is the index of a node or, if its highest bit is set, a leaf. A leaf of the upper tree holds an instance's index. A
// leaf of a mesh's tree holds 1 to 4 triangles: their number minus 1 in the bits from BVH_LEAF_COUNT, the index of the first
// triangle in the bits below.
#define BVH_LEAF 0x80000000u
#define BVH_LEAF_COUNT 29u
#define BVH_MOST_NODES 0x1000000u
// Largest number of levels of a tree over triangles, and of the tree over instances. A ray's stack has at most one entry per
// level.
#define BVH_MESH_DEPTH 40
#define BVH_TOP_DEPTH 20

// The bounds of child c are origin + step * (byte c of `low`) and origin + step * (byte c of `high`), rounded outwards.
struct BvhNode {
  vec3 origin;
  uint steps;  // bytes from the lowest: biased exponents of the step (a power of two) in x, y, z; number of children
  uvec3 low, high;
  uint children[4];
  float reach;  // in a tree's first node: upper bound of the magnitudes of all coordinates of the tree's bounds
  uint unused;
};

struct BvhTriangle {
  vec3 corner[3];  // object space
  uint geometry;   // number within the instance; BVH_OPAQUE is set if every hit counts, without a test of alpha or side
  uint primitive;
  uint unused;
};
#define BVH_OPAQUE 0x80000000u

struct BvhInstance {
  vec4 row_x, row_y, row_z;  // object-from-world
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
