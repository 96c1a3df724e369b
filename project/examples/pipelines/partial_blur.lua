-- SPDX-License-Identifier: MIT
-- McGuire et al. 2012 with an adjustable strength. The pipeline uses parameters and functions of the shipped pipeline
-- mcguire2012, and adds one pass at the end.
local pipeline     = require "strobe.pipeline"
local moving       = require "passes.mask.moving"
local partial_blur = require "passes.partial_blur"
local gathers      = require "scripts.pipelines.lib.gathers"
local options      = require "scripts.pipelines.lib.options"
local scene        = require "scripts.pipelines.lib.scene"
local tiles        = require "scripts.pipelines.lib.tiles"

return pipeline {
  doc     = "McGuire et al. 2012, blended with the sharp picture",
  params  = {
    options.blur(40),
    strength = partial_blur.params.strength,
    masked   = pipeline.bool { false, doc = "use the blurred picture only in tiles that a moving surface may reach" },
  },
  presets = { half = { doc = "half of the blur, with 8 samples", set = { samples = 8, strength = 0.5 } } },
  build   = function(p)
    local raster = scene.raster()
    local around = tiles.dominant(p, raster)
    local blurred = gathers.blurred("mcguire2012", gathers.images(raster, around), "gather")
    local mask = p.masked() and moving { velocity = raster.velocity, dominant = around.dominant }.mask or nil
    local blended = partial_blur { sharp = raster.color, blurred = blurred, mask = mask, strength = p.strength }
    return scene.outputs(raster, { color = blended.color })
  end,
}
