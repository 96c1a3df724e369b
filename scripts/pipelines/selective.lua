-- SPDX-License-Identifier: MIT
-- One parameter from a post-process blur to ground truth: a gather where it is certain, rays at several times elsewhere.
local pipeline = require "strobe.pipeline"
local motion_bounds  = require "passes.tile.motion_bounds"
local tile_max       = require "passes.tile.tile_max"
local longest_motion = require "passes.tile.longest_motion"
local uniform_motion = require "passes.tile.uniform_motion"
local refined_time   = require "passes.scene.refined_time"
local traced         = require "passes.scene.visibility_traced"
local mean           = require "passes.truth.mean"
local gathers   = require "scripts.pipelines.lib.gathers"
local options   = require "scripts.pipelines.lib.options"
local scene     = require "scripts.pipelines.lib.scene"
local selective = require "scripts.pipelines.lib.selective"
local tiles     = require "scripts.pipelines.lib.tiles"
local truth     = require "scripts.pipelines.lib.truth"

local weights = "jimenez2014"

local function gathered(p)
  local seen = scene.captured()
  local images = gathers.images(seen, tiles.dominant(p, seen))
  return scene.outputs(seen, { color = gathers.blurred(weights, images, "gather") })
end

local function refined(p)
  local set = selective.settings(p.effort(), p.samples())
  local seen = scene.captured()
  local bounds = motion_bounds { velocity = seen.velocity, all_count = true }.bounds
  local reach = longest_motion { longest = tile_max { velocity = seen.velocity }.longest }.reach
  local color = pipeline.loop { name = "times", count = 1, times = "midpoint", slices = set.parts + 1, body = function()
    local cells = uniform_motion {
      bounds = bounds, velocity = seen.velocity, id = seen.id, reach = reach, apart_px = set.apart_px, time = "sample",
    }
    return { picture = refined_time {
      color = seen.color, depth = seen.depth, id = seen.id, hit = seen.hit, velocity = seen.velocity, certain = cells.certain,
      longest = cells.longest, pace = set.pace, allowance = set.allowance, hit_color = set.hit_color, time = "sample",
    }.picture }
  end }.picture
  return scene.outputs(seen, { color = color })
end

local function true_times(p)
  local seen = scene.captured(traced)
  local means = truth.everywhere({
    mode = "rays", samples = selective.truth_samples(p.effort(), p.samples()), times = "midpoint", slices = 1, pixel = "centre",
    shading = "frozen", mark_regions = false, tolerance = 0, first_samples = 0,
  }, seen)
  return scene.outputs(seen, { color = mean { mean_a = means.mean_a, mean_b = means.mean_b }.color })
end

return pipeline {
  doc = "One parameter from post-process to ground truth: gather where it is certain, rays at several times elsewhere",
  params = options.with(options.blur(16), {
    effort = pipeline.float { 0.4, min = 0, max = 1,
      doc = "0, or any value with limit = 0: the gather of ue4; below 0.75: rays at several times where a gather is not " ..
            "certain; from 0.75: ground truth, at 1 with 16 times `samples` time samples" },
  }),
  presets = {
    post_process = { doc = "a post-process blur without rays", set = { effort = 0 } },
    few_rays     = { doc = "rays where a gather is not certain, as few as possible", set = { effort = 0.1 } },
  },
  compare_with = "ue4",
  equals = {
    { when = { effort = 0 }, pipeline = "ue4" },
    { when = { effort = 1, samples = 4 }, pipeline = "ground_truth", set = { samples = 64, mark_regions = false } },
  },
  build = function(p)
    if selective.is_gather(p.effort()) or p.limit() == 0 then return gathered(p) end
    return selective.is_truth(p.effort()) and true_times(p) or refined(p)
  end,
}
