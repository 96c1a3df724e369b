// SPDX-License-Identifier: MIT
// Needs: rays, scene; may have: PARAM_displacement.
// Visibility of one light from all surface points of a tile of pixels, without a ray for each point. The result is kVisible (no
// shadow ray is blocked), kBlocked (every shadow ray is blocked) or kMixed (unknown: the rays must be traced).
// Method: traverse the runtime's own tree (shared/bvh.h) with the volume that the rays sweep (Haines and Wallace, "Shaft
//   Culling for Efficient Ray-Cast Radiosity", 1991). All bounds are widened by more than the rounding errors of rays and
//   triangles, so kVisible and kBlocked agree with every traced ray.
// Fails: always kMixed with the drivers' acceleration structures, which shaders cannot traverse by a volume.
#ifndef STROBE_LIGHT_VISIBILITY_GLSL
#define STROBE_LIGHT_VISIBILITY_GLSL
#include "mixin/trace.glsl"

const uint kMixed = 0u, kVisible = 1u, kBlocked = 2u;

// Origins of a tile's shadow rays. They lie in the box `centre` +- `extent`. Each origin is at least `raised` above one of the
// planes `start_planes`, and the light is above this plane too.
struct RayVolumeStart {
  vec3 centre, extent;  // world space, metres
  vec3 one;             // point at the origin of one ray; it only selects the triangles that the first walk tests
  uint plane_count;     // number of planes in start_planes; 0: the planes are unknown
  uint unused_planes;   // bit i is set if no ray to the light starts above plane i
  float raised;         // metres
};
// Planes below the origins of the shadow rays, one for each direction that surfaces of the tile face. On five scenes, half or
// twice as many change the number of shadow rays by at most 0.5 %.
const uint kMostStartPlanes = 12u;
vec4 start_planes[kMostStartPlanes];  // xyz: unit normal n; w: least dot(n, p) over the plane's surface points p

#ifdef STROBE_STRUCTURES_OWN

// Nodes that one traversal may visit; after more, the result is kMixed. On five scenes, half or twice as many change the number
// of shadow rays by at most 0.9 %.
const int kMaxVolumeNodes = 64;
// Bound of the rounding errors of coordinates that are transformed to another space, as a share of the largest coordinate.
const float kRounding = 1.0 / 1048576.0;

// Volume of the rays between a box and a light, in the space of a tree (world space for the tree over instances, object space
// for the tree of a mesh). At the parameter u, from 0 to `u_end`, the volume is the box between the corners from_low + u *
// to_low and from_high + u * to_high. u = 0 is at the light if the light has a position. For a directional light, u = 0 is at
// the box of origins.
struct RayVolume {
  vec3 from_low, from_high;
  vec3 low_inverse, high_inverse;  // 1 / to_low, 1 / to_high, bounded
  float u_end;
};

// Bounds for a product m * v: upper bounds of the magnitudes of its components, if the components of v have magnitudes of at
// most `sizes`.
vec3 ofSizes(mat3 m, vec3 sizes) { return mat3(abs(m[0]), abs(m[1]), abs(m[2])) * sizes; }

// Volume of the rays between the box `centre` +- `extent` (world space) and a light. `light`: position (w = 1) or
// direction towards the light (w = 0), world space. `space`: transform from world space to the space of the tree.
// `reach`: upper bound of the coordinates of the bounding planes of the tree's nodes, in the space of the tree. `size`:
// upper bound of the coordinates of the box and the light, in world space.
RayVolume volumeIn(mat4x3 space, float reach, vec3 centre, vec3 extent, vec4 light, float size) {
  mat3 turned = mat3(space);
  vec3 slack = kRounding * (ofSizes(turned, vec3(size)) + abs(space[3]) + reach);
  vec3 middle = space * vec4(centre, 1), around = ofSizes(turned, extent) + slack, towards = space * light;
  RayVolume volume;
  vec3 to_low, to_high;
  if (light.w != 0.0) {
    volume.from_low = towards - slack;
    volume.from_high = towards + slack;
    to_low = middle - around - volume.from_low;
    to_high = middle + around - volume.from_high;
    volume.u_end = 1.0;
  } else {
    volume.from_low = middle - around;
    volume.from_high = middle + around;
    slack = kRounding * ofSizes(turned, abs(light.xyz));
    to_low = towards - slack;
    to_high = towards + slack;
    volume.u_end = 3.0e38;
  }
  volume.low_inverse = boundedInverse(volume.from_low, to_low, reach);
  volume.high_inverse = boundedInverse(volume.from_high, to_high, reach);
  return volume;
}

