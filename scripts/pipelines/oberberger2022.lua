-- SPDX-License-Identifier: MIT
-- One ray per pixel at a random time, then a filter along the motion. Oberberger, Chajdas and Westermann 2022.
local pipeline = require "strobe.pipeline"
local blur     = require "passes.lib.blur"
local jitter   = require "passes.lib.jitter"
local along_motion    = require "passes.filter.along_motion"
local motion_variance = require "passes.filter.motion_variance"
local gbuffer         = require "passes.gbuffer.gbuffer"
local stochastic_time = require "passes.time.stochastic_time"
local neighbour_max   = require "passes.tile.neighbour_max"
local scene    = require "scripts.pipelines.lib.scene"
local tiles    = require "scripts.pipelines.lib.tiles"

return pipeline {
  doc = "Oberberger et al. 2022 on one frame: one ray per pixel at a random time, then a wavelet filter along the motion",
  params = {
    octaves = pipeline.int { 4, min = 0, max = 6, doc = "number of filter levels, each twice as wide as the previous level; " ..
                                                     "0: no filter" },
    deviations = along_motion.params.deviations,
    tile   = blur.tile,
    limit  = blur.limit,
    jitter_frame = jitter.jitter_frame,
    displacement = gbuffer.params.displacement,
    tile_rule    = neighbour_max.params.rule,
  },
  build = function(p)
    local raster = scene.raster()
    local dominant = tiles.dominant(p, raster).dominant
    local rays = pipeline.loop { name = "stochastic_times", count = 1, times = "midpoint", slices = 32, body = function()
      local one = stochastic_time { color = raster.color, velocity = raster.velocity, dominant = dominant, time = "sample" }
      return { noisy = one.noisy, moved = one.moved }
    end }
    local color = rays.noisy
    local variance = p.octaves() > 0 and
      motion_variance { noisy = rays.noisy, moved = rays.moved, dominant = dominant }.variance
    for level = 0, p.octaves() - 1 do
      local filtered = along_motion {
        noisy = color, variance = variance, dominant = dominant, octave = level, as = ("level_%d"):format(level),
      }
      color, variance = filtered.blurred, filtered.less
    end
    return scene.outputs(raster, { color = color })
  end,
}
