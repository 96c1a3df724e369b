-- SPDX-License-Identifier: MIT
-- Per-time layered composite of what raster saw and what was revealed behind it: the description of a pass.
local param  = require "strobe.param"
local blur   = require "passes.lib.blur"
local ports  = require "passes.lib.blur_ports"
local jitter = require "passes.lib.jitter"

-- One table for all, so that they follow the same parameters of a pipeline.
local params = {
  samples      = blur.samples { doc = "time samples" },
  tile         = blur.tile,
  cell_side    = blur.cell_side,
  limit        = blur.limit,
  trajectory   = blur.trajectory,
  taps         = param.choice { "nearest", "linear", default = "nearest", doc = "what of a layer stands for a sample",
    values = {
      nearest = "The texel that is nearest to it. Fails by half a pixel: stairs in textures and highlights.",
      linear = "The four around it, as far as they are there too. Fails by smoothing across the motion.",
    },
    breaks = { linear = { uniform = "texels around a sample are blended, which the mean of nearest ones is not" } } },
  leaves_open  = param.bool { false, wired = true,
    doc = "leave samples out at which no layer has anything, for rays to find" },
  leaves_unlike = param.bool { false, doc = "with leaves_open: so too those between texels that differ" },
  unlike       = param.float { 0.02, min = 0, max = 1, doc = "share of their colour by which these may differ" },
  detail_below = param.float { 0.75, min = 0, max = 1e6, unit = "px",
    doc = "and only of what moves by no more than this from sample to sample: else these are too few for it to show" },
  slowest      = param.float { 0.5, min = 0, max = 100, unit = "px",
    doc = "with leaves_unlike: least difference of displacements between which a silhouette may lie" },
  harvest      = param.bool { true, doc = "also try the displacements met along the dominant one" },
  jitter       = jitter.jitter,
  jitter_frame = jitter.jitter_frame,
}

-- `guesses`: of samples that are left open it also says what layers would have.
return function(name, guesses)
  local copied = { blurred = "color", open = 0, guess = guesses and 0 or nil }
  return {
    name   = name,
    shader = guesses and "layered_guessing" or "composite/layered",
    doc    = "For each time sample, the nearest surface of any layer that is at the pixel then" ..
             (guesses and "; and what stands in for the samples that are left open" or ""),
    fails  = "A surface hidden at the capture and not revealed (a second layer behind, or outside of the mask) is " ..
             "missing. Motion that bends or magnifies by more than about a pixel within the distance moved puts " ..
             "edges wrong. Where more than 4 different motions meet at a pixel some are left out.",
    breaks = {
      mirrored = "of displacements equally long, and of surfaces equally deep, those first in raster order count",
      reversed = "of more than 4 motions around a pixel the nearest count, of equally near ones those before the capture",
    },
    size   = { of = "color" },
    reads  = ports.of_both({
      "second", "after_second", "revealed_dominant", "revealed_after_dominant", "curve", "revealed_curve", "dominant_curve",
      "dominant_place",
    }, {
      moved  = { optional = true,
        doc = "per cell, above 1/2 where something that moves is at some time, elsewhere the picture is copied; absent: 1" },
      doubtful = { optional = true, uint = true,
        doc = "per cell, a bit for each sample at which no layer is to be trusted; with leaves_open" },
      silhouettes = { optional = true,
        doc = "above 1/2 next to something that moves otherwise; with it, samples within a pixel of that are left open" },
      missed = { optional = true,
        doc = "per cell, above 1/2 where something comes that the displacements per tile do not lead to; absent: 0" },
      behind = { optional = true, doc = "per cell, above 1/2 where something revealed is at some time; absent: 1" },
    }),
    writes = {
      blurred = { format = "rgba32f", doc = "linear; alpha 1, with leaves_open the share of samples that are seen" },
      open = { format = "rg32ui", cleared = true,
        doc = "with leaves_open, a bit for each sample at which no layer has anything; of more than 64 for as many " ..
              "together" },
      guess = guesses and { format = "rgba32f", cleared = true,
        doc = "linear, of the samples that are left open what layers say nevertheless, over the number of all; alpha: by " ..
              "how much that may be off" } or nil,
    },
    without = { motion = copied, reached = copied },
    params = params,
    counters = { fallback = "time samples at which no layer had anything to show" },
  }
end
