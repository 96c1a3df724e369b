// SPDX-License-Identifier: MIT
// Needs: rays.
// Tracing backend `bvh`: traversal of the runtime's own tree (shared/bvh.h), in compute shaders. If several hits have equal
// distances, the hit that comes first in the scene counts, in the order of instance, geometry and triangle.
// Triangle test: Woop, Benthin, Wald, "Watertight Ray/Triangle Intersection" (JCGT 2013), in double precision if the device
// supports it.
#include "mixin/trace_bvh_stack.glsl"

#ifdef STROBE_DOUBLES
#define BVH_FLOAT double
#define BVH_VEC2 dvec2

// Structures of shared/bvh.h, read as pairs of 32-bit words, because one load can read two words. On a processor, loads are
// most of the cost of a ray.
struct BvhNodePairs {
  double at[8];
};
struct BvhTrianglePairs {
  double at[6];
};
struct BvhInstancePairs {
  double at[7];
};
layout(buffer_reference, scalar, buffer_reference_align = 8) readonly buffer BvhPairsOfNodes { BvhNodePairs of[]; };
layout(buffer_reference, scalar, buffer_reference_align = 8) readonly buffer BvhPairsOfTriangles { BvhTrianglePairs of[]; };
layout(buffer_reference, scalar, buffer_reference_align = 8) readonly buffer BvhPairsOfInstances { BvhInstancePairs of[]; };

// Three functions that read two words of a node, of a triangle or of an instance: the pair of words with the index
// `pair`.
uvec2 nodeWords(uint node, int pair) { return unpackDouble2x32(BvhPairsOfNodes(scene_bvh.nodes).of[node].at[pair]); }
uvec2 triangleWords(uint triangle, int pair) {
  return unpackDouble2x32(BvhPairsOfTriangles(scene_bvh.triangles).of[triangle].at[pair]);
}
uvec2 instanceWords(uint at, int pair) {
  return unpackDouble2x32(BvhPairsOfInstances(scene_bvh.instances).of[at].at[pair]);
}

// Nodes, triangles and instances, loaded by index. Members that the traversal does not read are 0.
BvhNode loadedNode(uint node) {
  uvec2 w0 = nodeWords(node, 0), w1 = nodeWords(node, 1), w2 = nodeWords(node, 2), w3 = nodeWords(node, 3);
  uvec2 w4 = nodeWords(node, 4), w5 = nodeWords(node, 5), w6 = nodeWords(node, 6);
  return BvhNode(uintBitsToFloat(uvec3(w0, w1.x)), w1.y, uvec3(w2, w3.x), uvec3(w3.y, w4),
                 uint[4](w5.x, w5.y, w6.x, w6.y), 0.0, 0u);
}
BvhTriangle loadedTriangle(uint triangle) {
  uvec2 w0 = triangleWords(triangle, 0), w1 = triangleWords(triangle, 1), w2 = triangleWords(triangle, 2);
  uvec2 w3 = triangleWords(triangle, 3), w4 = triangleWords(triangle, 4);
  return BvhTriangle(vec3[3](uintBitsToFloat(uvec3(w0, w1.x)), uintBitsToFloat(uvec3(w1.y, w2)),
                             uintBitsToFloat(uvec3(w3, w4.x))), w4.y, 0u, 0u);
}
BvhInstance loadedInstance(uint at) {
  vec4 x = uintBitsToFloat(uvec4(instanceWords(at, 0), instanceWords(at, 1)));
  vec4 y = uintBitsToFloat(uvec4(instanceWords(at, 2), instanceWords(at, 3)));
  vec4 z = uintBitsToFloat(uvec4(instanceWords(at, 4), instanceWords(at, 5)));
  uvec2 tree = instanceWords(at, 6);
  return BvhInstance(x, y, z, tree.x, uintBitsToFloat(tree.y));
}
#else
#define BVH_FLOAT float
#define BVH_VEC2 vec2
// Nodes, triangles and instances, loaded by index, for devices without double precision.
BvhNode loadedNode(uint node) { return scene_bvh.nodes.at[node]; }
BvhTriangle loadedTriangle(uint triangle) { return scene_bvh.triangles.at[triangle]; }
BvhInstance loadedInstance(uint at) { return scene_bvh.instances.at[at]; }
#endif

// Ray in the space of a tree. `inverse`: 1 / direction, for the tests of boxes. The last three members are for the triangle
// test: `longest` is the axis of the direction's largest component (0 to 2), `shear` maps the direction to this axis, and
// `mirrored` is true if two axes are swapped to keep the winding of triangles.
struct BvhRay {
  vec3 origin, inverse;
  vec3 shear;
  int longest;
  bool mirrored;
};