// Child of a node that the volume meets first (at the least u); kNextOnStack if the volume meets no child. `others`: output,
// stack entry of the other children that the volume meets, or 0 (`firstMet` in mixin/trace_bvh.glsl).
uint firstChild(uint node, RayVolume volume, out uint others) {
  BvhNode at = loadedNode(node);
  vec3 step_size = stepsOf(at);
  vec3 low_step = step_size * volume.low_inverse, high_step = step_size * volume.high_inverse;
  vec3 low_offset = (at.origin - volume.from_low) * volume.low_inverse;
  vec3 high_offset = (at.origin - volume.from_high) * volume.high_inverse;
  vec3 low_slack = slackOf(low_offset, low_step), high_slack = slackOf(high_offset, high_step);
  vec4 enter = vec4(0), leave = vec4(volume.u_end);
  for (int axis = 0; axis < 3; ++axis) {
    // The volume meets a child if the volume's lower bound is below the child's upper plane and the volume's upper bound is
    // above the child's lower plane.
    vec4 lower = planes(at.high[axis]) * low_step[axis] + low_offset[axis];
    vec4 upper = planes(at.low[axis]) * high_step[axis] + high_offset[axis];
    if (volume.low_inverse[axis] < 0.0) enter = max(enter, lower - low_slack[axis]);
    else leave = min(leave, lower + low_slack[axis]);
    if (volume.high_inverse[axis] < 0.0) leave = min(leave, upper + high_slack[axis]);
    else enter = max(enter, upper - high_slack[axis]);
  }
  return firstMet(at, node, enter, leave, others);
}

// Effects of a triangle on the shadow rays of a tile:
// kStopsNone: the triangle blocks no ray.
// kStopsSome: the triangle may block some rays.
// kStopsAll: the triangle blocks all rays.
// kStopsInside: rays may pass on both sides of one edge, and the triangle blocks all rays on the inner side of this edge. Two
// such triangles with a common edge together may block all rays. The value is kStopsInside plus the number i of the edge (0 to
// 2; edge i starts at corner i), plus 4 if the corners are in clockwise order as seen from the light.
const uint kStopsNone = 0u, kStopsSome = 1u, kStopsAll = 2u, kStopsInside = 3u;

// Effect of a triangle on the rays from `start` to `light`, one of kStops*. `light`: position (w = 1) or direction towards the
// light (w = 0). `corner`: corners in world space. `rounding`: bound of the rounding errors of the coordinates of rays and
// corners.
uint stops(RayVolumeStart start, vec4 light, vec3 corner[3], float rounding) {
  // Each ray starts above one of the planes `start_planes` and stays above this plane. So a triangle below all these planes
  // blocks no ray.
  bool is_below = start.plane_count > 0u;
  for (uint i = 0u; i < start.plane_count && is_below; ++i) {
    vec3 n = start_planes[i].xyz;
    float highest = max(dot(n, corner[0]), max(dot(n, corner[1]), dot(n, corner[2])));
    is_below = (start.unused_planes >> i & 1u) != 0u || highest < start_planes[i].w + start.raised - rounding;
  }
  if (is_below) return kStopsNone;

  vec3 edge1 = corner[1] - corner[0], edge2 = corner[2] - corner[0];
  vec3 here = start.centre - corner[0], towards = light.xyz - light.w * corner[0];
  vec3 sizes = max(abs(edge1), abs(edge2));
  float edge = max(sizes.x, max(sizes.y, sizes.z));
  sizes = abs(here) + start.extent;
  float away = max(sizes.x, max(sizes.y, sizes.z)) + edge;
  float far = max(abs(towards.x), max(abs(towards.y), abs(towards.z))) + edge;

  // Test if the triangle's plane is between the light and the origins. The effect is unknown if the light is nearly in this
  // plane.
  vec3 normal = cross(edge1, edge2);
  float slack = 8.0 * rounding * edge * (edge + max(away, far));
  float light_side = dot(normal, towards), start_side = dot(normal, here), wide = dot(abs(normal), start.extent);
  float facing = light_side < 0.0 ? -1.0 : 1.0;
  if (!(abs(light_side) > slack)) return kStopsSome;
  if (facing * start_side - wide > slack) return kStopsNone;
  bool between = facing * start_side + wide < -slack;

  // Each edge and the light define a plane. If all origins are on the inner sides of all three planes, the triangle hides the
  // light from all origins.
  slack = 8.0 * rounding * (edge * away + edge * far + away * far);
  uint open = 0u, open_edge = 0u;
  for (uint i = 0u; i < 3u; ++i) {
    vec3 from = corner[i];
    normal = cross(corner[(i + 1u) % 3u] - from, light.xyz - light.w * from);
    float inside = -facing * dot(normal, start.centre - from);
    wide = dot(abs(normal), start.extent);
    if (inside + wide < -slack) return kStopsNone;
    if (inside - wide > slack) continue;
    ++open;
    open_edge = i;
  }
  if (!between || open > 1u) return kStopsSome;
  return open == 0u ? kStopsAll : kStopsInside + open_edge + (facing < 0.0 ? 4u : 0u);
}

