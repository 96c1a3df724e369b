// SPDX-License-Identifier: MIT
// Output: hit = (instance + 1, geometry, primitive, 0). Discards by the same tests as rays use what alpha leaves out, and
// backs of what is seen from one side alone.
#include "mixin/trace_payload.glsl"

layout(location = 0) flat in uvec2 draw;
layout(location = 1) in vec2 uv0;
layout(location = 2) in vec2 uv1;
layout(location = 3) in float alpha;
#ifdef STROBE_SEPARATE_TRIANGLES
layout(location = 4) flat in uint triangle;
#else
uint triangle = uint(gl_PrimitiveID);
#endif
#if FACT_one_sided
layout(location = 5) flat in uint mirrored;
#endif
#if FACT_blend
layout(location = 6) in vec3 position_os;
#else
const vec3 position_os = vec3(0);
#endif

void main() {
#if FACT_one_sided
  if (gl_FrontFacing == (mirrored != 0u) && isOneSided(draw.x, draw.y)) discard;
#endif
#if FACT_alpha
  SceneGeometry geometry = scene_geometries[scene_instances[draw.x].first_geometry + draw.y];
  SceneMaterial material = scene_materials[geometry.material];
  if ((material.flags & (MATERIAL_ALPHA_MASK | MATERIAL_ALPHA_BLEND)) != 0u) {
    float coverage = alpha * material.base_color.a;
    int texture_index = material.base_color_use.texture;
    if (texture_index >= 0) {
      vec2 uv = transformedUv(material.base_color_use, uv0, uv1);
      coverage *= textureLod(scene_textures[nonuniformEXT(texture_index)], uv, 0.0).a;
    }
    if (coverage < leastAlpha(material, draw.x, draw.y, position_os)) discard;
  }
#endif
  hit_out = uvec4(draw.x + 1u, draw.y, triangle, 0u);
}
