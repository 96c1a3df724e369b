// SPDX-License-Identifier: MIT
// Per tile, the lights that are visible from all its surface points, and the lights that are blocked from all these points.
// `shade` traces no shadow rays to these lights (Haines and Wallace 1991, "Shaft Culling for Efficient Ray-Cast Radiosity").
// In:  `hit`: visible surface: instance + 1 (0 for the sky), geometry, primitive.
// Out: `light_visibility`: one bit for each of the first 32 lights. x: bit i is set if light i is visible from the whole tile.
//        y: bit i is set if light i is blocked from the whole tile.
// Method: bound the origins of the tile's shadow rays by a box and by planes, one plane for each direction that surfaces of the
//   tile face; the origins are above their planes. Walk the runtime's tree with the volume between these bounds and the light
//   (mixin/light_visibility.glsl). Tiles at the right and bottom border may be partial.
// Fails: never gives a wrong bit: if the walk is undecided, both bits are 0, and shadow rays are traced. With backends other
//   than `bvh`, whose trees shaders cannot walk, no bit is set.
#include "mixin/shade.glsl"
#include "mixin/light_visibility.glsl"

// Largest coordinate or distance of origins and lights, m. Products of three, up to 1e36, stay below the largest float, 3.4e38.
const float kFarthest = 1e12;
// Cosine and sine of 1.8 degrees. Surfaces share a plane if their normals are at most this angle apart.
const float kSameFacing = 0.9995, kMostTurned = 0.0316;
const uint kMostBits = 32u;

float largest(vec3 v) { return max(v.x, max(v.y, v.z)); }

// Bounds of the surface points of a tile, world space. `any`: true if the tile shows a surface. `low`, `high`: box of the
// points. `one`: one of the points, if possible at the centre of the tile. `has_planes`: false if the surfaces face more
// directions than the list `start_planes` has room for.
struct TileHits {
  bool any, has_planes;
  vec3 low, high, one;
  float near;  // least value, over all points, of a point's largest absolute coordinate
  uint plane_count;
};

// Index of the plane for surfaces with this normal: the first plane of the list with a normal within kSameFacing, or a new
// plane. If the list is full, `has_planes` becomes false.
uint planeOf(inout TileHits hits, vec3 normal_ws) {
  uint i = 0u;
  while (i < hits.plane_count && dot(start_planes[i].xyz, normal_ws) < kSameFacing) ++i;
  if (i == kMostStartPlanes) {
    hits.has_planes = false;
    return 0u;
  }
  if (i == hits.plane_count) start_planes[hits.plane_count++] = vec4(normal_ws, 3e38);
  return i;
}

// Bounds of the surface points at the pixels from `first` to `end` (exclusive).
TileHits hitsIn(ivec2 first, ivec2 end) {
  TileHits hits = TileHits(false, true, vec3(3e38), vec3(-3e38), vec3(0), 3e38, 0u);
  uint current = 0u;
  vec4 plane = vec4(0);  // working copy of plane `current`; points are added to the copy
  for (int y = first.y; y < end.y; ++y) {
    for (int x = first.x; x < end.x; ++x) {
      uvec4 hit = texelFetch(hit_tex, ivec2(x, y), 0);
      if (hit.x == 0u) continue;
      Ray ray = cameraRay(SLICE_RASTER, samplePosition(ivec2(x, y)));
      Surface surface = surfaceOf(SLICE_RASTER, hitOnTriangle(SLICE_RASTER, ray, hit.x - 1u, hit.y, hit.z));
      vec3 point = surface.position_ws;
      if (!hits.any || ivec2(x, y) == (first + end) / 2) hits.one = point;
      hits.low = min(hits.low, point);
      hits.high = max(hits.high, point);
      hits.near = min(hits.near, largest(abs(point)));
      if (!(dot(plane.xyz, surface.face_normal_ws) >= kSameFacing)) {
        if (hits.any) start_planes[current].w = plane.w;
        current = planeOf(hits, surface.face_normal_ws);
        plane = start_planes[current];
      }
      plane.w = min(plane.w, dot(plane.xyz, point));
      hits.any = true;
    }
  }
  if (hits.any) start_planes[current].w = plane.w;
  return hits;
}

// Common result of all shadow rays from the tile to a light: kVisible (all reach the light), kBlocked (none does), or kMixed
// (unknown). Also kMixed if all surfaces face away from the light: `shade` traces no ray then, so that a bit would save
// nothing.
uint visibilityTowards(TileHits hits, SceneLight light) {
  bool has_position = light.type != LIGHT_DIRECTIONAL;
  vec3 centre = 0.5 * (hits.low + hits.high), extent = 0.5 * (hits.high - hits.low);
  vec3 away = abs(light.position - centre);
  float reach = largest(max(abs(hits.low), abs(hits.high)));
  if (has_position) reach = max(max(reach, largest(abs(light.position))), length(away + extent));
  if (!(reach < kFarthest)) return kMixed;
  vec4 at = has_position ? vec4(light.position, 1) : vec4(-light.direction * reach, 0);

  // `shadowOrigin` starts a shadow ray above the surface, at a height of kShadowLift times the larger of two lengths:
  // the largest coordinate of the surface point, and the distance of the light. The bounds must contain these origins.
  // The box is therefore enlarged by 2 % more than the largest height. Each plane is raised by 10 % less than the least
  // height. The normals of one plane differ by up to 1.8 degrees, which lowers an origin above the plane by 0.05 %; the
  // rest of the margins covers rounding.
  float least = max(hits.near, has_position ? length(max(away - extent, vec3(0))) : 0.0);
  RayVolumeStart start = RayVolumeStart(centre, extent + reach * (1.02 * kShadowLift), hits.one, hits.plane_count, 0u,
                                0.9 * kShadowLift * least);
  bool is_lit = !hits.has_planes;
  for (uint i = 0u; i < hits.plane_count; ++i) {
    float height = dot(start_planes[i].xyz, at.xyz) - at.w * start_planes[i].w;
    bool turned_away = height < -1.1 * kMostTurned * reach;
    if (turned_away) start.unused_planes |= 1u << i;
    else if (!(height > start.raised)) start.plane_count = 0u;
    is_lit = is_lit || !turned_away;
  }
  if (!hits.has_planes) start.plane_count = 0u;
  return is_lit ? visibilityOf(SLICE_RASTER, start, at, reach) : kMixed;
}

void run(ivec2 tile) {
  uvec2 light_visibility = uvec2(0);
#if PARAM_per_tile && defined(STROBE_STRUCTURES_OWN)
  ivec2 first = tile * params.shadow_tile;
  TileHits hits = hitsIn(first, min(first + params.shadow_tile, textureSize(hit_tex, 0)));
  uvec3 counts = uvec3(0);
  for (uint i = 0u; i < min(frame.light_count, kMostBits) && hits.any; ++i) {
    SceneLight light = scene_lights[SLICE_RASTER * frame.light_count + i];
    if (light.shadow == 0u) continue;
    uint visibility = visibilityTowards(hits, light);
    light_visibility |= uvec2(visibility == kVisible ? 1u << i : 0u, visibility == kBlocked ? 1u << i : 0u);
    ++counts[visibility];
  }
  if (counts[kVisible] > 0u) count_visible_lights(counts[kVisible]);
  if (counts[kBlocked] > 0u) count_blocked_lights(counts[kBlocked]);
#endif
  imageStore(light_visibility_img, tile, uvec4(light_visibility, 0u, 0u));
}
