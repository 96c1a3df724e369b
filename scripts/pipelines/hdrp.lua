-- SPDX-License-Identifier: MIT
-- The motion blur of Unity's High Definition Render Pipeline (since 2019), for any anchor (position of the exposure relative to
-- the raster time).
local pipeline = require "strobe.pipeline"
local blur     = require "passes.lib.blur"
local jitter   = require "passes.lib.jitter"
local gather   = require "passes.gather.jimenez2014"
local scatter_length   = require "passes.tile.scatter_length"
local scatter_source   = require "passes.tile.scatter_source"
local scatter_max      = require "passes.tile.scatter_max"
local tile_max         = require "passes.tile.tile_max"
local gathers  = require "scripts.pipelines.lib.gathers"
local options  = require "scripts.pipelines.lib.options"
local scene    = require "scripts.pipelines.lib.scene"
local tiles    = require "scripts.pipelines.lib.tiles"

-- Dominant displacement of each tile: the longest displacement that passes over the tile. Each tile writes (scatters)
-- its displacement to all tiles along this displacement. In other pipelines, each tile reads (gathers) the
-- displacements of the surrounding tiles instead (tiles.dominant).
local function dominant(raster)
  local tile = tile_max { velocity = raster.velocity }
  local longest = tile.longest
  local length = scatter_length { longest = longest }.length
  local source = scatter_source { longest = longest, length = length }.source
  return {
    dominant = scatter_max { longest = longest, source = source }.dominant,
    max_displacement = tile.max_displacement,
  }
end

return pipeline {
  doc = "Unity HDRP: tap pairs as in Jimenez 2014; each tile scatters its displacement to the tiles along it; the " ..
        "weight of a tap depends on the projection of its displacement on the dominant one",
  params = {
    options.picture,
    tile         = blur.tile { 16 },
    depth_extent = blur.depth_extent,
    jitter       = jitter.jitter,
    mirror       = gather.params.mirror,
    count        = gather.params.count { default = "adaptive" },
    direction    = gather.params.direction { default = "projected" },
    copy_below   = gather.params.copy_below,
    cheap_ratio  = gather.params.cheap_ratio,
    cheap        = pipeline.bool { true, doc = "use equal weights for all taps where all surfaces around a pixel move alike" },
  },
  build = function(p)
    local raster = scene.raster()
    local around = dominant(raster)
    local images = gathers.images(raster, around)
    if p.cheap() then images.slowest = tiles.slowest(raster, around) end
    return scene.outputs(raster, { color = gathers.blurred("jimenez2014", images, "gather") })
  end,
}