// Vector with permuted axes: the axis `longest` of the ray becomes z.
vec3 alongLongest(BvhRay ray, vec3 v) {
  vec3 turned = ray.longest == 0 ? v.yzx : ray.longest == 1 ? v.zxy : v;
  return ray.mirrored ? turned.yxz : turned;
}

// 1 / direction, bounded in magnitude, so that planes with coordinates up to `reach` are at finite distances along the ray.
vec3 boundedInverse(vec3 origin, vec3 direction, float reach) {
  vec3 bounded = max(abs(direction), max(abs(origin) * 1e-36 + reach * 1e-36, vec3(1e-18)));
  return mix(1.0 / bounded, -1.0 / bounded, lessThan(direction, vec3(0)));
}

// Ray in the space of a tree. `reach`: upper bound of the coordinates of the tree's planes.
BvhRay rayOf(vec3 origin, vec3 direction, float reach) {
  vec3 size = abs(direction);
  BvhRay ray = BvhRay(origin, boundedInverse(origin, direction, reach), vec3(0), 0, false);
  ray.longest = size.x >= size.y ? (size.x >= size.z ? 0 : 2) : (size.y >= size.z ? 1 : 2);
  ray.mirrored = (ray.longest == 0 ? direction.x : ray.longest == 1 ? direction.y : direction.z) < 0.0;
  vec3 along = alongLongest(ray, direction);
  ray.shear = vec3(along.x, along.y, 1.0) * (1.0 / along.z);
  return ray;
}

// Ray in the object space of an instance, from a ray in world space. `at`: index into the array of instances, which
// holds the instances of one level after the other (one level per time, `levelOf`). `root`: output, root of the tree of
// the instance's mesh.
BvhRay rayIn(uint at, Ray world_ray, out uint root) {
  BvhInstance instance = loadedInstance(at);
  vec4 x = instance.row_x, y = instance.row_y, z = instance.row_z;
  vec4 start = vec4(world_ray.origin, 1);
  vec3 direction =
      vec3(dot(x.xyz, world_ray.direction), dot(y.xyz, world_ray.direction), dot(z.xyz, world_ray.direction));
  root = instance.root;
  return rayOf(vec3(dot(x, start), dot(y, start), dot(z, start)), direction, instance.reach);
}

// Intersection of a ray with a triangle. x: distance t along the ray; t <= 0 is a miss. y, z: weights of the second and third
// corner. `geometry`: output, the member `geometry` of the triangle, including the flag BVH_OPAQUE.
vec3 meetTriangle(BvhRay ray, uint triangle, out uint geometry) {
  BvhTriangle met = loadedTriangle(triangle);
  geometry = met.geometry;
  vec3 a = alongLongest(ray, met.corner[0] - ray.origin);
  vec3 b = alongLongest(ray, met.corner[1] - ray.origin);
  vec3 c = alongLongest(ray, met.corner[2] - ray.origin);
  vec2 p = a.xy - ray.shear.xy * a.z;
  vec2 q = b.xy - ray.shear.xy * b.z;
  vec2 r = c.xy - ray.shear.xy * c.z;
  // Reject most misses in single precision: if two products differ after rounding, their exact values have the same order. The
  // sign of their difference is then certain.
  vec3 more = vec3(r.x * q.y, p.x * r.y, q.x * p.y), less = vec3(r.y * q.x, p.y * r.x, q.y * p.x);
  bool has_positive = more.x > less.x || more.y > less.y || more.z > less.z;
  bool has_negative = more.x < less.x || more.y < less.y || more.z < less.z;
  if (has_positive && has_negative) return vec3(-1);

  BVH_VEC2 fine_p = BVH_VEC2(p), fine_q = BVH_VEC2(q), fine_r = BVH_VEC2(r);
  BVH_FLOAT u = fine_r.x * fine_q.y - fine_r.y * fine_q.x;
  BVH_FLOAT v = fine_p.x * fine_r.y - fine_p.y * fine_r.x;
  BVH_FLOAT w = fine_q.x * fine_p.y - fine_q.y * fine_p.x;
  BVH_FLOAT zero = BVH_FLOAT(0);
  bool outside = (u < zero || v < zero || w < zero) && (u > zero || v > zero || w > zero);
  if (outside) return vec3(-1);
  BVH_FLOAT determinant = u + (v + w);
  BVH_FLOAT z = BVH_FLOAT(ray.shear.z);
  BVH_FLOAT t = u * (z * BVH_FLOAT(a.z)) + v * (z * BVH_FLOAT(b.z)) + w * (z * BVH_FLOAT(c.z));
  float divisor = float(determinant);
  if (divisor == 0.0) return vec3(-1);
  return vec3(float(t / determinant), float(v) / divisor, float(w) / divisor);
}

