-- SPDX-License-Identifier: MIT
-- The parts of the hybrid: its parameters and its composites.
local pipeline   = require "strobe.pipeline"
local alpha_over = require "passes.composite.alpha_over"
local layered    = require "passes.composite.layered"
local edges      = require "scripts.pipelines.lib.edges"
local gathers    = require "scripts.pipelines.lib.gathers"
local options    = require "scripts.pipelines.lib.options"
local ranges     = require "scripts.pipelines.lib.ranges"
local tiles      = require "scripts.pipelines.lib.tiles"

local hybrid = {}

hybrid.mask_texts = {
  none     = "Nothing is revealed: the raster layer blurred alone. Fails at every silhouette that uncovers " ..
             "something: its background is taken from beside it.",
  seed     = "Displaced position, edges there, pixels in range of such an edge (Tan, Cui and Bhojan 2020). Fails " ..
             "when the background moves: it marks by the foreground's own motion, too little where they move " ..
             "against each other and nothing where only the background moves.",
  relative = "Motion relative to what is beyond the silhouette decides. Fails when that motion is visible nowhere " ..
             "near, and on self-occlusion of one instance.",
  moving   = "Everything that moves or that something may move over. Fails to save rays: most of what it marks " ..
             "uncovers nothing.",
  all      = "Every pixel. Fails to save any rays; it is what other masks are compared with.",
}

function hybrid.params()
  local choice, bool = pipeline.choice, pipeline.bool
  local edge_names = { default = "sobel", doc = "edge detector of the mask `seed`", values = edges.texts() }
  for _, name in ipairs(edges.names) do edge_names[#edge_names + 1] = name end
  return options.with(options.blur(40, 0.1), {
    mask        = choice { "none", "seed", "relative", "moving", "all", default = "relative",
      doc = "pixels to reveal behind: by their own motion, or by motion relative to what is beyond their silhouette",
      values = hybrid.mask_texts },
    mask_taps   = pipeline.int { 1, min = 1, max = 64,
      doc = "positions along the displacement at which the mask `seed` looks for something farther" },
    edge        = choice(edge_names),
    own_edge    = bool { true, doc = "an edge met along the motion must belong to the pixel's own instance" },
    termination = choice { "luminance", "geometry", "instance", "motion", default = "instance",
      doc = "what tells the background from more of the foreground along a ray" },
    advance     = choice { "origin_kept", "restart", default = "origin_kept", doc = "how a ray goes on past a hit" },
    max_layers  = pipeline.int { 8, min = 1, max = 31, doc = "hits a ray may pass" },
    on_cap      = choice { "fallback", "last_hit", default = "fallback", doc = "what if there are more" },
    tiles       = choice { "separate", "union", default = "union", doc = "dominant motion per layer, or of both" },
    range       = ranges.param,
    weights     = choice { "mcguire2012", "uniform", default = "uniform", doc = "of the taps, under alpha_over" },
    composite   = choice { "alpha_over", "layered", default = "layered",
      doc = "blur both layers and lay one over the other, or look at both per time sample" },
  })
end

local seed = {
  mask = "seed", edge = "sobel", own_edge = false, termination = "luminance", advance = "restart", on_cap = "last_hit",
  tiles = "separate", weights = "mcguire2012", composite = "alpha_over",
}
local seed_linear = options.with(options.with({}, seed), { weights = "uniform" })
local best = {
  mask = "relative", termination = "instance", advance = "origin_kept", on_cap = "fallback",
  tiles = "union", weights = "uniform", composite = "layered",
}
hybrid.presets = { seed = seed, seed_linear = seed_linear, best = best }

-- Displacements per tile for the raster layer and for the revealed one; `second` as for tiles.dominant.
function hybrid.dominant(p, seen, revealed, second)
  if p.tiles() == "union" then
    local both = tiles.dominant(p, seen, { extra = revealed, second = second })
    return both, both
  end
  return tiles.dominant(p, seen, { second = second, prefix = "raster_" }),
         tiles.dominant(p, revealed, { prefix = "revealed_" })
end

hybrid.composites = {}

function hybrid.composites.alpha_over(p, seen, revealed)
  local on_top, below = hybrid.dominant(p, seen, revealed)
  local front = gathers.blurred(p, p.weights(), seen, on_top, revealed, "gather_raster")
  local back = gathers.blurred(p, p.weights(), revealed, below, nil, "gather_revealed")
  return alpha_over { front = front, back = back, as = "composite" }.color
end

function hybrid.composites.layered(p, seen, revealed)
  local on_top, below = hybrid.dominant(p, seen, revealed, true)
  local separate = p.tiles() == "separate"
  return layered {
    color = seen.color, depth = seen.depth, velocity = seen.velocity,
    dominant = on_top.dominant, second = on_top.second,
    revealed_color = revealed.color, revealed_depth = revealed.depth, revealed_velocity = revealed.velocity,
    revealed_valid = revealed.valid, revealed_dominant = separate and below.dominant or nil,
    after_velocity = seen.after_velocity, after_dominant = on_top.after_dominant, after_second = on_top.after_second,
    revealed_after_velocity = revealed.after_velocity,
    revealed_after_dominant = separate and below.after_dominant or nil,
    samples = p.samples, tile = p.tile, limit = p.limit, jitter = p.jitter, as = "composite",
  }.blurred
end

return hybrid
