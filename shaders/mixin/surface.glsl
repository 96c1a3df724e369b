// SPDX-License-Identifier: MIT
// Needs: scene; may have: PARAM_displacement.
// Attributes, positions and screen paths of surface points, which are given as hits (lib/hit.glsl), at any slice.
#ifndef STROBE_SURFACE_GLSL
#define STROBE_SURFACE_GLSL
#include "mixin/camera.glsl"
#include "mixin/vertex.glsl"

// Indices of the three vertices of a triangle.
struct Triangle {
  uint vertex[3];
};

// Vertices of a triangle of the geometry. `primitive`: number of the triangle within the geometry.
Triangle triangleOf(SceneGeometry geometry, uint primitive) {
  Triangle triangle;
  for (uint corner = 0u; corner < 3u; ++corner) triangle.vertex[corner] = vertexOf(geometry, primitive, corner);
  return triangle;
}

// World position of a position in object space.
vec3 worldFromObject(SceneTransform transform, vec3 position_os) {
  vec4 p = vec4(position_os, 1);
  return vec3(dot(transform.row_x, p), dot(transform.row_y, p), dot(transform.row_z, p));
}

// Normal in world space from a normal in object space; not of unit length. The cofactors of the transform's matrix give correct
// normals under non-uniform scale and mirroring, without an inverse.
vec3 normalFromObject(SceneTransform transform, vec3 normal_os) {
  vec3 x = transform.row_x.xyz, y = transform.row_y.xyz, z = transform.row_z.xyz;
  vec3 c0 = cross(y, z), c1 = cross(z, x), c2 = cross(x, y);
  float flip = dot(x, c0) < 0.0 ? -1.0 : 1.0;
  return flip * vec3(dot(c0, normal_os), dot(c1, normal_os), dot(c2, normal_os));
}

// Unit vector along v; `fallback` if v is 0 or infinite. The largest component is divided out first, so that the squares of
// components stay within range at any scale.
vec3 unitOr(vec3 v, vec3 fallback) {
  float largest = max(abs(v.x), max(abs(v.y), abs(v.z)));
  if (!(largest > 0.0) || isinf(largest)) return fallback;
  v /= largest;
  return v * inversesqrt(dot(v, v));
}

// Weights of the three corners of a triangle from barycentric coordinates (the weights of the second and third corner).
vec3 cornerWeights(vec2 barycentrics) { return vec3(1.0 - barycentrics.x - barycentrics.y, barycentrics); }

// World position of a hit point, with the scene posed at `slice`.
vec3 positionOf(uint slice, Hit hit) {
  Triangle triangle = triangleOf(geometryOf(hit.instance, hit.geometry), hit.primitive);
  vec3 weights = cornerWeights(hit.barycentrics);
  vec3 position_os = vec3(0);
  for (uint corner = 0u; corner < 3u; ++corner)
    position_os += weights[corner] * vertexPosition(slice, triangle.vertex[corner]);
  return worldFromObject(transformOf(slice, hit.instance), position_os);
}

// Position of a hit point in the raster image. `place`: output; xy: texel coordinates, with whole numbers at the centres of
// texels; z: view depth at the raster time, metres. Returns false if the camera is a perspective camera and the point
// is not beyond its near plane.
bool placeInRaster(Hit hit, out vec3 place) {
  vec3 raster_vs = viewFromWorld(SLICE_RASTER, positionOf(SLICE_RASTER, hit));
  place = vec3(pixelFromView(SLICE_RASTER, raster_vs) - frame.subpixel - 0.5, raster_vs.z);
  SceneCamera camera = scene_cameras[SLICE_RASTER];
  return camera.orthographic != 0u || raster_vs.z > camera.near;
}

// True if the hit instance is proven static within the exposure. Also true for a miss, because the sky moves only with the
// camera.
bool isAtRest(Hit hit) { return !isHit(hit) || instanceAt(hit.instance).moves == 0u; }

// True if the instance deforms: its vertices move relative to each other, by joints or morph targets.
bool deforms(uint instance) {
#if FACT_deforms
  return isDeformed(geometryOf(instance, 0u).first_vertex);
#else
  return false;
#endif
}

