-- SPDX-License-Identifier: MIT
-- Post-process blur of McGuire, Hennessy, Bukowski and Osman 2012, for any anchor (position of the exposure relative to the
-- raster time).
local pipeline = require "strobe.pipeline"
local gather   = require "passes.gather.mcguire2012"
local scene    = require "scripts.pipelines.lib.scene"
local options  = require "scripts.pipelines.lib.options"
local paths    = require "scripts.pipelines.lib.paths"
local tiles    = require "scripts.pipelines.lib.tiles"
local gathers  = require "scripts.pipelines.lib.gathers"

return pipeline {
  doc = "McGuire et al. 2012: blur of each pixel along the longest displacement of the surrounding tiles",
  params = {
    options.blur(40),
    weights = pipeline.choice(gathers.choice("mcguire2012",
      "weights of the taps: as published, or equal for all taps", { "mcguire2012", "uniform" })),
    directions = gather.params.directions,
    range = paths.range,
  },
  build = function(p)
    local raster = scene.raster()
    local moving = paths.split(p, raster, "segments")
    local images = gathers.images(moving, tiles.dominant(p, moving))
    return scene.outputs(raster, {
      color = gathers.blurred(p.weights(), images, "gather"),
    })
  end,
}
