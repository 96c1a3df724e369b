// SPDX-License-Identifier: MIT
// Needs: scene.
// What a ray carries between the stages of the ray tracing pipeline, and which hits it accepts in every backend.
#ifndef STROBE_TRACE_PAYLOAD_GLSL
#define STROBE_TRACE_PAYLOAD_GLSL
#include "mixin/vertex.glsl"

struct TracePayload {
  uint instance, geometry, primitive;
  vec2 barycentrics;
  float t;
  uint skip_instance, skip_geometry;
};

vec2 transformedUv(SceneTextureUse use, vec2 uv0, vec2 uv1) {
  vec2 uv = use.uv_set == 0u ? uv0 : uv1;
  return use.u * uv.x + use.v * uv.y + use.offset;
}

// Coverage of an alpha-masked material at a point: full-resolution texels, so that raster and rays agree.
bool isCutOut(uint instance, uint geometry_index, uint primitive, vec2 barycentrics) {
  SceneGeometry geometry = scene_geometries[scene_instances[instance].first_geometry + geometry_index];
  SceneMaterial material = scene_materials[geometry.material];
  if ((material.flags & MATERIAL_ALPHA_MASK) == 0u) return false;
  vec3 weights = vec3(1.0 - barycentrics.x - barycentrics.y, barycentrics);
  vec2 uv0 = vec2(0), uv1 = vec2(0);
  float alpha = 0.0;
  for (uint corner = 0u; corner < 3u; ++corner) {
    uint vertex = vertexOf(geometry, primitive, corner);
    uv0 += weights[corner] * vertexUv0(vertex);
    uv1 += weights[corner] * vertexUv1(vertex);
    alpha += weights[corner] * vertexColor(vertex).a;
  }
  alpha *= material.base_color.a;
  int texture_index = material.base_color_use.texture;
  if (texture_index >= 0) {
    vec2 uv = transformedUv(material.base_color_use, uv0, uv1);
    alpha *= textureLod(scene_textures[nonuniformEXT(texture_index)], uv, 0.0).a;
  }
  return alpha < material.alpha_cutoff;
}

bool acceptsHit(uint instance, uint geometry, uint primitive, vec2 barycentrics, uint skip_instance, uint skip_geometry) {
  bool skipped = instance == skip_instance && (skip_geometry == NO_INSTANCE || geometry == skip_geometry);
#if FACT_alpha
  return !skipped && !isCutOut(instance, geometry, primitive, barycentrics);
#else
  return !skipped;
#endif
}

#endif