// World position at `slice` of a point that is fixed to an instance and is at `position_ws` at the raster time. NaN for
// deformed instances, which have no single transform; a test of a distance against a bound is then false.
vec3 carriedBy(uint instance, uint slice, vec3 position_ws) {
#if FACT_deforms
  if (deforms(instance)) return vec3(uintBitsToFloat(0x7fc00000u));
#endif
  SceneTransform m = transformOf(SLICE_RASTER, instance);
  mat3 rows = mat3(m.row_x.xyz, m.row_y.xyz, m.row_z.xyz);
  vec3 position_os = inverse(transpose(rows)) * (position_ws - vec3(m.row_x.w, m.row_y.w, m.row_z.w));
  return worldFromObject(transformOf(slice, instance), position_os);
}

// Attributes of a surface point, with the scene posed at the time of one slice (SLICE_RASTER and others).
struct Surface {
  vec3 position_ws;
  vec3 face_normal_ws;  // unit normal of the triangle, on the side that the ray hit
  vec3 normal_ws;       // unit normal interpolated from the vertices, on the side that the ray hit
  float normal_side;    // -1 if the vertices' normals are on the other side, so that normal_ws is reversed; otherwise 1
  vec2 uv0, uv1;        // two sets of texture coordinates
  vec4 color;           // vertex colour, linear
  vec3 edge1_ws, edge2_ws;      // corner 1 - corner 0, corner 2 - corner 0
  vec2 uv0_edge1, uv0_edge2, uv1_edge1, uv1_edge2;  // changes of uv0 and uv1 along these edges
  uint material;        // index into scene_materials
};

// Attributes of a hit point, with the scene posed at `slice`.
Surface surfaceOf(uint slice, Hit hit) {
  SceneGeometry geometry = geometryOf(hit.instance, hit.geometry);
  SceneTransform transform = transformOf(slice, hit.instance);
  Triangle triangle = triangleOf(geometry, hit.primitive);
  uint a = triangle.vertex[0], b = triangle.vertex[1], c = triangle.vertex[2];
  vec3 a_os = vertexPosition(slice, a), b_os = vertexPosition(slice, b), c_os = vertexPosition(slice, c);
  vec3 weights = cornerWeights(hit.barycentrics);

  Surface surface;
  vec3 position_os = weights.x * a_os + weights.y * b_os + weights.z * c_os;
  surface.position_ws = worldFromObject(transform, position_os);
  float side = hit.front ? 1.0 : -1.0;
  vec3 face_os = cross(b_os - a_os, c_os - a_os);
  surface.face_normal_ws = side * unitOr(normalFromObject(transform, face_os), vec3(0, 1, 0));
  vec3 normal_os =
      weights.x * vertexNormal(slice, a) + weights.y * vertexNormal(slice, b) + weights.z * vertexNormal(slice, c);
  vec3 normal_ws = unitOr(normalFromObject(transform, normal_os), side * surface.face_normal_ws);
  // Orient the interpolated normal by the face normal, because some meshes have vertex normals that disagree with their
  // winding.
  surface.normal_side = dot(normal_ws, surface.face_normal_ws) < 0.0 ? -1.0 : 1.0;
  surface.normal_ws = surface.normal_side * normal_ws;
  vec2 a_uv0 = vertexUv0(a), b_uv0 = vertexUv0(b), c_uv0 = vertexUv0(c);
  vec2 a_uv1 = vertexUv1(a), b_uv1 = vertexUv1(b), c_uv1 = vertexUv1(c);
  surface.uv0 = weights.x * a_uv0 + weights.y * b_uv0 + weights.z * c_uv0;
  surface.uv1 = weights.x * a_uv1 + weights.y * b_uv1 + weights.z * c_uv1;
  // Interpolate the colour by differences: three equal corner colours then give exactly this colour, although the weights are
  // rounded.
  vec4 color = vertexColor(a);
  surface.color = color + weights.y * (vertexColor(b) - color) + weights.z * (vertexColor(c) - color);
  surface.edge1_ws = worldFromObject(transform, b_os) - worldFromObject(transform, a_os);
  surface.edge2_ws = worldFromObject(transform, c_os) - worldFromObject(transform, a_os);
  surface.uv0_edge1 = b_uv0 - a_uv0;
  surface.uv0_edge2 = c_uv0 - a_uv0;
  surface.uv1_edge1 = b_uv1 - a_uv1;
  surface.uv1_edge2 = c_uv1 - a_uv1;
  surface.material = geometry.material;
  return surface;
}

