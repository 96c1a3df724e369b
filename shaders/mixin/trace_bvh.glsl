// SPDX-License-Identifier: MIT
// Needs: rays.
// Tracing backend `bvh`: the runtime's own tree (shared/bvh.h), walked in compute. Of hits at one distance the first in
// the scene counts: by instance, then geometry, then triangle.
// Triangles: Woop, Benthin, Wald, "Watertight Ray/Triangle Intersection" (JCGT 2013), at twice the precision where the
// device has it.

#ifdef STROBE_DOUBLES
#define BVH_FLOAT double
#define BVH_VEC2 dvec2
#else
#define BVH_FLOAT float
#define BVH_VEC2 vec2
#endif

const uint kNextOnStack = 0xfffffffeu, kNothingLeft = 0xffffffffu;

// What triangles are met with: component `longest` of the direction is its largest, `shear` leads there; `mirrored` keeps
// the winding.
struct Sheared {
  vec3 shear;
  int longest;
  bool mirrored;
};

vec3 alongLongest(Sheared ray, vec3 v) {
  vec3 turned = ray.longest == 0 ? v.yzx : ray.longest == 1 ? v.zxy : v;
  return ray.mirrored ? turned.yxz : turned;
}

Sheared sheared(vec3 direction) {
  vec3 size = abs(direction);
  Sheared ray = Sheared(vec3(0), 0, false);
  ray.longest = size.x >= size.y ? (size.x >= size.z ? 0 : 2) : (size.y >= size.z ? 1 : 2);
  ray.mirrored = (ray.longest == 0 ? direction.x : ray.longest == 1 ? direction.y : direction.z) < 0.0;
  vec3 along = alongLongest(ray, direction);
  ray.shear = vec3(along.x, along.y, 1.0) * (1.0 / along.z);
  return ray;
}

// Bounded, so that no plane is at infinity times zero.
vec3 boundedInverse(vec3 direction) {
  vec3 bounded = max(abs(direction), vec3(1e-18));
  return mix(1.0 / bounded, -1.0 / bounded, lessThan(direction, vec3(0)));
}

