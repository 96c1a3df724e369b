-- SPDX-License-Identifier: MIT
-- Description of a pass that composites the raster layer and the revealed layer per time sample.
local param  = require "strobe.param"
local blur   = require "passes.lib.blur"
local ports  = require "passes.lib.blur_ports"
local jitter = require "passes.lib.jitter"

-- One table for all variants, so that they follow the same parameters of a pipeline.
local params = {
  samples      = blur.samples { doc = "number of time samples" },
  tile         = blur.tile,
  cell_side    = blur.cell_side,
  limit        = blur.limit,
  trajectory   = blur.trajectory,
  taps         = param.choice { "nearest", "linear", default = "nearest", doc = "interpolation of a layer at a sample",
    values = {
      nearest = "Nearest texel. Fails by half a pixel: stairs in textures and highlights.",
      linear = "Blend of the four surrounding texels, without those whose surface is elsewhere at the sample's time. Fails " ..
        "by smoothing across the motion.",
    },
    breaks = { linear = { uniform = "texels around a sample are blended, which differs from the mean of nearest texels" } } },
  marks_unresolved  = param.bool { false, wired = true,
    doc = "leave unresolved samples out of the mean, so that a later pass traces a ray for each" },
  marks_contrast = param.bool { false,
    doc = "treat samples between texels of different colour as unresolved; with marks_unresolved" },
  contrast       = param.float { 0.02, min = 0, max = 1,
    doc = "largest relative difference of the colours of the texels around a resolved sample; with marks_contrast" },
  detail_below = param.float { 0.75, min = 0, max = 1e6, unit = "px",
    doc = "largest displacement between successive samples of a surface whose differing texels leave samples " ..
      "unresolved; with marks_contrast. Samples of faster surfaces are too sparse to show such detail" },
  slowest      = param.float { 0.5, min = 0, max = 100, unit = "px",
    doc = "smallest difference of the displacements of adjacent texels that counts as a silhouette; with marks_contrast" },
  search_taps  = param.bool { true, doc = "add the displacements found along the dominant one to the candidates" },
  jitter       = jitter.jitter,
  jitter_frame = jitter.jitter_frame,
}

-- `has_estimate`: also write a fallback estimate of the unresolved samples.
return function(has_estimate)
  local copied = { blurred = "color", unresolved = 0, fallback_estimate = has_estimate and 0 or nil }
  return {
    doc    = "For each time sample, the nearest surface of either layer that is at the pixel then" ..
             (has_estimate and "; also a fallback estimate of the unresolved samples" or ""),
    fails  = "Disoccluded surfaces that were not revealed (a second layer behind, or outside the mask) are missing. " ..
             "Edges are misplaced if the path deviation or the stretch of a surface exceeds about a pixel within the " ..
             "distance moved. If more than 4 different motions meet at a pixel, some are ignored.",
    breaks = {
      mirrored = "among equally long displacements, and among equally deep surfaces, the first in raster order is used",
      reversed = "of more than 4 motions around a pixel the nearest are used; among equally near ones, the one before the " ..
        "raster time",
    },
    size   = { of = "color" },
    reads  = ports.of_both({
      "second", "second_post", "revealed_dominant", "revealed_dominant_post", "curve", "revealed_curve", "dominant_curve",
      "dominant_place",
    }, {
      moved  = { absent = 1,
        doc = "per cell, above 1/2 if a moving surface is there at some time; other cells are copied" },
      unreliable = { absent = 0, uint = true,
        doc = "per cell, bit i is set if both layers are unreliable in time stratum i of at most 32; with marks_unresolved" },
      silhouettes = { absent = 0,
        doc = "mask, above 1/2 beside a texel with different motion; samples within a pixel of such a silhouette are " ..
          "unresolved" },
      unlisted = { absent = 0,
        doc = "per cell, above 1/2 if a surface with a motion outside the candidates reaches the cell" },
      background = { absent = 1, doc = "per cell, above 1/2 if a revealed surface is there at some time" },
    }),
    writes = {
      blurred = { format = "rgba32f",
        doc = "blurred picture, linear radiance; alpha 1. With marks_unresolved: sum of the resolved samples, divided by " ..
          "the number of all samples; alpha: fraction of resolved samples" },
      unresolved = { format = "rg32ui", cleared = true,
        doc = "bit i is set if time stratum i of at most 64 is unresolved; with marks_unresolved" },
      fallback_estimate = has_estimate and { format = "rgba32f", cleared = true,
        doc = "fallback estimate, linear radiance: sum of the unresolved samples, divided by the number of all samples; " ..
              "alpha: estimated error, linear radiance" } or nil,
    },
    if_no = { motion = copied, moving_rect = copied },
    params = params,
    counters = { fallback = "time samples that no layer resolves" },
  }
end
