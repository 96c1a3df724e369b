-- SPDX-License-Identifier: MIT
-- Parameters that blur pipelines share, so that a name means the same in each.
local blur          = require "passes.lib.blur"
local jitter        = require "passes.lib.jitter"
local stored        = require "passes.lib.stored"
local gbuffer       = require "passes.scene.gbuffer"
local neighbour_max = require "passes.tile.neighbour_max"

local options = {}

function options.with(base, more)
  for name, param in pairs(more) do base[name] = param end
  return base
end

-- Parameters of pipelines that sample pictures. They have the same defaults everywhere, so that comparisons are fair.
function options.of_picture(more)
  return options.with({
    samples      = blur.samples,
    limit        = blur.limit,
    jitter       = jitter.jitter,
    jitter_frame = jitter.jitter_frame,
    displacement = gbuffer.params.displacement,
    velocity_format = stored.velocity_format,
    color_format    = stored.color_format,
    depth_encoding  = stored.depth_encoding,
  }, more)
end

-- Parameters of pipelines that search by tiles. `tile` is the default size of a tile, px.
function options.by_tiles(tile, more)
  return options.with(options.of_picture {
    tile      = blur.tile { tile },
    tile_rule = neighbour_max.params.rule,
  }, more)
end

function options.blur(tile)
  return options.by_tiles(tile, { depth_extent = blur.depth_extent })
end

return options