// Unpacked tangent of a vertex, as packed by `packedTangent` (runtime/world/tangent.h). xyz: unit direction in object space. w:
// handedness, 1 or -1; 0 without a tangent.
vec4 unpackedTangent(uint packed) {
  if ((packed & TANGENT_PRESENT) == 0u) return vec4(0);
  const uint mask = (1u << TANGENT_BITS) - 1u;
  vec2 flat_os = vec2(packed & mask, (packed >> TANGENT_BITS) & mask) / TANGENT_LARGEST - 1.0;
  vec3 direction = vec3(flat_os, 1.0 - abs(flat_os.x) - abs(flat_os.y));
  float fold = max(-direction.z, 0.0);
  direction.x += direction.x >= 0.0 ? -fold : fold;
  direction.y += direction.y >= 0.0 ? -fold : fold;
  return vec4(normalize(direction), (packed & TANGENT_NEGATIVE) != 0u ? -1.0 : 1.0);
}

// Tangent at a hit point, interpolated from the vertices, with the scene posed at `slice`. xyz: direction in world space, not
// of unit length. w: handedness, 1 or -1; 0 if a vertex of the triangle has no tangent.
vec4 tangentOf(uint slice, Hit hit) {
  SceneGeometry geometry = geometryOf(hit.instance, hit.geometry);
  Triangle triangle = triangleOf(geometry, hit.primitive);
  vec3 weights = cornerWeights(hit.barycentrics);
  vec3 tangent_os = vec3(0);
  float handedness = 0.0;
  for (uint corner = 0u; corner < 3u; ++corner) {
    vec4 tangent = unpackedTangent(vertexTangent(slice, geometry, triangle.vertex[corner]));
    if (tangent.w == 0.0) return vec4(0);
    tangent_os += weights[corner] * tangent.xyz;
    handedness = tangent.w;
  }
  SceneTransform m = transformOf(slice, hit.instance);
  vec3 x = m.row_x.xyz, y = m.row_y.xyz, z = m.row_z.xyz;
  float mirrored = dot(x, cross(y, z)) < 0.0 ? -1.0 : 1.0;
  return vec4(dot(x, tangent_os), dot(y, tangent_os), dot(z, tangent_os), handedness * mirrored);
}

// World position at `slice` of a hit point that is at `raster_ws` at the raster time. The function adds the differences between
// both poses to `raster_ws`. Static points therefore stay exactly in place, and a point of a large mesh is as precise as the
// ray that hit it.
vec3 movedTo(uint slice, Hit hit, vec3 raster_ws) {
  SceneTransform then = transformOf(slice, hit.instance), now = transformOf(SLICE_RASTER, hit.instance);
  SceneTransform step = SceneTransform(then.row_x - now.row_x, then.row_y - now.row_y, then.row_z - now.row_z);
  Triangle triangle = triangleOf(geometryOf(hit.instance, hit.geometry), hit.primitive);
  vec3 weights = cornerWeights(hit.barycentrics);
  vec3 position_os = vec3(0);
  for (uint corner = 0u; corner < 3u; ++corner)
    position_os += weights[corner] * vertexPosition(slice, triangle.vertex[corner]);
#if FACT_deforms
  if (isDeformed(triangle.vertex[0])) {
    vec3 step_os = vec3(0);
    for (uint corner = 0u; corner < 3u; ++corner)
      step_os += weights[corner] * (vertexPosition(slice, triangle.vertex[corner]) -
                                    vertexPosition(SLICE_RASTER, triangle.vertex[corner]));
    raster_ws += vec3(dot(now.row_x.xyz, step_os), dot(now.row_y.xyz, step_os), dot(now.row_z.xyz, step_os));
  }
#endif
  return raster_ws + worldFromObject(step, position_os);
}

// Screen position of a hit point at the time of `slice` minus its position at the raster time, px. `raster_ws`: world position
// of the point at the raster time.
vec2 pathOf(uint slice, Hit hit, vec3 raster_ws) {
  vec3 raster_vs = viewFromWorld(SLICE_RASTER, raster_ws);
  return pathFromRasterTime(raster_vs, slice, viewFromWorld(slice, movedTo(slice, hit, raster_ws)));
}

// Screen position of a point that is fixed to a rigid instance, at the time of `slice`, minus its position at the raster time,
// px. `position_ws`: world position of the point at the raster time.
vec2 pathOfPoint(uint slice, uint instance, vec3 position_ws) {
  vec3 raster_vs = viewFromWorld(SLICE_RASTER, carriedBy(instance, SLICE_RASTER, position_ws));
  return pathFromRasterTime(raster_vs, slice, viewFromWorld(slice, carriedBy(instance, slice, position_ws)));
}

// View depth of the near plane for points of the sky. These points are directions that are scaled to a view depth of 1 at the
// raster time, so the camera's near distance in metres does not apply to them.
const float kSkyNear = 1.0 / 64.0;

