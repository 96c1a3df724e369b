// SPDX-License-Identifier: MIT
// Needs: rays.
// What a ray through the runtime's own tree has yet to visit: an entry for each node of which children are left. The
// newest entries are in variables; an array, which a processor keeps in memory, takes the older ones of deep trees.

const uint kNextOnStack = 0xfffffffeu, kNothingLeft = 0xffffffffu;  // where a ray stands, besides nodes and leaves
const uint kInstanceEnds = 0xffffffffu;  // an entry: what is below it is of the tree over instances
const int kMovedAtOnce = 3;

struct BvhStack {
  uint a, b, c, d, e, f;  // from the newest; 0: there is none
  int older;              // how many are in the array
};

uint older_entries[BVH_MESH_DEPTH + BVH_TOP_DEPTH + 1];  // of the one ray that is on its way

BvhStack noEntries() {
  return BvhStack(0u, 0u, 0u, 0u, 0u, 0u, 0);
}

// The node, the numbers of children that are left (in the last 2 bits of k1 to k3), nearest first, and how many.
uint entryOf(uint node, uint k1, uint k2, uint k3, uint count) {
  return (node << 8) | ((k1 & 3u) << 2) | ((k2 & 3u) << 4) | ((k3 & 3u) << 6) | count;
}

void push(inout BvhStack stack, uint entry, bool pushes) {
  if (pushes && stack.f != 0u) {
    older_entries[stack.older] = stack.f;
    older_entries[stack.older + 1] = stack.e;
    older_entries[stack.older + 2] = stack.d;
    stack.older += kMovedAtOnce;
    stack.d = stack.e = stack.f = 0u;
  }
  stack.f = pushes ? stack.e : stack.f;
  stack.e = pushes ? stack.d : stack.e;
  stack.d = pushes ? stack.c : stack.d;
  stack.c = pushes ? stack.b : stack.c;
  stack.b = pushes ? stack.a : stack.b;
  stack.a = pushes ? entry : stack.a;
}

void drop(inout BvhStack stack) {
  stack.a = stack.b;
  stack.b = stack.c;
  stack.c = stack.d;
  stack.d = stack.e;
  stack.e = stack.f;
  stack.f = 0u;
}

// The newest entry, 0 without any.
uint top(inout BvhStack stack) {
  if (stack.a == 0u && stack.older > 0) {
    stack.older -= kMovedAtOnce;
    stack.c = older_entries[stack.older];
    stack.b = older_entries[stack.older + 1];
    stack.a = older_entries[stack.older + 2];
  }
  return stack.a;
}

// The next child of the newest entry, and the entry without it.
uint takeFrom(inout BvhStack stack) {
  uint entry = top(stack);
  if (entry == 0u) return kNothingLeft;
  if ((entry & 3u) == 1u) drop(stack);
  else stack.a = (entry & 0xffffff00u) | ((entry >> 2) & 0x3cu) | ((entry & 3u) - 1u);
  return scene_bvh.nodes.at[entry >> 8].children[(entry >> 2) & 3u];
}
