// SPDX-License-Identifier: MIT
// Needs: rays, scene; may have: PARAM_displacement.
// The shading function of all passes: radiance of a surface point towards the camera. The result depends only on the point and
// on the pose of the scene. Raster layer, revealed layers and ground truth share this function, so a point has one colour,
// whether the raster or a ray found it. Differences between methods are therefore differences of visibility and filtering.
// Method: metallic-roughness material of glTF 2.0: Lambert plus GGX (Smith, height-correlated; Schlick's Fresnel). Lights are
//   punctual, with traced shadows. Ambient light is a blend of the ground's and the sky's radiance, by the direction of the
//   normal.
#ifndef STROBE_SHADE_GLSL
#define STROBE_SHADE_GLSL
#include "lib/sanitise.glsl"
#include "mixin/trace.glsl"

const float kPi = 3.14159265358979;

// Ambient radiance from a unit direction, y up: a blend from `frame.ground` (below) to `frame.sky` (above).
vec3 skyLight(vec3 direction_unit) { return mix(frame.ground, frame.sky, 0.5 + 0.5 * direction_unit.y); }

// Linear radiance of a ray that leaves the scene. The direction may have any length.
vec3 environment(vec3 direction_ws) {
  if (frame.background.w != 0.0) return frame.background.rgb;
  return skyLight(unitOr(direction_ws, vec3(0, 1, 0)));
}

// Footprint on the surface's plane of a pixel of the camera at `slice`: change of the world position per pixel to the right
// (column 0) and down (column 1), metres. The footprint depends on the surface point alone. At grazing angles the cosine
// between plane normal and view direction counts as at least 1/16, which bounds the footprint.
mat2x3 footprintOf(uint slice, Surface surface) {
  SceneCamera camera = scene_cameras[slice];
  vec2 pixel = 2.0 * camera.half_extent / vec2(frame.size);
  vec3 right = camera.right * pixel.x, down = -camera.up * pixel.y;
  if (camera.orthographic == 0u) {
    float depth = max(dot(surface.position_ws - camera.position, camera.forward), camera.near);
    right *= depth;
    down *= depth;
  }
  vec3 view = camera.orthographic != 0u ? camera.forward : unitOr(surface.position_ws - camera.position, camera.forward);
  vec3 n = surface.face_normal_ws;
  float facing = dot(n, view);
  facing = abs(facing) < 0.0625 ? (facing < 0.0 ? -0.0625 : 0.0625) : facing;
  return mat2x3(right - view * (dot(n, right) / facing), down - view * (dot(n, down) / facing));
}

// Change of texture coordinates for the step `direction_ws` in the triangle's plane, by least squares on the triangle's edges.
// `uv_edge1`, `uv_edge2`: change of the coordinates along both edges. 0 for degenerate triangles.
vec2 uvAlong(Surface surface, vec3 direction_ws, vec2 uv_edge1, vec2 uv_edge2) {
  vec3 e1 = surface.edge1_ws, e2 = surface.edge2_ws;
  // Divide by the largest component of the edges, so that their squares stay within range at any scale of the scene.
  float scale = max(max(abs(e1.x), max(abs(e1.y), abs(e1.z))), max(abs(e2.x), max(abs(e2.y), abs(e2.z))));
  if (!(scale > 0.0)) return vec2(0);
  e1 /= scale;
  e2 /= scale;
  vec3 d = direction_ws / scale;
  float a = dot(e1, e1), b = dot(e1, e2), c = dot(e2, e2);
  float determinant = a * c - b * b;
  if (!(determinant > 1e-12 * a * c)) return vec2(0);
  float p = dot(e1, d), q = dot(e2, d);
  return ((p * c - q * b) * uv_edge1 + (q * a - p * b) * uv_edge2) / determinant;
}

