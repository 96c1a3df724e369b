-- SPDX-License-Identifier: MIT
-- Stand-in for the post-process blur of game engines around 2020: the filter of Jimenez 2014 with tiles of 16 px. Where
-- a moving surface hides the background at one tap of a pair, the opposite tap replaces it.
local pipeline = require "strobe.pipeline"
local gather   = require "passes.gather.jimenez2014"
local gathers  = require "scripts.pipelines.lib.gathers"
local options  = require "scripts.pipelines.lib.options"
local scene    = require "scripts.pipelines.lib.scene"
local tiles    = require "scripts.pipelines.lib.tiles"

return pipeline {
  doc = "Stand-in for the post-process blur of game engines around 2020: the filter of Jimenez 2014 with 16 px tiles",
  params = {
    options.blur(16),
    mirror = gather.params.mirror,
  },
  build = function(p)
    local raster = scene.raster()
    local images = gathers.images(raster, tiles.dominant(p, raster))
    return scene.outputs(raster, {
      color = gathers.blurred("jimenez2014", images, "gather"),
    })
  end,
}
