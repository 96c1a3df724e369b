-- SPDX-License-Identifier: MIT
-- No more than a share of the picture's pixels have rays: those where they are expected to gain most.
local first_ranks    = require "passes.mask.first_ranks"
local guessed        = require "passes.filter.guessed"
local open_rank      = require "passes.mask.open_rank"
local uncovered_rank = require "passes.mask.uncovered_rank"
local rank_counts    = require "passes.tile.rank_counts"
local rank_limit     = require "passes.tile.rank_limit"
local pipeline       = require "strobe.pipeline"
local doubts         = require "scripts.pipelines.lib.doubts"
local tiles          = require "scripts.pipelines.lib.tiles"

local budget = {}

budget.param = pipeline.float { 1, min = 0, max = 1,
  variant = true,  -- below 1 the graph is another one
  doc = "share of the picture's pixels that may have rays of the method's own; those where they promise most have them" }

-- Is there any? Else nothing of this runs.
function budget.is_set(p) return p.most_rays() < 1 end

-- Of that share, what reveals where there are rays at their own time too: what is left to these goes to where layers know
-- least once something is revealed.
local revealing = 0.6

-- The first by rank, as many as there may be, or a part of them.
local function first(p, rank, name, part)
  local counts = rank_counts { rank = rank, as = name .. "_counts" }.counts
  local limit = rank_limit {
    rank = rank, counts = counts, most_pixels = p.most_rays, most_part = part, as = name .. "_limit",
  }.limit
  return first_ranks { rank = rank, limit = limit, as = name }.mask
end

-- Of a mask, where to reveal.
function budget.masked(p, seen, mask)
  if not budget.is_set(p) then return mask end
  local dominant = tiles.dominant(p, seen, { prefix = "budget_" }).dominant
  local rank = uncovered_rank {
    mask = mask, color = seen.color, depth = seen.depth, id = seen.id, velocity = seen.velocity, dominant = dominant,
  }.rank
  return first(p, rank, "masked", doubts.are_asked(p) and revealing or nil)
end

-- What a composite made that left samples open and guessed them, with rays for some pixels: those of `mask`, which had one,
-- and more. Gives it as such a composite does, and where pixels have rays.
function budget.open(p, made, mask)
  local rank = open_rank { open = made.open, guess = made.guess, mask = mask }.rank
  local traced = first(p, rank, "traced")
  local now = guessed { seen = made.blurred, open = made.open, guess = made.guess, mask = traced }
  return { blurred = now.seen_now, open = now.open_now }, traced
end

return budget
