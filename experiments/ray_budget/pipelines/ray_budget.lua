-- SPDX-License-Identifier: MIT
-- The pipeline hybrid_traced with a ray budget: at most a given share of the pixels have rays. The pixels with the highest
-- priority (expected gain of a ray) get the rays. All other pixels use the layers alone.
local pass     = require "strobe.pass"
local pipeline = require "strobe.pipeline"
local select_top_pixels  = require "passes.select_top"
local add_fallback       = require "passes.add_fallback"
local layered            = require "passes.layered_estimating"
local trace_priority     = require "passes.trace_priority"
local priority_histogram = require "passes.priority_histogram"
local priority_limit     = require "passes.priority_limit"
local reveal_priority    = require "passes.reveal_priority"
local layers   = require "scripts.pipelines.lib.layers"
local options  = require "scripts.pipelines.lib.options"
local scene    = require "scripts.pipelines.lib.scene"
local tiles    = require "scripts.pipelines.lib.tiles"
local time_samples = require "scripts.pipelines.lib.time_samples"

local slowest   = 0.02  -- least motion of a silhouette that needs rays, px over the exposure, as in hybrid_traced
local revealing = 0.6   -- share of the budget for rays that reveal the background; the rest is for unresolved samples

-- Returns the mask of the pixels with the highest values of `priority`. `part`: share of the ray budget that the mask may use;
-- nil: 1. `name`: name of the node that makes the mask.
local function select_top(p, priority, name, part)
  local counts = priority_histogram { priority = priority, as = name .. "_counts" }.counts
  local limit = priority_limit {
    priority = priority, counts = counts, most_pixels = p.ray_budget, most_part = part, as = name .. "_limit",
  }.limit
  return select_top_pixels { priority = priority, limit = limit, as = name }.mask
end

return pipeline {
  doc = "hybrid_traced with rays for at most a given share of the pixels",
  params = {
    options.tiles(40),
    ray_budget = pipeline.float { 0.15, min = 0, max = 1, doc = "share of the pixels that may have rays" },
  },
  build = function(p)
    local raster = scene.raster()
    local dominant = tiles.dominant(p, raster, { prefix = "budget_" }).dominant
    local priority = reveal_priority {
      mask = layers.disocclusion_mask(raster), color = raster.color, depth = raster.depth, id = raster.id,
      velocity = raster.velocity, dominant = dominant,
    }.priority
    local mask = select_top(p, priority, "masked", revealing)
    local revealed = layers.of(layers.revealed(raster, mask, "moving_rect"))
    local images = layers.images(p, raster, revealed, layered, slowest)
    images.unreliable = time_samples.unreliable(p, raster, revealed)
    images.silhouettes = time_samples.silhouettes(raster, slowest)
    local made = layered(pass.wired(layered, images, {
      as = "composite", taps = "linear", marks_unresolved = true, marks_contrast = true, slowest = slowest,
    }))
    local unresolved, estimate = made.unresolved, made.fallback_estimate
    local priority_of_rays = trace_priority { unresolved = unresolved, fallback_estimate = estimate, mask = mask }.priority
    local traced = select_top(p, priority_of_rays, "traced")
    local now = add_fallback {
      partial = made.blurred, unresolved = unresolved, fallback_estimate = estimate, mask = traced,
    }
    return scene.outputs(raster, {
      color = time_samples.traced(p, raster, revealed, { blurred = now.partial_now, unresolved = now.unresolved_now }, 0),
      mask = mask, traced = traced,
    })
  end,
}
