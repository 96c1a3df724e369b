// SPDX-License-Identifier: MIT
// The scene's bindings (set 0), as the runtime fills them. Included by the generated preamble of a pass that sees the
// scene; a shader never includes it.
#ifndef STROBE_BINDINGS_GLSL
#define STROBE_BINDINGS_GLSL
#include "shared/scene.h"

// By address: what is bound as a buffer may be no larger than 128 MiB, and from one a software device loads invocation by
// invocation, with branches that take most of a shader's time to compile. No load is checked: an index must be one of the
// array. The functions below take any id of an instance and of a geometry; mixin/vertex.glsl reads vertices and indices.
layout(buffer_reference, scalar, buffer_reference_align = 4) readonly buffer SceneVertices { SceneVertex at[]; };
layout(buffer_reference, scalar, buffer_reference_align = 4) readonly buffer SceneTangents { uint at[]; };
layout(buffer_reference, scalar, buffer_reference_align = 4) readonly buffer SceneIndices { uint at[]; };
layout(buffer_reference, scalar, buffer_reference_align = 4) readonly buffer SceneGeometries { SceneGeometry at[]; };
layout(buffer_reference, scalar, buffer_reference_align = 4) readonly buffer SceneInstances { SceneInstance at[]; };
layout(buffer_reference, scalar, buffer_reference_align = 4) readonly buffer SceneDraws { SceneDraw at[]; };
layout(buffer_reference, scalar, buffer_reference_align = 4) readonly buffer SceneMaterials { SceneMaterial at[]; };
layout(buffer_reference, scalar, buffer_reference_align = 4) readonly buffer SceneLights { SceneLight at[]; };
layout(buffer_reference, scalar, buffer_reference_align = 16) readonly buffer SceneTransforms { SceneTransform at[]; };
layout(buffer_reference, scalar, buffer_reference_align = 4) readonly buffer SceneCameras { SceneCamera at[]; };
#if FACT_bends
layout(buffer_reference, scalar, buffer_reference_align = 4) readonly buffer SceneBentVertices { SceneBentVertex at[]; };
#endif
layout(set = 0, binding = 1, scalar) uniform SceneArrays {
  SceneVertices vertices;
  SceneTangents tangents;
  SceneIndices indices;
  SceneGeometries geometries;
  SceneInstances instances;
  SceneDraws draws;
  SceneMaterials materials;
  SceneLights lights;          // per slice
  SceneTransforms transforms;  // per slice
  SceneCameras cameras;        // per slice
#if FACT_bends
  SceneBentVertices bent;  // per slice
  uint first_bending;      // vertices from this one bend,
  uint bending_count;      // so many
#endif
} scene_arrays;  // `SceneAddresses` of runtime/world/gpu_scene.cpp
#define scene_draws scene_arrays.draws.at
#define scene_materials scene_arrays.materials.at
#define scene_lights scene_arrays.lights.at
#define scene_cameras scene_arrays.cameras.at

// Of an id that no instance has, which a pass that is being edited may write, the last one.
uint knownInstance(uint instance) { return min(instance, max(frame.instance_count, 1u) - 1u); }

SceneInstance instanceAt(uint instance) { return scene_arrays.instances.at[knownInstance(instance)]; }

SceneTransform transformOf(uint slice, uint instance) {
  return scene_arrays.transforms.at[slice * frame.instance_count + knownInstance(instance)];
}

SceneGeometry geometryOf(uint instance, uint geometry) {
  SceneInstance of = instanceAt(instance);
  return scene_arrays.geometries.at[of.first_geometry + min(geometry, max(of.geometry_count, 1u) - 1u)];
}

layout(set = 0, binding = 2) uniform sampler2D scene_textures[];
#ifdef STROBE_STRUCTURES_DRIVER
layout(set = 0, binding = 3) uniform accelerationStructureEXT scene_top_levels[STROBE_SLICES];  // per slice
#endif
#ifdef STROBE_STRUCTURES_OWN
#include "shared/bvh.h"
layout(buffer_reference, scalar, buffer_reference_align = 16) readonly buffer BvhNodes { BvhNode at[]; };
layout(buffer_reference, scalar, buffer_reference_align = 4) readonly buffer BvhTriangles { BvhTriangle at[]; };
layout(buffer_reference, scalar, buffer_reference_align = 4) readonly buffer BvhInstances { BvhInstance at[]; };
layout(set = 0, binding = 3, scalar) uniform SceneBvh {
  BvhNodes nodes;          // of all meshes, then at each level (the capture, then each sample) of all instances, of those
                           // that move; then of what bends at each level
  BvhTriangles triangles;  // of all meshes, then of what bends at each level
  BvhInstances instances;  // at each level
  uint first_root;         // of the instances at the capture
  uint nodes_per_tree;
} scene_bvh;  // `Addresses` of runtime/world/own_structures.cpp
#endif
#endif
