// SPDX-License-Identifier: MIT
// Needs: scene.
// Vertices of the scene: all that reads them. What changes with the slice is asked for with it.
#ifndef STROBE_VERTEX_GLSL
#define STROBE_VERTEX_GLSL

// The vertex at a corner of a triangle of a geometry. No load by address is checked: a triangle that the geometry does not
// have is its last one.
uint vertexOf(SceneGeometry geometry, uint primitive, uint corner) {
  uint triangle = min(primitive, max(geometry.triangle_count, 1u) - 1u);
  return geometry.first_vertex + scene_arrays.indices.at[geometry.first_index + 3u * triangle + corner];
}

// Object space, at the slice. Of what does not bend it is the same at all.
#if FACT_bends
bool isBending(uint vertex) { return vertex >= scene_arrays.first_bending; }

uint bentAt(uint slice, uint vertex) {
  return slice * scene_arrays.bending_count + (vertex - scene_arrays.first_bending);
}

vec3 vertexPosition(uint slice, uint vertex) {
  if (isBending(vertex)) return scene_arrays.bent.at[bentAt(slice, vertex)].position;
  return scene_arrays.vertices.at[vertex].position;
}

vec3 vertexNormal(uint slice, uint vertex) {
  if (isBending(vertex)) return scene_arrays.bent.at[bentAt(slice, vertex)].normal;
  return scene_arrays.vertices.at[vertex].normal;
}
#else
vec3 vertexPosition(uint slice, uint vertex) { return scene_arrays.vertices.at[vertex].position; }
vec3 vertexNormal(uint slice, uint vertex) { return scene_arrays.vertices.at[vertex].normal; }
#endif

// The packed tangent of a vertex of the geometry, at the slice; 0: none.
uint vertexTangent(uint slice, SceneGeometry geometry, uint vertex) {
#if FACT_bends
  if (isBending(vertex)) return scene_arrays.bent.at[bentAt(slice, vertex)].tangent;
#endif
  if (geometry.first_tangent == NO_TANGENTS) return 0u;
  return scene_arrays.tangents.at[geometry.first_tangent + (vertex - geometry.first_vertex)];
}

vec2 vertexUv0(uint vertex) { return scene_arrays.vertices.at[vertex].uv0; }
vec2 vertexUv1(uint vertex) { return scene_arrays.vertices.at[vertex].uv1; }
vec4 vertexColor(uint vertex) { return unpackUnorm4x8(scene_arrays.vertices.at[vertex].color); }

#endif
