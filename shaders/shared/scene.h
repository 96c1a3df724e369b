// SPDX-License-Identifier: MIT
// Layout of the scene in shaders. Positions are relative to the frame's origin, the camera at the raster time, so that single
// precision is highest near the camera. A *slice* is the scene's pose at one time.
#ifndef STROBE_SHARED_SCENE_H
#define STROBE_SHARED_SCENE_H
#include "shared/types.h"
STROBE_SHARED_BEGIN

#define SLICE_RASTER 0u
#define SLICE_SHUTTER_OPEN 1u
#define SLICE_SHUTTER_CLOSE 2u
#define SLICE_PREVIOUS 3u  // one frame before the raster time
#define SLICE_SAMPLE 4u    // first sample time of a loop
#define NO_INSTANCE 0xffffffffu
// Masks of the instances that a ray can hit. RAYS_TO_ONE + i: instance i alone, backend `bvh` only.
#define RAYS_TO_ALL 0xffu
#define RAYS_TO_MOVING 0x80u
#define RAYS_TO_ONE 0x100u

// Properties of an instance's screen motion within the exposure and since the previous frame. Conservative: a bit is clear only
// if the property is proven false, with a tolerance of 0.05 px. All bits of a static instance are clear.
#define PATH_CURVED 1u   // some point of the instance deviates from a straight path at constant speed
#define PATH_TURNS 2u    // points of the instance have different velocities
#define PATH_MAY_BE_OCCLUDED 4u  // another object, or a part of the instance with another velocity, may be in front
#define PATH_MAY_APPEAR 8u  // some part of the instance may be visible at another time but not at the raster time

struct SceneVertex {
  vec3 position;  // first member: acceleration structures read it
  vec3 normal;
  vec2 uv0;
  vec2 uv1;
  uint color;  // rgba8 unorm, linear
};

// Packed tangents of vertices, for normal maps: from the lowest bit, a direction as two numbers of 15 bits (Cigolle et al., "A
// Survey of Efficient Representations for Independent Unit Vectors", JCGT 2014), TANGENT_NEGATIVE if the handedness is -1, and
// TANGENT_PRESENT. 0: no tangent.
#define TANGENT_BITS 15u
#define TANGENT_LARGEST 16383.0
#define TANGENT_NEGATIVE 0x40000000u
#define TANGENT_PRESENT 0x80000000u
#define NO_TANGENTS 0xffffffffu

// A vertex of a deforming mesh at one slice.
struct SceneDeformedVertex {
  vec3 position;  // first member: acceleration structures read it
  vec3 normal;    // unit; 0: use the triangle's normal
  uint tangent;   // packed; 0: derive it from the texture coordinates
};

struct SceneInstance {
  uint first_geometry;
  uint geometry_count;
  uint moves;  // 0 if the instance is proven static within the exposure
  uint path;   // PATH_*
};

struct SceneGeometry {
  uint first_index;
  uint first_vertex;
  uint triangle_count;
  uint material;
  uint first_tangent;  // tangents, one per vertex; NO_TANGENTS: none
};

// A draw of the raster path, one per geometry of each instance.
struct SceneDraw {
  uint instance;
  uint geometry;  // within the instance
};

struct SceneTextureUse {
  int texture;  // index; -1 for no texture
  uint uv_set;
  vec2 u, v, offset;  // uv' = u * uv.x + v * uv.y + offset
  uint most_taps;     // limit of anisotropic filtering: lookups along the longer axis of the footprint
};

#define MATERIAL_UNLIT 1u
#define MATERIAL_ALPHA_MASK 2u
#define MATERIAL_ALPHA_BLEND 4u
#define MATERIAL_ONE_SIDED 8u

// Texture slots of a material.
#define USE_BASE_COLOR 0
#define USE_METALLIC_ROUGHNESS 1
#define USE_NORMAL 2
#define USE_EMISSIVE 3

struct SceneMaterial {
  vec4 base_color;
  vec3 mean_color;  // base_color times the mean of its texture over its whole area; linear
  vec3 emissive;
  float metallic;
  float roughness;
  float alpha_cutoff;
  float normal_scale;
  uint flags;
  SceneTextureUse uses[4];  // by USE_*
};

#define LIGHT_DIRECTIONAL 0u
#define LIGHT_POINT 1u
#define LIGHT_SPOT 2u

struct SceneLight {
  vec3 position;
  uint type;
  vec3 direction;  // unit, from the light
  float range;     // 0: unlimited
  vec3 intensity;  // candela (point, spot) or lux (directional), in the renderer's radiance units
  uint shadow;
  float cos_inner, cos_outer;
};

// World-from-object as three rows.
struct SceneTransform {
  vec4 row_x, row_y, row_z;
};

struct SceneCamera {
  vec3 position;
  float near;
  vec3 right, up, forward;  // unit
  vec2 half_extent;         // perspective: tangents of the half angles; orthographic: metres
  uint orthographic;
  float depth_range;  // orthographic: depth of the visible range behind the near plane, metres
  ivec4 moving;       // pixels [x, z) x [y, w) that may show a moving surface at this time; conservative
};

STROBE_SHARED_END
#ifdef __cplusplus
static_assert(sizeof(strobe::shared::SceneVertex) == 44);
static_assert(sizeof(strobe::shared::SceneDeformedVertex) == 28);
static_assert(sizeof(strobe::shared::SceneTextureUse) == 36);
static_assert(sizeof(strobe::shared::SceneMaterial) == 204);
static_assert(sizeof(strobe::shared::SceneLight) == 56);
static_assert(sizeof(strobe::shared::SceneTransform) == 48);
static_assert(sizeof(strobe::shared::SceneCamera) == 84);
#endif
#endif
