// SPDX-License-Identifier: MIT
// The scene's bindings (set 0), as the runtime fills them. Included by the generated preamble of a pass that sees the
// scene; a shader never includes it.
#ifndef STROBE_BINDINGS_GLSL
#define STROBE_BINDINGS_GLSL
#include "shared/scene.h"

// By address: what is bound as a buffer may be no larger than 128 MiB. mixin/vertex.glsl reads them.
layout(buffer_reference, scalar, buffer_reference_align = 4) readonly buffer SceneVertices { SceneVertex at[]; };
layout(buffer_reference, scalar, buffer_reference_align = 4) readonly buffer SceneIndices { uint at[]; };
#if FACT_bends
layout(buffer_reference, scalar, buffer_reference_align = 4) readonly buffer SceneBentVertices { SceneBentVertex at[]; };
#endif
layout(set = 0, binding = 1, scalar) uniform SceneMeshes {
  SceneVertices vertices;
  SceneIndices indices;
#if FACT_bends
  SceneBentVertices bent;  // per slice
  uint first_bending;      // vertices from this one bend,
  uint bending_count;      // so many
#endif
} scene_meshes;  // `MeshAddresses` of runtime/world/gpu_scene.cpp
layout(set = 0, binding = 2, scalar) readonly buffer SceneGeometries { SceneGeometry scene_geometries[]; };
layout(set = 0, binding = 3, scalar) readonly buffer SceneInstances { SceneInstance scene_instances[]; };
layout(set = 0, binding = 4, scalar) readonly buffer SceneDraws { SceneDraw scene_draws[]; };
layout(set = 0, binding = 5, scalar) readonly buffer SceneMaterials { SceneMaterial scene_materials[]; };
layout(set = 0, binding = 6, scalar) readonly buffer SceneLights { SceneLight scene_lights[]; };          // per slice
layout(set = 0, binding = 7, scalar) readonly buffer SceneTransforms { SceneTransform scene_transforms[]; };  // per slice
layout(set = 0, binding = 8, scalar) readonly buffer SceneCameras { SceneCamera scene_cameras[]; };      // per slice
layout(set = 0, binding = 9) uniform sampler2D scene_textures[];
#ifdef STROBE_STRUCTURES_DRIVER
layout(set = 0, binding = 10) uniform accelerationStructureEXT scene_top_levels[STROBE_SLICES];  // per slice
#endif
#ifdef STROBE_STRUCTURES_OWN
#include "shared/bvh.h"
layout(buffer_reference, scalar, buffer_reference_align = 16) readonly buffer BvhNodes { BvhNode at[]; };
layout(buffer_reference, scalar, buffer_reference_align = 4) readonly buffer BvhTriangles { BvhTriangle at[]; };
layout(buffer_reference, scalar, buffer_reference_align = 4) readonly buffer BvhInstances { BvhInstance at[]; };
layout(set = 0, binding = 10, scalar) uniform SceneBvh {
  BvhNodes nodes;          // of all meshes, then at each level (the capture, then each sample) of all instances, of those
                           // that move; then of what bends at each level
  BvhTriangles triangles;  // of all meshes, then of what bends at each level
  BvhInstances instances;  // at each level
  uint first_root;         // of the instances at the capture
  uint nodes_per_tree;
} scene_bvh;  // `Addresses` of runtime/world/own_structures.cpp
#endif
#endif
