-- SPDX-License-Identifier: MIT
-- Blur with one parameter, `quality`, that leads from a post-process gather (0) to ground truth (1). Between these two
-- values, a pixel is gathered if the gather is reliable there. The other pixels trace rays at several times.
local pipeline = require "strobe.pipeline"
local velocity_bounds  = require "passes.cell.velocity_bounds"
local tile_max         = require "passes.tile.tile_max"
local coherent_cells   = require "passes.time.coherent_cells"
local adaptive_times   = require "passes.time.adaptive_times"
local traced           = require "passes.gbuffer.visibility_traced"
local mean             = require "passes.truth.mean"
local gathers   = require "scripts.pipelines.lib.gathers"
local options   = require "scripts.pipelines.lib.options"
local scene     = require "scripts.pipelines.lib.scene"
local adaptive  = require "scripts.pipelines.lib.adaptive"
local tiles     = require "scripts.pipelines.lib.tiles"
local truth     = require "scripts.pipelines.lib.truth"

local weights = "jimenez2014"

local function gathered(p)
  local raster = scene.raster()
  local images = gathers.images(raster, tiles.dominant(p, raster))
  return scene.outputs(raster, { color = gathers.blurred(weights, images, "gather") })
end

local function refined(p)
  local set = adaptive.settings(p.quality(), p.samples())
  local raster = scene.raster()
  local bounds = velocity_bounds { velocity = raster.velocity, runs = "moving_rect" }.bounds
  local max_displacement = tile_max { velocity = raster.velocity }.max_displacement
  local traced_times = pipeline.loop { name = "times", count = 1, times = "midpoint", slices = set.parts + 1, body = function()
    local cells = coherent_cells {
      bounds = bounds, velocity = raster.velocity, id = raster.id, max_displacement = max_displacement,
      apart_px = set.apart_px, time = "sample",
    }
    local made = adaptive_times {
      color = raster.color, depth = raster.depth, id = raster.id, hit = raster.hit, velocity = raster.velocity,
      certain = cells.certain, longest = cells.longest, pace = set.pace, allowance = set.allowance, hit_color = set.hit_color,
      time = "sample",
    }
    return { picture = made.picture, error = made.error }
  end }
  return scene.outputs(raster, { color = traced_times.picture, error = traced_times.error })
end

local function true_times(p)
  local raster = scene.raster(traced)
  local means = truth.everywhere({
    mode = "rays", samples = adaptive.truth_samples(p.quality(), p.samples()), times = "midpoint", slices = 1, pixel = "centre",
    shading = "frozen", mark_regions = false, tolerance = 0, first_samples = 0,
  }, raster)
  local result = mean { mean_a = means.mean_a, mean_b = means.mean_b }
  return scene.outputs(raster, { color = result.color, error = result.error })
end

return pipeline {
  doc = "Blur of adjustable quality, from post-process to ground truth: rays at several times where a gather is not reliable",
  params = {
    options.blur(16),
    quality = pipeline.float { 0.4, min = 0, max = 1, role = "quality",
      doc = "work per picture. 0: the gather of the pipeline ue4. Above 0 and below 0.75: rays at several times where " ..
            "the gather is not reliable. From 0.75 on: ground truth; at 1, its number of time samples is 16 times the " ..
            "parameter `samples`. With limit = 0, every value gives the gather of ue4. The option --budget-ms of " ..
            "`strobe render` and `strobe live` chooses the value from measured frame times" },
  },
  presets = {
    post_process = { doc = "a post-process blur without rays", set = { quality = 0 } },
    few_rays     = { doc = "few rays, only where a gather is not reliable", set = { quality = 0.1 } },
  },
  compare_with = "ue4",
  equals = {
    { when = { quality = 0 }, pipeline = "ue4" },
    { when = { quality = 1, samples = 4 }, pipeline = "ground_truth", set = { samples = 64, mark_regions = false } },
  },
  build = function(p)
    if adaptive.is_gather(p.quality()) or p.limit() == 0 then return gathered(p) end
    return adaptive.is_truth(p.quality()) and true_times(p) or refined(p)
  end,
}
