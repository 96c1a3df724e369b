-- SPDX-License-Identifier: MIT
-- Lee, Kwon and Oh 2024, "Real-Time Motion Blur Using Multi-Layer Motion Vectors": full layers by depth peeling.
local pipeline = require "strobe.pipeline"
local filter   = require "passes.filter.lee2024"
local gbuffer  = require "passes.gbuffer.gbuffer"
local peel     = require "passes.gbuffer.depth_peel"
local options  = require "scripts.pipelines.lib.options"
local scene    = require "scripts.pipelines.lib.scene"
local tiles    = require "scripts.pipelines.lib.tiles"

local function layer_behind(front, number)
  local name = ("layer_%d"):format(number)
  local hit = peel { front = front.hit, as = name .. "_peel" }.hit
  local g = gbuffer { hit = hit, as = name .. "_gbuffer" }
  return scene.layer {
    hit = hit, depth = g.depth, id = g.id, velocity = g.velocity,
    color = scene.shaded(hit, name .. "_"),
  }
end

-- Returns the images that the filter reads. The first of `layers` has the visible surfaces.
local function images(p, layers)
  local read = { id = layers[1].id, color = layers[1].color, depth = layers[1].depth, velocity = layers[1].velocity }
  for number = 2, #layers do
    for _, part in ipairs { "color", "depth", "velocity" } do
      read[("layer_%d_%s"):format(number, part)] = layers[number][part]
    end
  end
  if p.paths() == "own" then return read end
  read.dominant = tiles.dominant(p, layers[1], { extra = layers[2] }).dominant
  if layers[3] then
    read.deep_dominant = tiles.dominant(p, layers[3], { extra = layers[4], prefix = "deep_" }).dominant
  end
  return read
end

return pipeline {
  doc = "Lee, Kwon and Oh 2024: search backwards along displacements, in full raster layers made by depth peeling",
  params = {
    options.tiles(40),
    layer_count = pipeline.int { 4, min = 1, max = 4, doc = "number of depth layers, including the visible layer" },
    sides  = peel.params.sides,
    paths = pipeline.choice { "tiles", "own", default = "tiles", doc = "displacements that the search of a pixel follows",
      values = {
        tiles = "The pixel's own displacement in each layer, and the longest one of the surrounding tiles. Fails where a " ..
                "third motion crosses the pixel.",
        own = "The pixel's own displacement in each layer. Fails beside silhouettes, where surfaces that cross the pixel " ..
              "only at other times are missed.",
      } },
    agreement = filter.params.agreement,
  },
  build = function(p)
    local raster = scene.raster()
    local layers = { raster }
    for number = 2, p.layer_count() do layers[number] = layer_behind(layers[number - 1], number) end
    local read = images(p, layers)
    read.as = "search"
    return scene.outputs(raster, { color = filter(read).blurred })
  end,
}
