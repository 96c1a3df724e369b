-- SPDX-License-Identifier: MIT
-- Parameters of passes that trace rays at other times and reuse colours of the raster time (shaders/mixin/raster_color.glsl).
local param = require "strobe.param"

return {
  shades_contrast = param.bool { false,
    doc = "shade a hit whose four surrounding texels differ in colour, instead of blending the texels" },
  contrast        = param.float { 0.02, min = 0, max = 1,
    doc = "largest relative difference between the colours of the four texels around a hit that are blended; with " ..
      "shades_contrast" },
  detail_below  = param.float { 0.75, min = 0, max = 1e6, unit = "px",
    doc = "largest displacement between successive samples of a surface that is shaded where texels differ; with " ..
      "shades_contrast" },
  same_depth    = param.float { 0.01, min = 0, max = 1,
    doc = "relative tolerance for equal depths" },
}
