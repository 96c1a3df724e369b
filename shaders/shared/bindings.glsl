// SPDX-License-Identifier: MIT
// Bindings of the scene (descriptor set 0), filled by the runtime, and functions that read them. The preamble that the runtime
// generates for a shader includes this file if the pass reads the scene. Shaders do not include it themselves.
#ifndef STROBE_BINDINGS_GLSL
#define STROBE_BINDINGS_GLSL
#include "shared/scene.h"

// Arrays of the scene. Shaders read them by buffer device address instead of binding them, for two reasons. A bound buffer may
// be limited to 128 MiB. A software device loads from a bound buffer for each invocation separately, with branches that take
// most of a shader's compile time. Loads by address are not checked, so an index must be within its array. The functions below
// accept any instance and geometry; mixin/vertex.glsl reads vertices and indices.
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
#if FACT_deforms
layout(buffer_reference, scalar, buffer_reference_align = 4) readonly buffer SceneDeformedVertices { SceneDeformedVertex at[]; };
#endif
layout(set = 0, binding = 1, scalar) uniform SceneArrays {
  SceneVertices vertices;
  SceneTangents tangents;
  SceneIndices indices;
  SceneGeometries geometries;
  SceneInstances instances;
  SceneDraws draws;
  SceneMaterials materials;
  SceneLights lights;          // all lights of the first slice, then of the next slice, and so on
  SceneTransforms transforms;  // all instances, slice by slice
  SceneCameras cameras;        // one for each slice
#if FACT_deforms
  SceneDeformedVertices deformed;  // all deforming vertices, slice by slice
  uint first_deformed;      // index of the first deforming vertex; all vertices from there on deform
  uint deformed_count;      // number of deforming vertices
#endif
} scene_arrays;  // filled from `SceneAddresses` of runtime/world/gpu_scene.cpp
#define scene_draws scene_arrays.draws.at
#define scene_materials scene_arrays.materials.at
#define scene_lights scene_arrays.lights.at
#define scene_cameras scene_arrays.cameras.at

// Index of an existing instance. An index out of range, as a shader that is being edited may produce, becomes the last
// instance.
uint knownInstance(uint instance) { return min(instance, max(frame.instance_count, 1u) - 1u); }

// Instance by index; the last one if the index is out of range.
SceneInstance instanceAt(uint instance) { return scene_arrays.instances.at[knownInstance(instance)]; }

// World-from-object transform of an instance, with the scene posed at `slice`.
SceneTransform transformOf(uint slice, uint instance) {
  return scene_arrays.transforms.at[slice * frame.instance_count + knownInstance(instance)];
}

// Geometry of an instance by its number within the instance; the last one if the number is out of range.
SceneGeometry geometryOf(uint instance, uint geometry) {
  SceneInstance of = instanceAt(instance);
  return scene_arrays.geometries.at[of.first_geometry + min(geometry, max(of.geometry_count, 1u) - 1u)];
}

layout(set = 0, binding = 2) uniform sampler2D scene_textures[];
#ifdef STROBE_STRUCTURES_DRIVER
layout(set = 0, binding = 3) uniform accelerationStructureEXT scene_top_levels[STROBE_SLICES];  // one for each slice
#endif
#ifdef STROBE_STRUCTURES_OWN
#include "shared/bvh.h"
layout(buffer_reference, scalar, buffer_reference_align = 16) readonly buffer BvhNodes { BvhNode at[]; };
layout(buffer_reference, scalar, buffer_reference_align = 4) readonly buffer BvhTriangles { BvhTriangle at[]; };
layout(buffer_reference, scalar, buffer_reference_align = 4) readonly buffer BvhInstances { BvhInstance at[]; };
// The scene is posed at several times, called levels here. Level 0 is the raster time; levels from 1 on are the sample
// times of a loop.
layout(set = 0, binding = 3, scalar) uniform SceneBvh {
  BvhNodes nodes;          // first the trees of all meshes; then, for each level, the tree over all instances and the tree
                           // over the moving instances; then, for each level, the trees of the deforming meshes
  BvhTriangles triangles;  // triangles of all meshes; then, for each level, the posed triangles of the deforming meshes
  BvhInstances instances;  // for each level, all instances in their poses at this time
  uint first_root;         // root of the tree over all instances at the raster time
  uint nodes_per_tree;     // number of nodes that each tree over instances occupies
} scene_bvh;  // filled from `Addresses` of runtime/world/own_structures.cpp
#endif
#endif
