-- SPDX-License-Identifier: MIT
-- Parameters that blur pipelines share. A shared parameter has the same meaning in all pipelines.
local blur          = require "passes.lib.blur"
local jitter        = require "passes.lib.jitter"
local quantised     = require "passes.lib.quantised"
local gbuffer       = require "passes.gbuffer.gbuffer"
local neighbour_max = require "passes.tile.neighbour_max"

local options = {}

-- Parameters of pipelines that read taps from images: samples, the longest displacement, jitter and memory formats. Pipelines
-- with equal values are compared under equal conditions.
options.picture = {
  samples      = blur.samples,
  limit        = blur.limit,
  jitter       = jitter.jitter,
  jitter_frame = jitter.jitter_frame,
  displacement = gbuffer.params.displacement,
  velocity_format = quantised.velocity_format,
  color_format    = quantised.color_format,
  depth_encoding  = quantised.depth_encoding,
}

-- Parameters of pipelines that use displacements per tile. `tile`: default side of a tile, px.
function options.tiles(tile)
  return { options.picture, tile = blur.tile { tile }, tile_rule = neighbour_max.params.rule }
end

-- Parameters of a post-process blur. `tile`: default side of a tile, px.
function options.blur(tile)
  return { options.tiles(tile), depth_extent = blur.depth_extent }
end

return options
