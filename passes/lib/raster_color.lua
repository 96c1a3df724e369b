-- SPDX-License-Identifier: MIT
-- Parameters of passes that trace rays at other times than the raster time, and take the colours of the hits from the
-- layers of the raster time if these layers show the hit points (shaders/mixin/raster_color.glsl).
local param = require "strobe.param"

return {
  shades_contrast = param.bool { false,
    doc = "shade a hit of a ray if the four texels around the hit differ in colour, instead of blending these texels" },
  contrast        = param.float { 0.02, min = 0, max = 1,
    doc = "bound on the relative difference between the colours of the four texels around a hit. Up to the bound, " ..
      "these texels are blended; above the bound, a hit on a slow surface is shaded. Used only with shades_contrast" },
  detail_below  = param.float { 0.75, min = 0, max = 1e6, unit = "px",
    doc = "bound on the displacement of a surface between successive samples. If the surface moves farther, its " ..
          "texels are blended even if their colours differ. Used only with shades_contrast" },
  same_depth    = param.float { 0.01, min = 0, max = 1,
    doc = "largest relative difference between the depth of a hit point and the depth of a texel that shows this point" },
}