// True if `triangle` comes before `other` in the scene, by geometry, then by number. Both are triangles of one instance.
bool isBefore(uint triangle, uint other) {
  uint geometry = scene_bvh.triangles.at[triangle].geometry, other_geometry = scene_bvh.triangles.at[other].geometry;
  if (geometry != other_geometry) return (geometry & ~BVH_OPAQUE) < (other_geometry & ~BVH_OPAQUE);
  return scene_bvh.triangles.at[triangle].primitive < scene_bvh.triangles.at[other].primitive;
}

// Positions of one bounding plane of each of the four children of a node, in steps from the node's origin, 0 to 255. The
// conversion is from signed integers, because processors convert vectors of unsigned integers more slowly.
vec4 planes(uint bytes) { return vec4(ivec4((uvec4(bytes) >> uvec4(0, 8, 16, 24)) & 255u)); }

// Maximum and minimum of finite distances, compared as integers by their bits: this takes one instruction instead of three,
// because NaN needs no special case. The bits of floats of at least 0 have the order of the floats. With negative distances,
// the maximum is right if one of the two is at least 0. The minimum is negative if one of the two is negative.
vec4 largestDistance(vec4 a, vec4 b) { return intBitsToFloat(max(floatBitsToInt(a), floatBitsToInt(b))); }
vec4 smallestDistance(vec4 a, vec4 b) { return intBitsToFloat(min(floatBitsToInt(a), floatBitsToInt(b))); }

// Size of a node's quantisation step along each axis, in the units of the tree's space.
vec3 stepsOf(BvhNode at) { return uintBitsToFloat((uvec3(at.steps) << uvec3(23, 15, 7)) & 0x7f800000u); }

// Bound of the rounding errors of the distances along a ray to the bounding planes in a node, per axis. `offset`: distance
// along the ray to the node's origin. `step_t`: distance along the ray per step.
vec3 slackOf(vec3 offset, vec3 step_t) { return (abs(offset) + 255.0 * abs(step_t)) * (1.0 / 1048576.0); }

// Child of the node that the ray meets first; kNextOnStack if the ray meets no child. The node is `at`, and its index is
// `node`. `enter`, `leave`: distances along the ray to the entry into and the exit from the boxes of the four children; `enter`
// must be at least 0. The ray meets the children with `enter` <= `leave`. `others`: output, stack entry of the other children
// that the ray meets, or 0.
uint firstMet(BvhNode at, uint node, vec4 enter, vec4 leave, out uint others) {
  uvec4 met = uvec4(lessThanEqual(enter, leave)) & uvec4(lessThan(uvec4(0, 1, 2, 3), uvec4(at.steps >> 24)));
  // Sort the children by `enter`. The last two bits of each key are the number of the child. The keys of missed children are
  // largest, so that they come last.
  uvec4 keys = (floatBitsToUint(enter) & ~3u) | uvec4(0, 1, 2, 3) | (met - 1u);
  uvec2 first = min(keys.xz, keys.yw), second = max(keys.xz, keys.yw);
  uint k0 = min(first.x, first.y), k3 = max(second.x, second.y);
  uint m0 = max(first.x, first.y), m1 = min(second.x, second.y);
  uint k1 = min(m0, m1), k2 = max(m0, m1);
  uint hits = met.x + met.y + met.z + met.w;
  others = entryOf(node, k1, k2, k3, hits - 1u);
  others = hits > 1u ? others : 0u;
  uint even = (k0 & 2u) == 0u ? at.children[0] : at.children[2], odd = (k0 & 2u) == 0u ? at.children[1] : at.children[3];
  uint nearest = (k0 & 1u) == 0u ? even : odd;
  return hits == 0u ? kNextOnStack : nearest;
}

// Child of a node that the ray meets first between t_min (0 or more) and t_max; kNextOnStack if it meets no child. `others`:
// output, stack entry of the other children that the ray meets, or 0 (`firstMet`).
uint nearestChild(uint node, BvhRay ray, float t_min, float t_max, out uint others) {
  BvhNode at = loadedNode(node);
  vec3 step_t = stepsOf(at) * ray.inverse;
  vec3 offset = (at.origin - ray.origin) * ray.inverse;
  vec3 slack = slackOf(offset, step_t);
  vec3 in_offset = offset - slack, out_offset = offset + slack;
  bvec3 backward = lessThan(ray.inverse, vec3(0));
  uvec3 nearer = mix(at.low, at.high, backward), farther = mix(at.high, at.low, backward);
  vec4 enter = largestDistance(
      largestDistance(planes(nearer.x) * step_t.x + in_offset.x, planes(nearer.y) * step_t.y + in_offset.y),
      largestDistance(planes(nearer.z) * step_t.z + in_offset.z, vec4(t_min)));
  vec4 leave = smallestDistance(
      smallestDistance(planes(farther.x) * step_t.x + out_offset.x, planes(farther.y) * step_t.y + out_offset.y),
      smallestDistance(planes(farther.z) * step_t.z + out_offset.z, vec4(t_max)));
  return firstMet(at, node, enter, leave, others);
}

