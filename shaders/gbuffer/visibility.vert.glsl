// SPDX-License-Identifier: MIT
// Nearest triangle at each pixel's sample position, vertex stage.
// In:  vertices of the scene, fetched by index and posed at this pass's time (its `time` in the pipeline).
// Out: clip position with reversed depth (infinite for perspective cameras), instance and geometry. If the frame needs them,
//      also texture coordinates, vertex alpha, triangle number and mirroring.
// Method: transform to view space, then to clip space, and shift by the sample offset. On a device without triangle numbers in
//   fragment shaders, each triangle has three vertices of its own, and the index of a vertex gives the triangle number.
// Fails: never; but rasterisation snaps the positions to 1/256 px.
#include "mixin/surface.glsl"

layout(location = 0) flat out uvec2 draw;  // instance, geometry
#if FACT_alpha
layout(location = 1) out vec2 uv0;
layout(location = 2) out vec2 uv1;
layout(location = 3) out float alpha;
#endif
#ifdef STROBE_SEPARATE_TRIANGLES
layout(location = 4) flat out uint triangle;
#endif
#if FACT_one_sided
layout(location = 5) flat out uint mirrored;
#endif
#if FACT_blend
layout(location = 6) out vec3 position_os;
#endif

void main() {
  SceneDraw self = scene_draws[gl_InstanceIndex];
#ifdef STROBE_SEPARATE_TRIANGLES
  SceneGeometry geometry = geometryOf(self.instance, self.geometry);
  triangle = (uint(gl_VertexIndex) - geometry.first_index) / 3u;
  uint vertex = vertexOf(geometry, 0u, uint(gl_VertexIndex) - geometry.first_index);
#else
  uint vertex = uint(gl_VertexIndex);
#endif
  SceneCamera camera = scene_cameras[TIME_SLICE];
  SceneTransform transform = transformOf(TIME_SLICE, self.instance);
  vec3 vertex_os = vertexPosition(TIME_SLICE, vertex);
  vec3 p = viewFromWorld(TIME_SLICE, worldFromObject(transform, vertex_os));
  draw = uvec2(self.instance, self.geometry);
#if FACT_alpha
  uv0 = vertexUv0(vertex);
  uv1 = vertexUv1(vertex);
  alpha = vertexColor(vertex).a;
#endif
#if FACT_one_sided
  mirrored = dot(transform.row_x.xyz, cross(transform.row_y.xyz, transform.row_z.xyz)) < 0.0 ? 1u : 0u;
#endif
#if FACT_blend
  position_os = vertexPosition(SLICE_RASTER, vertex);
#endif

  // A sample offset to the right shifts the image to the left. The depth is near / z for a perspective camera, and the
  // remaining share of the depth range for an orthographic camera: 1 at the near plane, 0 at the end of the range. Nearer
  // points have larger depths.
  vec2 shift = vec2(-2, -2) * frame.subpixel / vec2(frame.size);
  if (camera.orthographic != 0u) {
    vec2 ndc = p.xy / camera.half_extent;
    gl_Position = vec4(vec2(ndc.x, -ndc.y) + shift, 1.0 - (p.z - camera.near) / camera.depth_range, 1.0);
  } else {
    vec2 xy = p.xy / camera.half_extent;
    gl_Position = vec4(vec2(xy.x, -xy.y) + shift * p.z, camera.near, p.z);
  }
}