// True if every hit on the geometry counts, because its material has no alpha that cuts holes into it. `geometry`: member of
// BvhTriangle.
bool isSolid(uint instance, uint geometry) {
  if ((geometry & BVH_OPAQUE) != 0u) return true;
#if FACT_alpha
  uint flags = scene_materials[geometryOf(instance, geometry).material].flags;
  return (flags & (MATERIAL_ALPHA_MASK | MATERIAL_ALPHA_BLEND)) == 0u;
#else
  return true;
#endif
}

// Transform from its three rows.
mat4x3 columnsOf(vec4 x, vec4 y, vec4 z) { return transpose(mat3x4(x, y, z)); }

// Visibility of the light from all origins: kVisible, kBlocked or kMixed. `light`: position (w = 1), or direction towards the
// light with the length `reach` (w = 0); world space. `reach`: upper bound of the coordinates of origins and light, and of the
// distances between them, metres.
// Method: the rays from all origins to the light fill a volume. The first walk over the tree follows one of these rays.
//   It searches for a triangle that blocks all rays, or for two triangles with a common edge that together block all
//   rays: one of them also blocks the followed ray, so the walk meets it. If there are none, the second walk visits all
//   triangles in the volume. The result is kMixed if one of them may block a ray, otherwise kVisible. The result is
//   also kMixed if a walk visits more than kMaxVolumeNodes nodes.
uint visibilityOf(uint slice, RayVolumeStart start, vec4 light, float reach) {
  uint level = levelOf(slice), root = rootOf(level, RAYS_TO_ALL);
  for (uint walk = 0u; walk < 2u; ++walk) {
    bool along_one = walk == 0u;
    vec3 centre = along_one ? start.one : start.centre, extent = along_one ? vec3(0) : start.extent;
    RayVolume world = volumeIn(mat4x3(1.0), scene_bvh.nodes.at[root].reach, centre, extent, light, reach);
    RayVolume volume = world;
    uint instance = NO_INSTANCE, reference = root;
    mat4x3 world_from_object;
    vec3 object_sizes;
    vec3 open_from, open_to;  // edge of a triangle that blocks all rays on the inner side of this edge
    uint open_instance = NO_INSTANCE;
    BvhStack stack = noEntries();
    int visited = 0;
    while (true) {
      // Descend to the next leaf.
      while (true) {
        if (reference == kNextOnStack) {
          if (top(stack) == kInstanceEnds) {
            drop(stack);
            instance = NO_INSTANCE;
            volume = world;
          }
          reference = takeFrom(stack);
        }
        if (reference >= BVH_LEAF) break;
        if (++visited > kMaxVolumeNodes) return kMixed;
        uint others;
        reference = firstChild(reference, volume, others);
        push(stack, others, others != 0u);
      }
      if (reference == kNothingLeft) break;

      if (instance == NO_INSTANCE) {
        instance = reference & ~BVH_LEAF;
        BvhInstance of = loadedInstance(level * frame.instance_count + instance);
        SceneTransform m = transformOf(slice, instance);
        mat4x3 object_from_world = columnsOf(of.row_x, of.row_y, of.row_z);
        world_from_object = columnsOf(m.row_x, m.row_y, m.row_z);
        object_sizes = ofSizes(mat3(object_from_world), vec3(reach)) + abs(object_from_world[3]);
        volume = volumeIn(object_from_world, of.reach, centre, extent, light, reach);
        reference = of.root;
        push(stack, kInstanceEnds, true);
        continue;
      }
      uint triangle = reference & ((1u << BVH_LEAF_COUNT) - 1u);
      uint end = triangle + ((reference >> BVH_LEAF_COUNT) & 3u) + 1u;
      for (; triangle < end; ++triangle) {
        BvhTriangle of = loadedTriangle(triangle);
        vec3 corner[3];
        vec3 sizes = object_sizes;
        for (int i = 0; i < 3; ++i) {
          corner[i] = world_from_object * vec4(of.corner[i], 1);
          sizes = max(sizes, abs(of.corner[i]));
        }
        sizes = ofSizes(mat3(world_from_object), sizes) + abs(world_from_object[3]);
        uint stopping = stops(start, light, corner, kRounding * max(sizes.x, max(sizes.y, sizes.z)));
        if (stopping == kStopsNone) continue;
        if (!along_one) return kMixed;
        if (stopping == kStopsSome || !isSolid(instance, of.geometry)) continue;
        if (stopping == kStopsAll) return kBlocked;
        uint edge = (stopping - kStopsInside) & 3u, next = (edge + 1u) % 3u;
        bool turned = stopping - kStopsInside > 3u;
        vec3 from = corner[turned ? next : edge], to = corner[turned ? edge : next];
        if (open_instance == instance && from == open_to && to == open_from) return kBlocked;
        open_instance = instance;
        open_from = from;
        open_to = to;
      }
      reference = kNextOnStack;
    }
  }
  return kVisible;
}

#else

// Without the runtime's own tree (backends with the driver's acceleration structures), the visibility is unknown: kMixed.
uint visibilityOf(uint slice, RayVolumeStart start, vec4 light, float reach) { return kMixed; }

#endif
#endif
