// SPDX-License-Identifier: MIT
// The runtime's own tree over a scene: two levels, instances above and the triangles of each mesh below, four children
// to a node. Bounds are quantised to 8 bits per plane (Ylitie, Karras, Laine, "Efficient Incoherent Ray Traversal on
// GPUs Through Compressed Wide BVHs", HPG 2017). Sizes are multiples of 8 bytes: devices load two words at once.
#ifndef STROBE_SHARED_BVH_H
#define STROBE_SHARED_BVH_H
#include "shared/types.h"
STROBE_SHARED_BEGIN

// A child is the index of a node or, with its highest bit set, a leaf: above an instance, below 1 to 4 triangles, whose
// number less 1 is in the bits from BVH_LEAF_COUNT and the first of which in those below.
#define BVH_LEAF 0x80000000u
#define BVH_LEAF_COUNT 29u
#define BVH_MOST_NODES 0x1000000u
// Levels of the tree over triangles and of that over instances; a ray keeps one entry of each level.
#define BVH_MESH_DEPTH 40
#define BVH_TOP_DEPTH 20

// The planes of child c are at origin + step * (byte c of low, of high), outside of what is in the child.
struct BvhNode {
  vec3 origin;
  uint steps;  // from the lowest byte: biased exponents of the power of two that is a step in x, y, z; number of
               // children
  uvec3 low, high;
  uint children[4];
  float reach;  // of the first node of a tree: no plane's coordinate is larger
  uint unused;
};

struct BvhTriangle {
  vec3 corner[3];  // object space
  uint geometry;   // within the instance; the highest bit is set where a hit on it counts without a question
  uint primitive;
  uint unused;
};
#define BVH_OPAQUE 0x80000000u

struct BvhInstance {
  vec4 row_x, row_y, row_z;  // object-from-world
  uint root;                 // node of its mesh
  float reach;               // of that node
};

STROBE_SHARED_END
#ifdef __cplusplus
static_assert(sizeof(strobe::shared::BvhNode) == 64);
static_assert(sizeof(strobe::shared::BvhTriangle) == 48);
static_assert(sizeof(strobe::shared::BvhInstance) == 56);
#endif
#endif
