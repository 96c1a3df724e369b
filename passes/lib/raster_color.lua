-- SPDX-License-Identifier: MIT
-- Parameters of passes that trace rays at other times than the raster time, and take the colours of the hits from the layers of
-- the raster time if they show the hits (shaders/mixin/raster_color.glsl).
local param = require "strobe.param"

return {
  shades_contrast = param.bool { false,
    doc = "shade a hit of a ray if the four texels around the point differ in colour, instead of blending these texels" },
  contrast        = param.float { 0.02, min = 0, max = 1,
    doc = "largest relative difference between the colours of the four texels around a hit at which these texels are " ..
      "still blended; above it, hits on slow surfaces are shaded. Used only with shades_contrast" },
  detail_below  = param.float { 0.75, min = 0, max = 1e6, unit = "px",
    doc = "displacement of a surface between successive samples above which its texels are blended even if they differ; " ..
          "used only with shades_contrast" },
  same_depth    = param.float { 0.01, min = 0, max = 1,
    doc = "largest relative difference between the depth of a hit point and the depth of a texel that shows this point" },
}