// Texture value of a slot at a surface point, filtered anisotropically: the mean of several lookups along the longer axis of
// the footprint, with the mip level that fits the distance between lookups. `footprint_ws`: result of `footprintOf`. The slot
// must have a texture. A texture with a single mip level gets one lookup.
vec4 sampleTexture(SceneTextureUse use, Surface surface, mat2x3 footprint_ws) {
  vec2 uv = transformedUv(use, surface.uv0, surface.uv1);
  bool is_plain = textureQueryLevels(scene_textures[nonuniformEXT(use.texture)]) == 1;
  vec2 edge1 = use.uv_set == 0u ? surface.uv0_edge1 : surface.uv1_edge1;
  vec2 edge2 = use.uv_set == 0u ? surface.uv0_edge2 : surface.uv1_edge2;
  edge1 = use.u * edge1.x + use.v * edge1.y;
  edge2 = use.u * edge2.x + use.v * edge2.y;
  vec2 size = vec2(textureSize(scene_textures[nonuniformEXT(use.texture)], 0));
  vec2 uv_right = uvAlong(surface, footprint_ws[0], edge1, edge2);
  vec2 uv_down = uvAlong(surface, footprint_ws[1], edge1, edge2);
  float right_texels = length(uv_right * size), down_texels = length(uv_down * size);
  bool right_longer = right_texels >= down_texels;
  float longer = max(right_texels, down_texels), shorter = min(right_texels, down_texels);
  vec2 axis = right_longer ? uv_right : uv_down;
  int taps = is_plain ? 1 : clamp(int(ceil(longer / max(shorter, 1.0))), 1, int(use.most_taps));
  float level = is_plain ? 0.0 : log2(max(longer / float(taps), 1e-6));
  vec4 sum = vec4(0);
  for (int i = 0; i < taps; ++i) {
    vec2 tap = taps == 1 ? uv : uv + axis * ((float(i) + 0.5) / float(taps) - 0.5);
    sum += textureLod(scene_textures[nonuniformEXT(use.texture)], tap, level);
  }
  return sum / float(taps);
}

// Texture values at a surface point, one per texture slot; 1 for slots without a texture.
struct Texels {
  vec4 base_color, metallic_roughness, normal, emissive;
};

// Texture values of the first `count` slots (in the order of USE_*); 1 for the others. One loop serves all slots, because each
// inlined copy of a lookup takes long to compile.
Texels texelsOf(Surface surface, int count, mat2x3 footprint_ws) {
  Texels texels = Texels(vec4(1), vec4(1), vec4(1), vec4(1));
  for (int i = 0; i < count; ++i) {
    SceneTextureUse use = scene_materials[surface.material].uses[i];
    if (use.texture < 0) continue;
    vec4 texel = sampleTexture(use, surface, footprint_ws);
    if (i == USE_BASE_COLOR) texels.base_color = texel;
    else if (i == USE_METALLIC_ROUGHNESS) texels.metallic_roughness = texel;
    else if (i == USE_NORMAL) texels.normal = texel;
    else texels.emissive = texel;
  }
  return texels;
}

// World directions of increasing texture coordinates u and v of a slot, not of unit length. Returns false if the mapping from
// surface to coordinates is degenerate.
bool textureAxes(SceneTextureUse use, Surface surface, out vec3 along_u, out vec3 along_v) {
  vec2 d1 = use.uv_set == 0u ? surface.uv0_edge1 : surface.uv1_edge1;
  vec2 d2 = use.uv_set == 0u ? surface.uv0_edge2 : surface.uv1_edge2;
  d1 = use.u * d1.x + use.v * d1.y;
  d2 = use.u * d2.x + use.v * d2.y;
  float determinant = d1.x * d2.y - d1.y * d2.x;
  along_u = (surface.edge1_ws * d2.y - surface.edge2_ws * d1.y) * sign(determinant);
  along_v = (surface.edge2_ws * d1.x - surface.edge1_ws * d2.x) * sign(determinant);
  return determinant != 0.0;
}

// Unit normal in world space, perturbed by the material's normal map; the interpolated normal if the material has no such map.
// `texel`: value of the map. The tangent frame is from the vertices' tangents (glTF 2.0, 3.7.2.1) or, if they are missing, from
// the directions of the texture coordinates on the triangle.
vec3 bumpedNormal(uint slice, Hit hit, SceneMaterial material, Surface surface, vec4 texel) {
  SceneTextureUse use = material.uses[USE_NORMAL];
  if (use.texture < 0) return surface.normal_ws;
  vec3 n = texel.xyz * 2.0 - 1.0;
  n.xy *= material.normal_scale;
  vec3 tangent, bitangent;
  vec4 given = tangentOf(slice, hit);
  if (given.w != 0.0) {
    tangent = given.xyz;
    bitangent = cross(given.xyz, surface.normal_ws) * (given.w * surface.normal_side);
  } else if (!textureAxes(use, surface, tangent, bitangent)) {
    return surface.normal_ws;
  }
  tangent = unitOr(tangent - surface.normal_ws * dot(surface.normal_ws, tangent), vec3(0));
  bitangent = unitOr(bitangent - surface.normal_ws * dot(surface.normal_ws, bitangent), vec3(0));
  // The texture coordinate v points down. The green axis of a normal map points up.
  return unitOr(tangent * n.x - bitangent * n.y + surface.normal_ws * max(n.z, 1e-3), surface.normal_ws);
}

