// SPDX-License-Identifier: MIT
// Needs: scene.
// Access to the vertices of the scene. Attributes that change with time are functions of the slice.
#ifndef STROBE_VERTEX_GLSL
#define STROBE_VERTEX_GLSL

// Index of the vertex at a corner of a geometry's triangle. Loads by address are not checked, so an index above the last
// triangle is replaced by the last triangle.
uint vertexOf(SceneGeometry geometry, uint primitive, uint corner) {
  uint triangle = min(primitive, max(geometry.triangle_count, 1u) - 1u);
  return geometry.first_vertex + scene_arrays.indices.at[geometry.first_index + 3u * triangle + corner];
}

// Positions and normals in object space, at the slice. Vertices of rigid meshes are the same at all slices.
#if FACT_deforms
// True if the vertex deforms.
bool isDeformed(uint vertex) { return vertex >= scene_arrays.first_deformed; }

uint deformedAt(uint slice, uint vertex) {
  return slice * scene_arrays.deformed_count + (vertex - scene_arrays.first_deformed);
}

vec3 vertexPosition(uint slice, uint vertex) {
  if (isDeformed(vertex)) return scene_arrays.deformed.at[deformedAt(slice, vertex)].position;
  return scene_arrays.vertices.at[vertex].position;
}

vec3 vertexNormal(uint slice, uint vertex) {
  if (isDeformed(vertex)) return scene_arrays.deformed.at[deformedAt(slice, vertex)].normal;
  return scene_arrays.vertices.at[vertex].normal;
}
#else
vec3 vertexPosition(uint slice, uint vertex) { return scene_arrays.vertices.at[vertex].position; }
vec3 vertexNormal(uint slice, uint vertex) { return scene_arrays.vertices.at[vertex].normal; }
#endif

// Packed tangent of a vertex of the geometry at the slice; 0: no tangent.
uint vertexTangent(uint slice, SceneGeometry geometry, uint vertex) {
#if FACT_deforms
  if (isDeformed(vertex)) return scene_arrays.deformed.at[deformedAt(slice, vertex)].tangent;
#endif
  if (geometry.first_tangent == NO_TANGENTS) return 0u;
  return scene_arrays.tangents.at[geometry.first_tangent + (vertex - geometry.first_vertex)];
}

vec2 vertexUv0(uint vertex) { return scene_arrays.vertices.at[vertex].uv0; }
vec2 vertexUv1(uint vertex) { return scene_arrays.vertices.at[vertex].uv1; }
vec4 vertexColor(uint vertex) { return unpackUnorm4x8(scene_arrays.vertices.at[vertex].color); }

#endif
