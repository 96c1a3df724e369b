-- SPDX-License-Identifier: MIT
-- Parameters of passes that trace rays at other times and reuse colours of the raster time (shaders/mixin/raster_color.glsl).
local param = require "strobe.param"

return {
  shades_contrast = param.bool { false,
    doc = "shade a hit whose four surrounding texels differ in colour, instead of blending the texels" },
  contrast        = param.float { 0.02, min = 0, max = 1,
    doc = "largest relative difference between the colours of the four texels around a hit that are still blended; used " ..
      "only with shades_contrast" },
  detail_below  = param.float { 0.75, min = 0, max = 1e6, unit = "px",
    doc = "displacement between successive samples above which a surface's texels are blended even if they differ; used " ..
      "only with shades_contrast" },
  same_depth    = param.float { 0.01, min = 0, max = 1,
    doc = "largest relative difference of depths that count as equal" },
}