// True if a ray from `origin` (object space) meets the triangle from behind. Always false in scenes without one-sided
// materials.
bool isFromBack(vec3 origin, uint triangle) {
#if FACT_one_sided
  vec3 a = scene_bvh.triangles.at[triangle].corner[0];
  vec3 edge1 = scene_bvh.triangles.at[triangle].corner[1] - a, edge2 = scene_bvh.triangles.at[triangle].corner[2] - a;
  return dot(cross(edge1, edge2), origin - a) < 0.0;
#else
  return false;
#endif
}

// Level of a slice: number of the set of trees for the time of the slice. 0: raster time; from 1 on: sample times of a loop.
// The function matches levelOf of runtime/world/structures.h.
uint levelOf(uint slice) { return slice < SLICE_SAMPLE ? 0u : slice - SLICE_SAMPLE + 1u; }

// Root node of the tree over all instances at a level or, with `mask` = RAYS_TO_MOVING, of the tree over the moving instances.
uint rootOf(uint level, uint mask) {
  return scene_bvh.first_root + (2u * level + uint(mask == RAYS_TO_MOVING)) * scene_bvh.nodes_per_tree;
}

// Trace one ray, for the functions of mixin/trace.glsl. Slice, interval and skipped instance are as in `traceExcept`. `mask`:
// RAYS_TO_*. `any_hit`: return any hit in the interval (the first one found) instead of the nearest. `both_sides`: one-sided
// surfaces count from behind too. A miss has the instance NO_INSTANCE.
TraceResult launch(uint slice, uint mask, bool any_hit, bool both_sides, Ray world_ray, float t_min, float t_max,
                   uint skip_instance, uint skip_geometry) {
  TraceResult found = TraceResult(NO_INSTANCE, 0u, 0u, vec2(0), t_max);
  uint nearest = 0u;  // index of the nearest triangle so far
  uint level = levelOf(slice);
  uint reference = rootOf(level, mask);
  vec3 world_inverse =
      boundedInverse(world_ray.origin, world_ray.direction, scene_bvh.nodes.at[reference].reach);
  BvhRay ray = BvhRay(world_ray.origin, world_inverse, vec3(0), 0, false);
  if (mask >= RAYS_TO_ONE) reference = BVH_LEAF | (mask - RAYS_TO_ONE);
  uint instance = NO_INSTANCE;  // instance of the current mesh; NO_INSTANCE in the tree over instances
  BvhStack stack = noEntries();
  while (true) {
    // Descend to the next leaf.
    while (true) {
      if (reference == kNextOnStack) {
        if (top(stack) == kInstanceEnds) {
          drop(stack);
          instance = NO_INSTANCE;
          ray.origin = world_ray.origin;
          ray.inverse = world_inverse;
        }
        reference = takeFrom(stack);
      }
      if (reference >= BVH_LEAF) break;

      uint others;
      reference = nearestChild(reference, ray, t_min, found.t, others);
      push(stack, others, others != 0u);
    }
    if (reference == kNothingLeft) break;

    if (instance == NO_INSTANCE) {
      instance = reference & ~BVH_LEAF;
      ray = rayIn(level * frame.instance_count + instance, world_ray, reference);
      push(stack, kInstanceEnds, true);
      continue;
    }
    uint triangle = reference & ((1u << BVH_LEAF_COUNT) - 1u);
    uint end = triangle + ((reference >> BVH_LEAF_COUNT) & 3u) + 1u;
    do {
      uint geometry;
      vec3 meeting = meetTriangle(ray, triangle, geometry);
      float t = meeting.x;
      if (!(t > t_min) || t > found.t || t == t_max) continue;
      if (t == found.t && (instance > found.instance || (instance == found.instance && isBefore(nearest, triangle))))
        continue;
      bool needs_test = (geometry & BVH_OPAQUE) == 0u || instance == skip_instance;
      if (needs_test && !acceptsHit(instance, geometry & ~BVH_OPAQUE, scene_bvh.triangles.at[triangle].primitive, meeting.yz,
                              skip_instance, skip_geometry, !both_sides && isFromBack(ray.origin, triangle)))
        continue;
      found.instance = instance;
      found.barycentrics = meeting.yz;
      found.t = t;
      nearest = triangle;
    } while (++triangle < end);
    if (any_hit && found.instance != NO_INSTANCE) break;
    reference = kNextOnStack;
  }
  if (found.instance != NO_INSTANCE) {
    found.geometry = scene_bvh.triangles.at[nearest].geometry & ~BVH_OPAQUE;
    found.primitive = scene_bvh.triangles.at[nearest].primitive;
  }
  return found;
}
