// SPDX-License-Identifier: MIT
// Needs: scene.
// Payload of a ray between the stages of the ray tracing pipeline, and the test of hits that all backends share. The
// test rejects hits on skipped instances, on points that alpha cuts out, and on the backs of one-sided materials. The
// rasteriser also rejects points that alpha cuts out, and the backs of one-sided materials.
#ifndef STROBE_TRACE_PAYLOAD_GLSL
#define STROBE_TRACE_PAYLOAD_GLSL
#include "lib/random.glsl"
#include "mixin/vertex.glsl"

// Data that the stages of the ray tracing pipeline exchange. The first five members are the hit; the last two are the instance
// and geometry that the ray skips.
struct TracePayload {
  uint instance, geometry, primitive;
  vec2 barycentrics;
  float t;
  uint skip_instance, skip_geometry;
};

// Texture coordinates for a texture slot: the coordinate set that the slot uses, after the slot's transform.
vec2 transformedUv(SceneTextureUse use, vec2 uv0, vec2 uv1) {
  vec2 uv = use.uv_set == 0u ? uv0 : uv1;
  return use.u * uv.x + use.v * uv.y + use.offset;
}

#if FACT_blend
// Alpha threshold, in (0, 1), at a point of an instance with a blended material: points with a lower alpha are cut out (Wyman
// and McGuire, "Hashed Alpha Testing", I3D 2017). `position_os`: position of the point in object space at the raster time.
// The threshold is a hash of small cubes of object space; 16 to 32 cubes span the side of a pixel at the raster time. A surface
// point therefore has one threshold at all times and for all rays, and samples within a pixel get different thresholds.
float blendThreshold(uint instance, uint geometry, vec3 position_os) {
  SceneTransform m = transformOf(SLICE_RASTER, instance);
  SceneCamera camera = scene_cameras[SLICE_RASTER];
  vec4 p = vec4(position_os, 1);
  vec3 position_ws = vec3(dot(m.row_x, p), dot(m.row_y, p), dot(m.row_z, p));
  float size = length(vec3(length(m.row_x.xyz), length(m.row_y.xyz), length(m.row_z.xyz))) * 0.57735027;
  float depth = camera.orthographic != 0u ? 1.0 : max(dot(position_ws - camera.position, camera.forward), camera.near);
  float pixel_os = 2.0 * camera.half_extent.y / float(frame.size.y) * depth / max(size, 1e-30);
  uvec3 cell = floatBitsToUint(floor(position_os * exp2(4.0 - floor(log2(pixel_os))) + 0.37) + 0.5);
  uint number = pcgHash(cell.x ^ pcgHash(cell.y ^ pcgHash(cell.z ^ pcgHash(instance ^ pcgHash(geometry ^ frame.seed)))));
  return (float(number >> 8u) + 0.5) * (1.0 / 16777216.0);
}
#endif

// Alpha threshold at a point of a material with MATERIAL_ALPHA_MASK or MATERIAL_ALPHA_BLEND: points with a lower alpha are cut
// out. `position_os`: as in `blendThreshold`.
float leastAlpha(SceneMaterial material, uint instance, uint geometry, vec3 position_os) {
#if FACT_blend
  if ((material.flags & MATERIAL_ALPHA_BLEND) != 0u) return blendThreshold(instance, geometry, position_os);
#endif
  return material.alpha_cutoff;
}

// True if alpha cuts out a point of a triangle. The texture is read at full resolution, without mip levels, so that raster and
// rays agree.
bool isCutOut(uint instance, uint geometry_index, uint primitive, vec2 barycentrics) {
  SceneGeometry geometry = geometryOf(instance, geometry_index);
  SceneMaterial material = scene_materials[geometry.material];
  if ((material.flags & (MATERIAL_ALPHA_MASK | MATERIAL_ALPHA_BLEND)) == 0u) return false;
  vec3 weights = vec3(1.0 - barycentrics.x - barycentrics.y, barycentrics);
  vec2 uv0 = vec2(0), uv1 = vec2(0);
  vec3 position_os = vec3(0);
  float alpha = 0.0;
  for (uint corner = 0u; corner < 3u; ++corner) {
    uint vertex = vertexOf(geometry, primitive, corner);
#if FACT_blend
    position_os += weights[corner] * vertexPosition(SLICE_RASTER, vertex);
#endif
    uv0 += weights[corner] * vertexUv0(vertex);
    uv1 += weights[corner] * vertexUv1(vertex);
    alpha += weights[corner] * vertexColor(vertex).a;
  }
  alpha *= material.base_color.a;
  int texture_index = material.uses[USE_BASE_COLOR].texture;
  if (texture_index >= 0) {
    vec2 uv = transformedUv(material.uses[USE_BASE_COLOR], uv0, uv1);
    alpha *= textureLod(scene_textures[nonuniformEXT(texture_index)], uv, 0.0).a;
  }
  return alpha < leastAlpha(material, instance, geometry_index, position_os);
}

// True if the material of the geometry is one-sided.
bool isOneSided(uint instance, uint geometry_index) {
  SceneGeometry geometry = geometryOf(instance, geometry_index);
  return (scene_materials[geometry.material].flags & MATERIAL_ONE_SIDED) != 0u;
}

// True if a ray accepts a hit. A hit is rejected if it is on the skipped instance or geometry, if alpha cuts the point
// out, or if it is on the back of a one-sided material. `is_back_face`: true if the ray meets the triangle from behind.
// For shadow rays, which hit both sides of every surface, it is always false.
bool acceptsHit(uint instance, uint geometry, uint primitive, vec2 barycentrics, uint skip_instance, uint skip_geometry,
                bool is_back_face) {
  bool skipped = instance == skip_instance && (skip_geometry == NO_INSTANCE || geometry == skip_geometry);
#if FACT_one_sided
  if (is_back_face && isOneSided(instance, geometry)) return false;
#endif
#if FACT_alpha
  return !skipped && !isCutOut(instance, geometry, primitive, barycentrics);
#else
  return !skipped;
#endif
}

#endif