// Parameters of the reflection at a surface point.
struct Reflectance {
  vec3 diffuse;   // albedo
  vec3 specular;  // reflectance at normal incidence
  float alpha;    // GGX width
};

// BRDF (diffuse plus specular) for light from the direction `light`, times the cosine between this direction and the normal n.
// 0 for light from behind. n, `view` (towards the camera) and `light` are unit vectors.
vec3 reflected(Reflectance r, vec3 n, vec3 view, vec3 light) {
  float n_l = dot(n, light);
  if (n_l <= 0.0) return vec3(0);
  float n_v = max(dot(n, view), 1e-3);
  vec3 halfway = unitOr(view + light, n);
  float n_h = max(dot(n, halfway), 0.0), v_h = max(dot(view, halfway), 0.0);
  float a2 = r.alpha * r.alpha;
  float bell = n_h * n_h * (a2 - 1.0) + 1.0;
  float distribution = a2 / (kPi * bell * bell);
  float visibility = 0.5 / (n_l * sqrt(n_v * n_v * (1.0 - a2) + a2) + n_v * sqrt(n_l * n_l * (1.0 - a2) + a2));
  vec3 fresnel = r.specular + (1.0 - r.specular) * pow(1.0 - v_h, 5.0);
  return (r.diffuse / kPi * (1.0 - fresnel) + fresnel * distribution * visibility) * n_l;
}

// Lift of shadow rays off their surface, as a share of a distance: 2^-14.
const float kShadowLift = 6.1e-5;

// Origin of a shadow ray: the surface point, lifted off its surface so far that single precision separates both. The lift is
// the share 2^-14 of the distance to the frame's origin (its largest coordinate) or of `extent`, the distance to the light,
// whichever is larger. A share works at any scale of the scene.
vec3 shadowOrigin(Surface surface, float extent) {
  vec3 p = abs(surface.position_ws);
  float reach = max(max(p.x, max(p.y, p.z)), extent);
  return surface.position_ws + surface.face_normal_ws * (reach * kShadowLift);
}

#ifdef STROBE_KEEPS_SHADOWS
// Results of shadow rays, reused from earlier rays and kept for later rays by passes that define STROBE_KEEPS_SHADOWS. Bit i is
// for light i of the first 32 lights. known_visible, known_blocked: input; lights that are known to be visible or blocked and
// need no ray. found_visible, found_blocked: output; lights that rays found visible or blocked.
uint known_visible = 0u, known_blocked = 0u, found_visible = 0u, found_blocked = 0u;

// Bit of light `number`; 0 from light 32 on, which has no bit.
uint bitOf(uint number) { return number < 32u ? 1u << number : 0u; }
#endif

// True if light `number` is known to be blocked, without a ray.
bool isKnownBlocked(uint number) {
#ifdef STROBE_KEEPS_SHADOWS
  return (known_blocked & bitOf(number)) != 0u;
#else
  return false;
#endif
}

// True if the shadow ray to light `number` is blocked. The ray is traced unless the light is known to be visible. `t_max`:
// distance of the light along the ray.
bool isShadowed(uint slice, uint number, Ray ray, float t_max) {
#ifdef STROBE_KEEPS_SHADOWS
  uint bit = bitOf(number);
  if ((known_visible & bit) != 0u) return false;
  bool blocked = isBlocked(slice, ray, 0.0, t_max);
  if (blocked) found_blocked |= bit;
  else found_visible |= bit;
  return blocked;
#else
  return isBlocked(slice, ray, 0.0, t_max);
#endif
}

// Irradiance at normal incidence from punctual light `number` at a surface point, after the shadow test. 0 if the surface faces
// away from the light or the light does not reach it. `towards`: output, unit direction to the light.
vec3 incident(uint slice, uint number, Surface surface, out vec3 towards) {
  SceneLight light = scene_lights[slice * frame.light_count + number];
  vec3 offset = light.position - surface.position_ws;
  float squared = dot(offset, offset);
  vec3 irradiance = light.intensity;
  float t_max = 1.0;
  if (light.type == LIGHT_DIRECTIONAL) {
    towards = -light.direction;
    t_max = 3.0e38;
  } else {
    towards = unitOr(offset, surface.normal_ws);
    float distance = length(offset);
    irradiance /= squared;
    if (light.range > 0.0) {
      float q = distance / light.range;
      float window = clamp(1.0 - q * q * q * q, 0.0, 1.0);
      irradiance *= window;
    }
    if (light.type == LIGHT_SPOT) {
      float cosine = dot(-towards, light.direction);
      float cone = clamp((cosine - light.cos_outer) / max(light.cos_inner - light.cos_outer, 1e-4), 0.0, 1.0);
      irradiance *= cone * cone;
    }
  }
  bool lit = dot(towards, surface.normal_ws) > 0.0 && any(greaterThan(irradiance, vec3(0)));
  if (!lit) return vec3(0);
  if (dot(towards, surface.face_normal_ws) <= 0.0) return vec3(0);
#if FACT_shadows
  if (light.shadow == 0u) return irradiance;
  vec3 origin = shadowOrigin(surface, light.type == LIGHT_DIRECTIONAL ? 0.0 : length(offset));
  vec3 direction = light.type == LIGHT_DIRECTIONAL ? towards : light.position - origin;
  return isShadowed(slice, number, Ray(origin, direction), t_max) ? vec3(0) : irradiance;
#else
  return irradiance;
#endif
}

