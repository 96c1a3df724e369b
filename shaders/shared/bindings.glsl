// SPDX-License-Identifier: MIT
// Bindings of the scene (set 0), filled by the runtime. If a pass reads the scene, its generated preamble includes this file.
// Shaders do not include the file.
#ifndef STROBE_BINDINGS_GLSL
#define STROBE_BINDINGS_GLSL
#include "shared/scene.h"

// Arrays are read by address. A bound buffer can be limited to 128 MiB, and a software device loads from a bound buffer for
// each invocation separately, with branches that take most of a shader's compile time. Loads by address are not checked: an
// index must be in the array. The functions below accept any id of an instance and of a geometry. mixin/vertex.glsl reads
// vertices and indices.
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
  SceneLights lights;          // slice by slice
  SceneTransforms transforms;  // slice by slice
  SceneCameras cameras;        // one for each slice
#if FACT_deforms
  SceneDeformedVertices deformed;  // slice by slice
  uint first_deformed;      // index of the first vertex that deforms
  uint deformed_count;      // number of vertices that deform
#endif
} scene_arrays;  // `SceneAddresses` of runtime/world/gpu_scene.cpp
#define scene_draws scene_arrays.draws.at
#define scene_materials scene_arrays.materials.at
#define scene_lights scene_arrays.lights.at
#define scene_cameras scene_arrays.cameras.at

// Valid instance id: an id out of range, which a pass under edit may write, becomes the last instance.
uint knownInstance(uint instance) { return min(instance, max(frame.instance_count, 1u) - 1u); }

SceneInstance instanceAt(uint instance) { return scene_arrays.instances.at[knownInstance(instance)]; }

// World-from-object transform of an instance at a slice.
SceneTransform transformOf(uint slice, uint instance) {
  return scene_arrays.transforms.at[slice * frame.instance_count + knownInstance(instance)];
}

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
layout(set = 0, binding = 3, scalar) uniform SceneBvh {
  BvhNodes nodes;          // trees of all meshes; then, for each level (the raster time, then each sample time), the trees
                           // over all instances and over the moving instances; then, for each level, the trees of the
                           // deforming meshes
  BvhTriangles triangles;  // triangles of all meshes; then, for each level, of the deforming meshes
  BvhInstances instances;  // all instances, level by level
  uint first_root;         // root of the tree over all instances at the raster time
  uint nodes_per_tree;
} scene_bvh;  // `Addresses` of runtime/world/own_structures.cpp
#endif
#endif
