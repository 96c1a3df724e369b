-- SPDX-License-Identifier: MIT
-- Rival of the pipeline `adaptive`: the pipeline `eevee` with reused colours. The scene is drawn in the middle of each step of
-- the exposure, and surfaces take the colours of the raster image if the raster image shows them. The first loop draws the
-- steps, colours them and stores them. The second loop blurs the stored steps. It could not colour them: to find a surface in
-- the raster image, its pose at the raster time of the frame is needed, and a loop over parts of the exposure lacks this pose.
local parts    = require "strobe.parts"
local pipeline = require "strobe.pipeline"
local gbuffer     = require "passes.gbuffer.gbuffer"
local visibility  = require "passes.gbuffer.visibility"
local accumulate  = require "passes.truth.accumulate"
local mean        = require "passes.truth.mean"
local pose_color  = require "passes.pose_color"
local store_pose  = require "passes.store_pose"
local stored_pose = require "passes.stored_pose"
local gathers = require "scripts.pipelines.lib.gathers"
local options = require "scripts.pipelines.lib.options"
local scene   = require "scripts.pipelines.lib.scene"
local tiles   = require "scripts.pipelines.lib.tiles"

local function blurred(p, poses)
  local stored = stored_pose { poses = poses }
  local g = gbuffer { hit = stored.hit, as = "step_gbuffer" }
  local step = scene.layer { color = stored.color, depth = g.depth, velocity = g.velocity, id = g.id }
  local around = tiles.dominant(p, step)
  local images = gathers.images(step, around)
  images.slowest = tiles.slowest(step, around)
  return gathers.blurred("guertin2014", images, "gather")
end

return pipeline {
  doc = "Steps of the exposure, each drawn and blurred, with the colours of the raster image",
  params = { options.blur(40), steps = pipeline.int { 4, min = 1, max = 8, doc = "number of steps" } },
  build = function(p)
    local raster = scene.raster()
    local poses = pipeline.loop { name = "poses", count = p.steps, times = "midpoint", body = function()
      local hit = visibility { time = "sample", as = "step_visibility" }.hit
      local pose = pose_color { hit = hit, color = raster.color, depth = raster.depth, id = raster.id, time = "sample" }.pose
      return { poses = store_pose { hit = hit, color = pose }.poses }
    end }.poses
    local halves = parts.loop { name = "steps", count = p.steps, body = function()
      local sum = accumulate { color = blurred(p, poses) }
      return { mean_a = sum.mean_a, mean_b = sum.mean_b }
    end }
    return scene.outputs(raster, { color = mean { mean_a = halves.mean_a, mean_b = halves.mean_b }.color })
  end,
}
