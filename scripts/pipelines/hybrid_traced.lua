-- SPDX-License-Identifier: MIT
-- Extension of the pipeline `hybrid_layered`: if the two layers do not give the colour of a time sample, a ray at the time of
-- that sample gives it.
local pass     = require "strobe.pass"
local pipeline = require "strobe.pipeline"
local layered  = require "passes.layered.layered_composite"
local layers   = require "scripts.pipelines.lib.layers"
local options  = require "scripts.pipelines.lib.options"
local paths    = require "scripts.pipelines.lib.paths"
local time_samples = require "scripts.pipelines.lib.time_samples"

local by_cell = "cells decide which samples are traced, and the grid of cells starts at the corner of the picture"
local by_threshold = "thresholds decide which samples are traced, and rounding may cross a threshold"
-- Displacement below which a silhouette counts as static, px over the exposure. A slower silhouette changes the coverage of a
-- pixel by less than 0.02.
local slowest = 0.02

return pipeline {
  doc = "Hybrid like hybrid_layered, with a ray for each time sample that its two layers do not resolve",
  params = { options.tiles(40), range = paths.range, trajectory = layered.params.trajectory },
  breaks = { mirrored = by_cell, shifted = by_cell, scaled = by_threshold },
  compare_with = "mcguire2012",
  build = function(p)
    paths.require_curves(p, layered, "hybrid_traced")
    local both = layers.both(p)
    local raster, revealed = both.raster, both.revealed
    local images = layers.images(p, raster, revealed, layered, slowest)
    images.unreliable = time_samples.unreliable(p, raster, revealed)
    images.silhouettes = time_samples.silhouettes(raster, slowest)
    local made = layered(pass.wired(layered, images, {
      as = "composite", taps = "linear", marks_unresolved = true, marks_contrast = true, slowest = slowest,
    }))
    return layers.outputs(p, both, time_samples.traced(p, raster, revealed, made))
  end,
}
