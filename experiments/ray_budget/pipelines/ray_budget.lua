-- SPDX-License-Identifier: MIT
-- hybrid_traced with rays for at most a share of the pixels: those with the highest priority.
local pass     = require "strobe.pass"
local pipeline = require "strobe.pipeline"
local first_ranks    = require "passes.first_ranks"
local guessed        = require "passes.guessed"
local layered        = require "passes.layered_guessing"
local open_rank      = require "passes.open_rank"
local rank_counts    = require "passes.rank_counts"
local rank_limit     = require "passes.rank_limit"
local uncovered_rank = require "passes.uncovered_rank"
local layers   = require "scripts.pipelines.lib.layers"
local options  = require "scripts.pipelines.lib.options"
local scene    = require "scripts.pipelines.lib.scene"
local tiles    = require "scripts.pipelines.lib.tiles"
local time_samples = require "scripts.pipelines.lib.time_samples"

local slowest   = 0.02  -- px over the exposure, as in hybrid_traced
local revealing = 0.6   -- part of the budget that reveals; the rest traces unresolved samples

-- The pixels of highest priority, at most `part` of the budget.
local function select_top(p, rank, name, part)
  local counts = rank_counts { rank = rank, as = name .. "_counts" }.counts
  local limit = rank_limit {
    rank = rank, counts = counts, most_pixels = p.most_rays, most_part = part, as = name .. "_limit",
  }.limit
  return first_ranks { rank = rank, limit = limit, as = name }.mask
end

return pipeline {
  doc = "hybrid_traced with rays for at most a share of the pixels",
  params = options.by_tiles(40, {
    most_rays = pipeline.float { 0.15, min = 0, max = 1, doc = "share of the pixels that may have rays" },
  }),
  build = function(p)
    local raster = scene.captured()
    local dominant = tiles.dominant(p, raster, { prefix = "budget_" }).dominant
    local rank = uncovered_rank {
      mask = layers.disocclusion_mask(raster), color = raster.color, depth = raster.depth, id = raster.id,
      velocity = raster.velocity, dominant = dominant,
    }.rank
    local mask = select_top(p, rank, "masked", revealing)
    local revealed = layers.of(layers.revealed(raster, mask, true))
    local images = layers.images(p, raster, revealed, layered, slowest)
    images.doubtful = time_samples.unreliable(p, raster, revealed)
    images.silhouettes = time_samples.silhouettes(raster, slowest)
    local made = layered(pass.wired(layered, images, {
      as = "composite", taps = "linear", leaves_open = true, leaves_unlike = true, slowest = slowest,
    }))
    local traced = select_top(p, open_rank { open = made.open, guess = made.guess, mask = mask }.rank, "traced")
    local now = guessed { seen = made.blurred, open = made.open, guess = made.guess, mask = traced }
    return scene.outputs(raster, {
      color = time_samples.traced(p, raster, revealed, { blurred = now.seen_now, open = now.open_now }, 0),
      mask = mask, traced = traced,
    })
  end,
}
