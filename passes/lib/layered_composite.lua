-- SPDX-License-Identifier: MIT
-- Description of a pass that composites the raster layer and the revealed layer per time sample.
local param  = require "strobe.param"
local blur   = require "passes.lib.blur"
local ports  = require "passes.lib.blur_ports"
local jitter = require "passes.lib.jitter"

-- Parameters of the two passes that are made from this description, with and without a fallback estimate. Both passes share
-- these declarations, so that one parameter of a pipeline sets the value in both.
local params = {
  samples      = blur.samples { doc = "number of time samples" },
  tile         = blur.tile,
  cell_side    = blur.cell_side,
  limit        = blur.limit,
  trajectory   = blur.trajectory,
  taps         = param.choice { "nearest", "linear", default = "nearest",
    doc = "interpolation of a layer at the position of a sample",
    values = {
      nearest = "Value of the nearest texel. Fails by errors of half a pixel, which show as stairs in textures and highlights.",
      linear = "Blend of the four surrounding texels, without texels whose surface is elsewhere at the sample's time. Fails " ..
        "by smoothing the image across the direction of motion.",
    },
    breaks = { linear = { uniform = "texels around a sample are blended, which differs from the mean of nearest texels" } } },
  marks_unresolved  = param.bool { false, wired = true,
    doc = "leave unresolved samples out of the mean, so that a later pass traces a ray for each" },
  marks_contrast = param.bool { false,
    doc = "treat samples between texels of different colour as unresolved, so that rays are traced for them; used only with " ..
          "marks_unresolved" },
  contrast       = param.float { 0.02, min = 0, max = 1,
    doc = "largest relative difference of the colours of the texels around a resolved sample; used only with marks_contrast" },
  detail_below = param.float { 0.75, min = 0, max = 1e6, unit = "px",
    doc = "largest displacement of a surface between successive time samples that lets contrast make the samples " ..
          "unresolved. Samples of faster surfaces are too sparse to show such detail. Used only with marks_contrast" },
  slowest      = param.float { 0.5, min = 0, max = 100, unit = "px",
    doc = "smallest difference of the displacements of adjacent texels that counts as a silhouette; used only with " ..
      "marks_contrast" },
  search_taps  = param.bool { true,
    doc = "also try the displacements of texels along the dominant displacement as candidate displacements" },
  jitter       = jitter.jitter,
  jitter_frame = jitter.jitter_frame,
}

-- Returns the description of the pass. With `has_estimate`, the pass also writes a fallback estimate of the unresolved samples.
return function(has_estimate)
  local copied = { blurred = "color", unresolved = 0, fallback_estimate = has_estimate and 0 or nil }
  return {
    doc    = "Composite of the raster layer and the revealed layer: at each time sample, the colour of the nearest surface " ..
             "that is at the pixel at that time. The picture is the mean over the samples" ..
             (has_estimate and "; also a fallback estimate of the unresolved samples" or ""),
    fails  = "A disoccluded surface is missing if no ray revealed it: behind the revealed layer, or outside the mask. Edges " ..
             "are misplaced if the path of a surface deviates from its straight line (or curve), or the surface stretches, " ..
             "by more than about a pixel. If more than 4 different motions meet at a pixel, some are ignored.",
    breaks = {
      mirrored = "among equally long displacements, and among equally deep surfaces, the first in raster order is used",
      reversed = "if a pixel has more than 4 motions around it, the motions of the nearest taps are used; of two equally " ..
        "near taps, the one before the raster time comes first",
    },
    size   = { of = "color" },
    reads  = ports.of_both({
      "second", "second_post", "revealed_dominant", "revealed_dominant_post", "curve", "revealed_curve", "dominant_curve",
      "dominant_place",
    }, {
      moved  = { absent = 1,
        doc = "per cell, above 1/2 if a moving surface is in the cell at some time of the exposure. The colours of other " ..
              "cells are copied" },
      unreliable = { absent = 0, uint = true,
        doc = "per cell, bit i is set if, in time stratum i of at most 32, the layers may lack a surface or store a wrong " ..
              "motion; read only with marks_unresolved" },
      silhouettes = { absent = 0,
        doc = "mask, above 1/2 beside a texel with different motion. Samples that fall between such texels are unresolved" },
      unlisted = { absent = 0,
        doc = "per cell, above 1/2 if a surface may reach the cell by a displacement that differs from all candidate " ..
              "displacements; read only with marks_unresolved" },
      background = { absent = 1,
        doc = "per cell, above 1/2 if a surface revealed behind the raster layer is in the cell at some time of the " ..
              "exposure. The revealed layer is not searched in other cells" },
    }),
    writes = {
      blurred = { format = "rgba32f",
        doc = "blurred picture, linear radiance; alpha 1. With marks_unresolved: sum of the resolved samples, divided by " ..
          "the number of all samples; the alpha is then the fraction of resolved samples" },
      unresolved = { format = "rg32ui", cleared = true,
        doc = "bit i is set if any time sample of stratum i is unresolved; the strata are min(`samples`, 64) equal parts " ..
              "of the samples. Written only with marks_unresolved" },
      fallback_estimate = has_estimate and { format = "rgba32f", cleared = true,
        doc = "fallback estimate of the unresolved samples: sum of their estimated colours, divided by the number of all " ..
              "samples, linear radiance; alpha: expected error, linear radiance" } or nil,
    },
    if_no = { motion = copied, moving_rect = copied },
    params = params,
    counters = { fallback = "time samples that no layer resolves" },
  }
end
