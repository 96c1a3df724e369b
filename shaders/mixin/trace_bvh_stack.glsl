// SPDX-License-Identifier: MIT
// Needs: rays.
// Stack of the nodes that a ray still has to visit in the runtime's own tree. Each entry is a node with the children that are
// left to visit. The newest six entries are in variables, which can stay in registers. Older entries, which only deep trees
// have, are in an array, which is in slower memory.

// References that are neither a node nor a leaf. kNextOnStack: continue with the next child on the stack. kNothingLeft: the
// traversal is finished.
const uint kNextOnStack = 0xfffffffeu, kNothingLeft = 0xffffffffu;
// Entry that separates two trees on the stack. Newer entries belong to the tree of one instance's mesh, older entries to the
// tree over instances. If the next entry to visit is this one, the mesh is finished.
const uint kInstanceEnds = 0xffffffffu;
const int kMovedAtOnce = 3;  // number of entries that move between variables and array at a time

// Stack of one ray.
struct BvhStack {
  uint a, b, c, d, e, f;  // entries, newest first; 0: unused
  int older;              // number of entries in the array
};

// Older entries of the stack. One array suffices, because an invocation traces one ray at a time.
uint older_entries[BVH_MESH_DEPTH + BVH_TOP_DEPTH + 1];

// Empty stack.
BvhStack noEntries() {
  return BvhStack(0u, 0u, 0u, 0u, 0u, 0u, 0);
}

// Stack entry of a node: the index of the node (24 bits), the numbers of up to three children that are left (2 bits
// each), and the count of these children (2 bits). `k1` to `k3`: sort keys of these children, nearest first; the last 2
// bits of a key are the number of the child.
uint entryOf(uint node, uint k1, uint k2, uint k3, uint count) {
  return (node << 8) | ((k1 & 3u) << 2) | ((k2 & 3u) << 4) | ((k3 & 3u) << 6) | count;
}

// Push an entry if `pushes` is true. If all six variables are in use, the oldest three entries first move to the array.
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

// Remove the newest entry. This entry must be in a variable, as after a call of `top`.
void drop(inout BvhStack stack) {
  stack.a = stack.b;
  stack.b = stack.c;
  stack.c = stack.d;
  stack.d = stack.e;
  stack.e = stack.f;
  stack.f = 0u;
}

// Newest entry; 0 if the stack is empty. If all entries are in the array, the newest three move back to the variables.
uint top(inout BvhStack stack) {
  if (stack.a == 0u && stack.older > 0) {
    stack.older -= kMovedAtOnce;
    stack.c = older_entries[stack.older];
    stack.b = older_entries[stack.older + 1];
    stack.a = older_entries[stack.older + 2];
  }
  return stack.a;
}

// Take the next child from the newest entry, and return its reference. Returns kNothingLeft if the stack is empty.
uint takeFrom(inout BvhStack stack) {
  uint entry = top(stack);
  if (entry == 0u) return kNothingLeft;
  if ((entry & 3u) == 1u) drop(stack);
  else stack.a = (entry & 0xffffff00u) | ((entry >> 2) & 0x3cu) | ((entry & 3u) - 1u);
  return scene_bvh.nodes.at[entry >> 8].children[(entry >> 2) & 3u];
}