// Screen position of an infinitely distant point at the time of `slice` minus its position at the raster time, px. The point
// moves with the camera's rotation alone. `direction_ws`: direction of the camera ray through the point at the raster time; its
// view depth is 1.
vec2 pathOfSky(uint slice, vec3 direction_ws) {
  if (scene_cameras[SLICE_RASTER].orthographic != 0u) return vec2(0);
  vec3 raster_vs = viewFromWorld(SLICE_RASTER, scene_cameras[SLICE_RASTER].position + direction_ws);
  vec3 other_vs = viewFromWorld(slice, scene_cameras[slice].position + direction_ws);
  return pathFromRasterTime(raster_vs, slice, other_vs, kSkyNear);
}

// Screen displacement of a hit point over the exposure, px: its position at shutter close minus its position at shutter open.
// With the parameter `displacement` = extrapolated, the displacement is instead the path since the previous frame, times the
// length of the exposure in frames, for every anchor. `raster_ws`: world position of the point at the raster time.
vec2 displacementOf(Hit hit, vec3 raster_ws) {
#if defined(PARAM_displacement) && PARAM_displacement == displacement_extrapolated
  return -frame.exposure * pathOf(SLICE_PREVIOUS, hit, raster_ws);
#else
  return pathOf(SLICE_SHUTTER_CLOSE, hit, raster_ws) - pathOf(SLICE_SHUTTER_OPEN, hit, raster_ws);
#endif
}

// Screen displacement of the sky over the exposure, px, as in `displacementOf`. `direction_ws`: as in `pathOfSky`.
vec2 displacementOfSky(vec3 direction_ws) {
#if defined(PARAM_displacement) && PARAM_displacement == displacement_extrapolated
  return -frame.exposure * pathOfSky(SLICE_PREVIOUS, direction_ws);
#else
  return pathOfSky(SLICE_SHUTTER_CLOSE, direction_ws) - pathOfSky(SLICE_SHUTTER_OPEN, direction_ws);
#endif
}

// Hit of a camera's ray on a known triangle, for example the triangle that the raster layer shows, with the scene posed at
// `slice`. Raster layer and rays use this one function, so their results are equal. A point just outside of the triangle, which
// the raster includes by rounding, is moved to the triangle's border. If the triangle is degenerate or seen edge-on, the hit is
// its centre. `geometry_index`: geometry within the instance. `primitive`: triangle within the geometry.
Hit hitOnTriangle(uint slice, Ray ray, uint instance, uint geometry_index, uint primitive) {
  SceneTransform transform = transformOf(slice, instance);
  Triangle triangle = triangleOf(geometryOf(instance, geometry_index), primitive);
  vec3 a = worldFromObject(transform, vertexPosition(slice, triangle.vertex[0]));
  vec3 edge1 = worldFromObject(transform, vertexPosition(slice, triangle.vertex[1])) - a;
  vec3 edge2 = worldFromObject(transform, vertexPosition(slice, triangle.vertex[2])) - a;
  vec3 p = cross(ray.direction, edge2);
  float determinant = dot(edge1, p);
  vec3 from_corner = ray.origin - a;
  vec3 q = cross(from_corner, edge1);
  vec2 barycentrics = vec2(dot(from_corner, p), dot(ray.direction, q)) / determinant;
  if (any(isnan(barycentrics)) || any(isinf(barycentrics))) barycentrics = vec2(1.0 / 3.0);
  vec3 weights = max(cornerWeights(barycentrics), vec3(0));
  weights /= weights.x + weights.y + weights.z;
  vec3 position_ws = a + weights.y * edge1 + weights.z * edge2;
  // A mirroring transform reverses the winding of the corners.
  float handed = dot(transform.row_x.xyz, cross(transform.row_y.xyz, transform.row_z.xyz));
  bool front = (determinant > 0.0) == (handed >= 0.0);
  float t = viewFromWorld(slice, position_ws).z;
  // If a triangle has distant corners, the rounding errors of the corner positions can be as large as objects near the
  // camera. For such a triangle, take t from the intersection of the ray with the triangle's plane, which is more
  // accurate.
  vec3 reach = max(abs(edge1), abs(edge2));
  bool large = max(reach.x, max(reach.y, reach.z)) > 16.0 * t;
  bool inside = all(greaterThanEqual(cornerWeights(barycentrics), vec3(0)));
  if (large && inside) t = dot(edge2, q) / determinant;
  return Hit(instance, geometry_index, primitive, weights.yz, t, front);
}

#endif
