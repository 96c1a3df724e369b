-- SPDX-License-Identifier: MIT
-- Parameters that blur pipelines share, so that a name means the same in each.
local blur          = require "passes.lib.blur"
local jitter        = require "passes.lib.jitter"
local stored        = require "passes.lib.stored"
local gbuffer       = require "passes.scene.gbuffer"
local neighbour_max = require "passes.tile.neighbour_max"

local options = {}

-- `tile` is a default; the rest is equal everywhere, so that methods are compared alike.
function options.blur(tile)
  return {
    samples      = blur.samples,
    tile         = blur.tile { tile },
    limit        = blur.limit,
    depth_extent = blur.depth_extent,
    jitter       = jitter.jitter,
    jitter_frame = jitter.jitter_frame,
    displacement = gbuffer.params.displacement,
    trajectory   = blur.trajectory,
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
