-- SPDX-License-Identifier: MIT
-- Rival of the pipeline `adaptive`. In the cells where everything moves, it averages poses: images of the scene rasterised at
-- several times. All other cells are computed as in `adaptive`.
local pipeline = require "strobe.pipeline"
local velocity_bounds = require "passes.cell.velocity_bounds"
local tile_max        = require "passes.tile.tile_max"
local coherent_cells  = require "passes.time.coherent_cells"
local adaptive_times  = require "passes.time.adaptive_times"
local visibility      = require "passes.gbuffer.visibility"
local accumulate      = require "passes.truth.accumulate"
local mean            = require "passes.truth.mean"
local stop            = require "passes.truth.stop"
local drawn_cells     = require "passes.drawn_cells"
local pose_color      = require "passes.pose_color"
local adaptive = require "scripts.pipelines.lib.adaptive"
local options  = require "scripts.pipelines.lib.options"
local scene    = require "scripts.pipelines.lib.scene"

return pipeline {
  doc = "The pipeline adaptive, but with the mean of images rasterised at several times where everything moves",
  params = {
    options.blur(16),
    quality = pipeline.float { 0.4, min = 0.05, max = 0.7, doc = "quality of the pipeline adaptive" },
    poses   = pipeline.int { 16, min = 1, max = 256, doc = "number of rasterised images, each at another time" },
  },
  build = function(p)
    local set = adaptive.settings(p.quality(), p.samples())
    local raster = scene.raster()
    local bounds = velocity_bounds { velocity = raster.velocity, runs = "moving_rect" }.bounds
    local max_displacement = tile_max { velocity = raster.velocity }.max_displacement
    local traced = pipeline.loop { name = "times", count = 1, times = "midpoint", slices = set.parts + 1, body = function()
      local cells = coherent_cells {
        bounds = bounds, velocity = raster.velocity, id = raster.id, max_displacement = max_displacement,
        apart_px = set.apart_px, time = "sample",
      }
      local found = drawn_cells { bounds = bounds, certain = cells.certain, longest = cells.longest }
      local made = adaptive_times {
        color = raster.color, depth = raster.depth, id = raster.id, hit = raster.hit, velocity = raster.velocity,
        certain = found.untraced, longest = found.first_ray, pace = set.pace, allowance = set.allowance,
        hit_color = set.hit_color, time = "sample",
      }
      return { picture = made.picture, drawn = found.drawn }
    end }
    -- The loop ends after one pose if no cell is drawn.
    local poses = pipeline.loop {
      name = "poses", count = p.poses, times = "midpoint", until_ = function(results) return results.stop end,
      body = function()
        local pose = pose_color {
          hit = visibility { time = "sample", as = "pose_visibility" }.hit, drawn = traced.drawn, rest = traced.picture,
          color = raster.color, depth = raster.depth, id = raster.id, time = "sample",
          shades_contrast = set.hit_color == "shaded",
        }.pose
        local sum = accumulate { color = pose }
        local none_drawn = stop { half_difference = traced.drawn, tolerance = 0, min_samples = 1 }.stop
        return { mean_a = sum.mean_a, mean_b = sum.mean_b, stop = none_drawn }
      end,
    }
    return scene.outputs(raster, { color = mean { mean_a = poses.mean_a, mean_b = poses.mean_b }.color })
  end,
}
