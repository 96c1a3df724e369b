// SPDX-License-Identifier: MIT
// Needs: scene.
// Access to the vertices of the scene. Positions, normals and tangents are functions of the slice, because deforming meshes
// change with time. Texture coordinates and colours are constant.
#ifndef STROBE_VERTEX_GLSL
#define STROBE_VERTEX_GLSL

// Index of the vertex at a corner (0 to 2) of a geometry's triangle. `primitive`: number of the triangle within the geometry. A
// number that is too large stands for the last triangle, because loads by address are not checked.
uint vertexOf(SceneGeometry geometry, uint primitive, uint corner) {
  uint triangle = min(primitive, max(geometry.triangle_count, 1u) - 1u);
  return geometry.first_vertex + scene_arrays.indices.at[geometry.first_index + 3u * triangle + corner];
}

#if FACT_deforms
// True if the vertex belongs to a deforming mesh.
bool isDeformed(uint vertex) { return vertex >= scene_arrays.first_deformed; }

// Index of a deforming vertex at the slice, in the array of deformed vertices.
uint deformedAt(uint slice, uint vertex) {
  return slice * scene_arrays.deformed_count + (vertex - scene_arrays.first_deformed);
}

// Position of a vertex in object space, at the scene time `slice`. A vertex of a rigid mesh has one position for all times.
vec3 vertexPosition(uint slice, uint vertex) {
  if (isDeformed(vertex)) return scene_arrays.deformed.at[deformedAt(slice, vertex)].position;
  return scene_arrays.vertices.at[vertex].position;
}

// Normal of a vertex in object space, at the slice.
vec3 vertexNormal(uint slice, uint vertex) {
  if (isDeformed(vertex)) return scene_arrays.deformed.at[deformedAt(slice, vertex)].normal;
  return scene_arrays.vertices.at[vertex].normal;
}
#else
// Position and normal of a vertex in object space; equal at all slices, because no mesh deforms.
vec3 vertexPosition(uint slice, uint vertex) { return scene_arrays.vertices.at[vertex].position; }
vec3 vertexNormal(uint slice, uint vertex) { return scene_arrays.vertices.at[vertex].normal; }
#endif

// Packed tangent of a vertex of the geometry at the slice, in object space (shared/scene.h); 0: no tangent.
uint vertexTangent(uint slice, SceneGeometry geometry, uint vertex) {
#if FACT_deforms
  if (isDeformed(vertex)) return scene_arrays.deformed.at[deformedAt(slice, vertex)].tangent;
#endif
  if (geometry.first_tangent == NO_TANGENTS) return 0u;
  return scene_arrays.tangents.at[geometry.first_tangent + (vertex - geometry.first_vertex)];
}

// Texture coordinates of a vertex (two sets), and its linear colour.
vec2 vertexUv0(uint vertex) { return scene_arrays.vertices.at[vertex].uv0; }
vec2 vertexUv1(uint vertex) { return scene_arrays.vertices.at[vertex].uv1; }
vec4 vertexColor(uint vertex) { return unpackUnorm4x8(scene_arrays.vertices.at[vertex].color); }

#endif
