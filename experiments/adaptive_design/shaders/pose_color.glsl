// SPDX-License-Identifier: MIT
// Colours of a pose, which is the scene rasterised at one sample time of the exposure.
// In:  `hit`: surface that each pixel shows in the pose: instance + 1 (0 for the sky), geometry, primitive
//      `drawn`: per cell, above 1/2 where the colours of the pose are wanted; absent: everywhere
//      `rest`: linear radiance of all other cells
//      `color`, `depth`, `id`: raster layer: linear radiance; view depth, metres, +inf for the sky; instance + 1, geometry + 1
// Out: `pose`: linear radiance, alpha 1
// Method: take the colour of the raster layer where it shows the surface (mixin/raster_color.glsl); shade other surfaces.
// Fails: highlights and shadows do not move within the exposure.
#include "mixin/raster_color.glsl"

void run(ivec2 pixel) {
  vec3 color = vec3(rest_at(pixel));
  if (drawn_at(pixel / params.cell_side).x > 0.5) {
    uvec4 ids = texelFetch(hit_tex, pixel, 0);
    Ray ray = cameraRay(TIME_SLICE, samplePosition(pixel));
    color = ids.x == 0u ? environment(ray.direction)
                        : rasterColorOf(hitOnTriangle(TIME_SLICE, ray, ids.x - 1u, ids.y, ids.z));
    if (replaced_radiances > 0u) count_not_finite(replaced_radiances);
  }
  imageStore(pose_img, pixel, vec4(color, 1));
}