// Distance and weights of the second and third corner; a negative distance is a miss.
vec3 meetTriangle(vec3 origin, Sheared ray, uint triangle) {
  vec3 a = alongLongest(ray, scene_bvh.triangles.at[triangle].corner[0] - origin);
  vec3 b = alongLongest(ray, scene_bvh.triangles.at[triangle].corner[1] - origin);
  vec3 c = alongLongest(ray, scene_bvh.triangles.at[triangle].corner[2] - origin);
  BVH_VEC2 p = BVH_VEC2(a.xy - ray.shear.xy * a.z);
  BVH_VEC2 q = BVH_VEC2(b.xy - ray.shear.xy * b.z);
  BVH_VEC2 r = BVH_VEC2(c.xy - ray.shear.xy * c.z);
  BVH_FLOAT u = r.x * q.y - r.y * q.x;
  BVH_FLOAT v = p.x * r.y - p.y * r.x;
  BVH_FLOAT w = q.x * p.y - q.y * p.x;
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

// Is the first of two triangles of one instance before the other in the scene?
bool isBefore(uint triangle, uint other) {
  uint geometry = scene_bvh.triangles.at[triangle].geometry, other_geometry = scene_bvh.triangles.at[other].geometry;
  if (geometry != other_geometry) return (geometry & ~BVH_OPAQUE) < (other_geometry & ~BVH_OPAQUE);
  return scene_bvh.triangles.at[triangle].primitive < scene_bvh.triangles.at[other].primitive;
}

// One plane of each of four children, in steps. Through signed integers: processors convert no others at once.
vec4 planes(uint bytes) { return vec4(ivec4((uvec4(bytes) >> uvec4(0, 8, 16, 24)) & 255u)); }

// The nearest child of a node that the ray meets from t_min to t_max, kNextOnStack without any. `others`: an entry of the
// stack for the others that it meets: the node, their numbers, nearest first, 2 bits each; how many. 0: there are none.
uint nearestChild(uint node, vec3 origin, vec3 inverse, float t_min, float t_max, out uint others) {
  uint steps = scene_bvh.nodes.at[node].steps;
  uvec3 low = scene_bvh.nodes.at[node].low, high = scene_bvh.nodes.at[node].high;
  vec3 step_t = uintBitsToFloat((uvec3(steps) << uvec3(23, 15, 7)) & 0x7f800000u) * inverse;
  vec3 offset = (scene_bvh.nodes.at[node].origin - origin) * inverse;
  vec3 slack = (abs(offset) + 255.0 * abs(step_t)) * (1.0 / 1048576.0);  // what rounding may take away
  vec3 in_offset = offset - slack, out_offset = offset + slack;
  bvec3 backward = lessThan(inverse, vec3(0));
  uvec3 nearer = mix(low, high, backward), farther = mix(high, low, backward);
  vec4 enter = max(max(planes(nearer.x) * step_t.x + in_offset.x, planes(nearer.y) * step_t.y + in_offset.y),
                   max(planes(nearer.z) * step_t.z + in_offset.z, vec4(t_min)));
  vec4 leave = min(min(planes(farther.x) * step_t.x + out_offset.x, planes(farther.y) * step_t.y + out_offset.y),
                   min(planes(farther.z) * step_t.z + out_offset.z, vec4(t_max)));
  uvec4 met = uvec4(lessThanEqual(enter, leave)) & uvec4(lessThan(uvec4(0, 1, 2, 3), uvec4(steps >> 24)));
  // Distances with the child in their last bits, sorted; children that are missed come last.
  uvec4 keys = (floatBitsToUint(enter) & ~3u) | uvec4(0, 1, 2, 3) | (met - 1u);
  uvec2 first = min(keys.xz, keys.yw), second = max(keys.xz, keys.yw);
  uint k0 = min(first.x, first.y), k3 = max(second.x, second.y);
  uint m0 = max(first.x, first.y), m1 = min(second.x, second.y);
  uint k1 = min(m0, m1), k2 = max(m0, m1);
  uint hits = met.x + met.y + met.z + met.w;
  others = 0u;
  if (hits > 1u) others = (node << 8) | ((k1 & 3u) << 2) | ((k2 & 3u) << 4) | ((k3 & 3u) << 6) | (hits - 1u);
  if (hits == 0u) return kNextOnStack;
  return scene_bvh.nodes.at[node].children[k0 & 3u];
}

// Does a ray from `origin`, in object space, meet the triangle from behind, where that matters?
bool isFromBehind(vec3 origin, uint triangle) {
#if FACT_one_sided
  vec3 a = scene_bvh.triangles.at[triangle].corner[0];
  vec3 edge1 = scene_bvh.triangles.at[triangle].corner[1] - a, edge2 = scene_bvh.triangles.at[triangle].corner[2] - a;
  return dot(cross(edge1, edge2), origin - a) < 0.0;
#else
  return false;
#endif
}

// As traceExcept of mixin/trace.glsl; `any_hit`: the first that is found; `both_sides`: of whatever is met from behind.
TraceResult launch(uint slice, bool any_hit, bool both_sides, Ray world_ray, float t_min, float t_max,
                   uint skip_instance, uint skip_geometry) {
  TraceResult found = TraceResult(NO_INSTANCE, 0u, 0u, vec2(0), t_max);
  uint nearest = 0u;  // triangle
  uint level = slice < SLICE_SAMPLE ? 0u : slice - SLICE_SAMPLE + 1u;  // levelOf of runtime/world/structures.h
  // Of the tree that the ray is in.
  vec3 world_inverse = boundedInverse(world_ray.direction);
  vec3 origin = world_ray.origin, inverse = world_inverse;
  Sheared ray = Sheared(vec3(0), 0, false);
  uint instance = NO_INSTANCE;  // of the tree that the ray is in; NO_INSTANCE: the tree over instances
  uint stack[BVH_MESH_DEPTH + BVH_TOP_DEPTH];
  int top = 0, bottom = 0;  // of the stack, and where the entries of the tree that the ray is in begin
  uint reference = scene_bvh.first_root + level * scene_bvh.nodes_per_level;
  while (true) {
    // To the next leaf.
    while (true) {
      if (reference == kNextOnStack && top == bottom) {
        if (instance != NO_INSTANCE) {
          instance = NO_INSTANCE;
          origin = world_ray.origin;
          inverse = world_inverse;
          bottom = 0;
        }
        if (top == 0) reference = kNothingLeft;
      }
      if (reference == kNextOnStack) {
        uint entry = stack[top - 1];
        reference = scene_bvh.nodes.at[entry >> 8].children[(entry >> 2) & 3u];
        if ((entry & 3u) == 1u) --top;
        else stack[top - 1] = (entry & 0xffffff00u) | ((entry >> 2) & 0x3cu) | ((entry & 3u) - 1u);
      }
      if (reference >= BVH_LEAF) break;

      uint others = 0u;
      reference = nearestChild(reference, origin, inverse, t_min, found.t, others);
      if (others != 0u) stack[top++] = others;
    }
    if (reference == kNothingLeft) break;

    if (instance == NO_INSTANCE) {
      instance = reference & ~BVH_LEAF;
      uint at = level * frame.instance_count + instance;
      vec4 x = scene_bvh.instances.at[at].row_x, y = scene_bvh.instances.at[at].row_y;
      vec4 z = scene_bvh.instances.at[at].row_z;
      vec4 start = vec4(world_ray.origin, 1);
      origin = vec3(dot(x, start), dot(y, start), dot(z, start));
      vec3 direction = vec3(dot(x.xyz, world_ray.direction), dot(y.xyz, world_ray.direction),
                            dot(z.xyz, world_ray.direction));
      inverse = boundedInverse(direction);
      ray = sheared(direction);
      bottom = top;
      reference = scene_bvh.instances.at[at].root;
      continue;
    }
    uint triangle = reference & ((1u << BVH_LEAF_COUNT) - 1u);
    uint end = triangle + ((reference >> BVH_LEAF_COUNT) & 3u) + 1u;
    for (; triangle < end; ++triangle) {
      vec3 meeting = meetTriangle(origin, ray, triangle);
      float t = meeting.x;
      if (!(t > t_min) || t > found.t || t == t_max) continue;
      if (t == found.t && (instance > found.instance || (instance == found.instance && isBefore(nearest, triangle))))
        continue;
      uint geometry = scene_bvh.triangles.at[triangle].geometry;
      bool asks = (geometry & BVH_OPAQUE) == 0u || instance == skip_instance;
      if (asks && !acceptsHit(instance, geometry & ~BVH_OPAQUE, scene_bvh.triangles.at[triangle].primitive, meeting.yz,
                              skip_instance, skip_geometry, !both_sides && isFromBehind(origin, triangle)))
        continue;
      found.instance = instance;
      found.barycentrics = meeting.yz;
      found.t = t;
      nearest = triangle;
    }
    if (any_hit && found.instance != NO_INSTANCE) break;
    reference = kNextOnStack;
  }
  if (found.instance != NO_INSTANCE) {
    found.geometry = scene_bvh.triangles.at[nearest].geometry & ~BVH_OPAQUE;
    found.primitive = scene_bvh.triangles.at[nearest].primitive;
  }
  return found;
}
