-- SPDX-License-Identifier: MIT
-- Parameters that blur pipelines share, so that a name means the same in each.
local pipeline      = require "strobe.pipeline"
local gbuffer       = require "passes.scene.gbuffer"
local neighbour_max = require "passes.tile.neighbour_max"
local jitter        = require "scripts.pipelines.lib.jitter"
local stored        = require "scripts.pipelines.lib.stored"

local options = {}

-- `tile` and `limit` are defaults; the rest is equal everywhere, so that methods are compared alike.
function options.blur(tile, limit)
  return {
    samples      = pipeline.int { 16, min = 1, max = 1024, doc = "samples along the motion" },
    tile         = pipeline.int { tile, min = 1, max = 1024, unit = "px", doc = "side of a tile" },
    limit        = pipeline.float { limit, min = 0, max = 10, unit = "image widths",
      doc = "longest displacement handled; longer ones are shortened and counted" },
    depth_extent = pipeline.float { 0.01, min = 1e-6, max = 1,
      doc = "share of the depth over which two depths count as one" },
    jitter       = jitter.jitter,
    jitter_frame = jitter.jitter_frame,
    displacement = gbuffer.params.displacement,
    tile_rule    = neighbour_max.params.rule,
    velocity_format = stored.velocity_format,
    color_format    = stored.color_format,
    depth_encoding  = stored.depth_encoding,
  }
end

function options.with(base, more)
  for name, param in pairs(more) do base[name] = param end
  return base
end

return options
