// SPDX-License-Identifier: MIT
// Layout of the scene in shaders. World positions are in metres, relative to the frame's origin: the camera at the raster time,
// so that single precision is highest near the camera. A *slice* is the scene posed at one time.
#ifndef STROBE_SHARED_SCENE_H
#define STROBE_SHARED_SCENE_H
#include "shared/types.h"
STROBE_SHARED_BEGIN

// Numbers of the slices. Sample i of an iteration has the slice SLICE_SAMPLE + i.
#define SLICE_RASTER 0u  // the raster time
#define SLICE_SHUTTER_OPEN 1u
#define SLICE_SHUTTER_CLOSE 2u
#define SLICE_PREVIOUS 3u        // one frame before the raster time
#define SLICE_SAMPLE 4u          // first sample time of a loop's iteration
#define NO_INSTANCE 0xffffffffu  // in place of an instance: a miss, or nothing to skip
// Masks of a ray: the instances that the ray can hit. RAYS_TO_ONE + i is instance i alone, with the backend `bvh` only.
#define RAYS_TO_ALL 0xffu
#define RAYS_TO_MOVING 0x80u  // instances that may move within the exposure
#define RAYS_TO_ONE 0x100u

// Properties of an instance's motion on the screen, within the exposure and since the previous frame. Conservative: a bit is
// clear only if the property is proven false, with a tolerance of 0.05 px. All bits of a static instance are clear.
#define PATH_CURVED 1u           // a point of the instance deviates from a straight path at constant speed
#define PATH_MAY_BE_OCCLUDED 2u  // another object may be in front, or another part of the instance with another velocity

// Vertex of a mesh in object space.
struct SceneVertex {
  vec3 position;  // first member: acceleration structures read it
  vec3 normal;
  vec2 uv0;    // first set of texture coordinates
  vec2 uv1;    // second set of texture coordinates
  uint color;  // rgba8 unorm, linear
};

// Format of packed tangents of vertices, for normal maps. From the lowest bit: a direction as two numbers of TANGENT_BITS bits
// (octahedral; Cigolle et al., "A Survey of Efficient Representations for Independent Unit Vectors", JCGT 2014),
// TANGENT_NEGATIVE if the handedness is -1, and TANGENT_PRESENT. The value 0 means that the vertex has no tangent.
#define TANGENT_BITS 15u
#define TANGENT_LARGEST 16383.0  // scale: a component c in [-1, 1] is stored as (c + 1) * TANGENT_LARGEST
#define TANGENT_NEGATIVE 0x40000000u
#define TANGENT_PRESENT 0x80000000u
#define NO_TANGENTS 0xffffffffu  // in place of SceneGeometry.first_tangent: the geometry has no tangents

// Vertex of a deforming mesh at one slice, in object space.
struct SceneDeformedVertex {
  vec3 position;  // first member: acceleration structures read it
  vec3 normal;    // unit; 0: use the triangle's normal
  uint tangent;   // packed tangent; 0: derive it from the texture coordinates
};

// Instance: one drawn object, a mesh at a node of the scene.
struct SceneInstance {
  uint first_geometry;  // index of the instance's first geometry
  uint geometry_count;
  uint moves;  // 0 if the instance is proven static within the exposure
  uint path;   // PATH_* bits
};

// Geometry: triangles of a mesh that have one material.
struct SceneGeometry {
  uint first_index;   // position of its first index; three indices per triangle
  uint first_vertex;  // number of the vertex that the index 0 stands for; added to every index
  uint triangle_count;
  uint material;
  uint first_tangent;  // position of the first tangent, one per vertex; or NO_TANGENTS
};

// Draw call of the rasteriser: one geometry of one instance.
struct SceneDraw {
  uint instance;
  uint geometry;  // number within the instance
};

// Texture slot of a material: the texture, and the transform of its coordinates.
struct SceneTextureUse {
  int texture;        // index into scene_textures; -1: no texture
  uint uv_set;        // set of texture coordinates: 0 or 1
  vec2 u, v, offset;  // transformed coordinates: u * uv.x + v * uv.y + offset
  uint most_taps;     // largest number of lookups along the longer axis of the footprint (anisotropic filtering)
};

// Flags of a material.
#define MATERIAL_UNLIT 1u        // the colour is the base colour, without lights
#define MATERIAL_ALPHA_MASK 2u   // points with an alpha below `alpha_cutoff` are cut out
#define MATERIAL_ALPHA_BLEND 4u  // alpha is the share of the points that are kept
#define MATERIAL_ONE_SIDED 8u    // back faces are not visible

// Texture slots of a material: indices into SceneMaterial.uses.
#define USE_BASE_COLOR 0
#define USE_METALLIC_ROUGHNESS 1
#define USE_NORMAL 2
#define USE_EMISSIVE 3

// Metallic-roughness material of glTF 2.0. Colours are linear.
struct SceneMaterial {
  vec4 base_color;
  vec3 mean_color;  // base_color times the mean of its texture over the whole texture
  vec3 emissive;    // emitted radiance
  float metallic;
  float roughness;
  float alpha_cutoff;
  float normal_scale;
  uint flags;               // MATERIAL_*
  SceneTextureUse uses[4];  // index: USE_*
};

#define LIGHT_DIRECTIONAL 0u
#define LIGHT_POINT 1u
#define LIGHT_SPOT 2u

// Punctual light at one slice.
struct SceneLight {
  vec3 position;
  uint type;                   // LIGHT_*
  vec3 direction;              // unit, away from the light
  float range;                 // metres; 0: unlimited
  vec3 intensity;              // colour times candela (point, spot) or lux (directional), in the renderer's units of radiance
  uint shadow;                 // 0: the light casts no shadows
  float cos_inner, cos_outer;  // spot: cosines of the half angles of full light and of no light
};

// World-from-object transform of an instance at one slice, as three rows.
struct SceneTransform {
  vec4 row_x, row_y, row_z;
};

// Camera at one slice.
struct SceneCamera {
  vec3 position;
  float near;               // view depth of the near plane, metres
  vec3 right, up, forward;  // unit
  vec2 half_extent;         // half size of the image: tangents of the half angles (perspective) or metres (orthographic)
  uint orthographic;        // 1: orthographic, 0: perspective
  float depth_range;        // orthographic: length of the visible range of depths behind the near plane, metres
  ivec4 moving;             // rectangle of pixels [x, z) x [y, w) that may show a moving surface at this time; conservative
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