#ifdef STROBE_KEEPS_SHADOWS
// Trace the shadow rays that `shade` traces for a point, to set found_visible and found_blocked without shading. The function
// ignores normal maps: where a map turns the normal towards or away from a light, `shade` traces rays to other lights.
void findShadows(uint slice, Hit hit) {
  Surface surface = surfaceOf(slice, hit);
  if ((scene_materials[surface.material].flags & MATERIAL_UNLIT) != 0u) return;
  for (uint i = 0u; i < frame.light_count; ++i) {
    vec3 towards;
    if (!isKnownBlocked(i)) incident(slice, i, surface, towards);
  }
}
#endif

// Number of radiances that this invocation replaced because they were not finite.
uint replaced_radiances = 0u;

// Finite radiance: NaN becomes 0 and infinity 65504, so that one bad texel or light does not spoil the mean of a pixel.
vec3 finiteRadiance(vec3 radiance) {
  vec3 sound = finiteColor(vec4(radiance, 0));
  if (sound != radiance) ++replaced_radiances;
  return sound;
}

// Base colour of a surface point, linear: material colour times vertex colour times texel. `texel`: value of the base colour
// texture at the point.
vec3 baseColorOf(SceneMaterial material, Surface surface, vec4 texel) {
  return material.base_color.rgb * surface.color.rgb * texel.rgb;
}

// Linear radiance of a surface point towards the camera, with the scene posed at `slice`; may be infinite or NaN.
vec3 radianceOf(uint slice, Hit hit) {
  Surface surface = surfaceOf(slice, hit);
  SceneMaterial material = scene_materials[surface.material];
  bool is_lit = (material.flags & MATERIAL_UNLIT) == 0u;
  Texels texels = texelsOf(surface, is_lit ? 4 : 1, footprintOf(slice, surface));
  vec3 base = baseColorOf(material, surface, texels.base_color);
  if (!is_lit) return base;

  float metallic = clamp(material.metallic * texels.metallic_roughness.b, 0.0, 1.0);
  float roughness = clamp(material.roughness * texels.metallic_roughness.g, 0.05, 1.0);
  Reflectance r;
  r.diffuse = base * (1.0 - metallic);
  r.specular = mix(vec3(0.04), base, metallic);
  r.alpha = roughness * roughness;

  surface.normal_ws = bumpedNormal(slice, hit, material, surface, texels.normal);
  SceneCamera camera = scene_cameras[slice];
  vec3 view = camera.orthographic != 0u ? -camera.forward : unitOr(camera.position - surface.position_ws, -camera.forward);
  vec3 radiance = material.emissive * texels.emissive.rgb;
  for (uint i = 0u; i < frame.light_count; ++i) {
    if (isKnownBlocked(i)) continue;
    vec3 towards;
    vec3 irradiance = incident(slice, i, surface, towards);
    if (irradiance == vec3(0)) continue;
    radiance += irradiance * reflected(r, surface.normal_ws, view, towards);
  }
  // Add ambient light: the diffuse part by the normal, the specular part by the mirror direction. Towards grazing angles, the
  // specular part of rough surfaces rises less than the specular part of smooth ones.
  vec3 mirror = reflect(-view, surface.normal_ws);
  float edge = pow(1.0 - clamp(dot(surface.normal_ws, view), 0.0, 1.0), 5.0);
  vec3 fresnel = r.specular + (max(vec3(1.0 - roughness), r.specular) - r.specular) * edge;
  radiance += r.diffuse * skyLight(surface.normal_ws) + fresnel * skyLight(mirror);
  return radiance;
}

// Linear radiance of the hit point towards the camera, with the scene posed at `slice`; scene-referred, finite.
vec3 shade(uint slice, Hit hit) { return finiteRadiance(radianceOf(slice, hit)); }

#endif
