// SPDX-License-Identifier: MIT
// Needs: scene.
// Inputs of the fragment shaders that draw the scene, written by gbuffer/visibility.vert.glsl, and the test that discards
// fragments. The inputs behind `#if FACT_*` exist only if the frame needs them.
#ifndef STROBE_FRAGMENT_GLSL
#define STROBE_FRAGMENT_GLSL
#include "mixin/trace_payload.glsl"

layout(location = 0) flat in uvec2 draw;  // instance, geometry
#if FACT_alpha
layout(location = 1) in vec2 uv0;
layout(location = 2) in vec2 uv1;
layout(location = 3) in float alpha;  // of the vertex colour
#endif
#ifdef STROBE_SEPARATE_TRIANGLES
layout(location = 4) flat in uint triangle;  // number within the geometry
#else
uint triangle = uint(gl_PrimitiveID);
#endif
#if FACT_one_sided
layout(location = 5) flat in uint mirrored;  // 1 if the instance's transform mirrors, which reverses the winding
#endif
#if FACT_blend
layout(location = 6) in vec3 position_os;  // object space, at the raster time
#else
const vec3 position_os = vec3(0);
#endif

// True if the fragment is to be discarded: alpha cuts it out, by the same test as for rays, or it is on the back of a one-sided
// material.
bool isLeftOut() {
#if FACT_one_sided
  if (gl_FrontFacing == (mirrored != 0u) && isOneSided(draw.x, draw.y)) return true;
#endif
#if FACT_alpha
  SceneGeometry geometry = geometryOf(draw.x, draw.y);
  SceneMaterial material = scene_materials[geometry.material];
  if ((material.flags & (MATERIAL_ALPHA_MASK | MATERIAL_ALPHA_BLEND)) != 0u) {
    float coverage = alpha * material.base_color.a;
    int texture_index = material.uses[USE_BASE_COLOR].texture;
    if (texture_index >= 0) {
      vec2 uv = transformedUv(material.uses[USE_BASE_COLOR], uv0, uv1);
      coverage *= textureLod(scene_textures[nonuniformEXT(texture_index)], uv, 0.0).a;
    }
    if (coverage < leastAlpha(material, draw.x, draw.y, position_os)) return true;
  }
#endif
  return false;
}

#endif
