-- SPDX-License-Identifier: MIT
-- Post-process blur of Jimenez 2014, "Next Generation Post Processing in Call of Duty: Advanced Warfare", for any anchor
-- (position of the exposure relative to the raster time).
local pipeline = require "strobe.pipeline"
local gather   = require "passes.gather.jimenez2014"
local gathers  = require "scripts.pipelines.lib.gathers"
local options  = require "scripts.pipelines.lib.options"
local scene    = require "scripts.pipelines.lib.scene"
local tiles    = require "scripts.pipelines.lib.tiles"

return pipeline {
  doc = "Jimenez 2014: gather of tap pairs along the longest displacement nearby; where a moving surface hides the " ..
        "background at one tap of a pair, the opposite tap replaces it",
  params = {
    options.blur(20),
    mirror      = gather.params.mirror,
    count       = gather.params.count,
    direction   = gather.params.direction,
    copy_below  = gather.params.copy_below,
    cheap_ratio = gather.params.cheap_ratio,
    cheap       = pipeline.bool { true, doc = "use equal weights for all taps where all surfaces around a pixel move alike" },
  },
  build = function(p)
    local raster = scene.raster()
    local around = tiles.dominant(p, raster)
    local images = gathers.images(raster, around)
    if p.cheap() then images.slowest = tiles.slowest(raster, around) end
    return scene.outputs(raster, {
      color = gathers.blurred("jimenez2014", images, "gather"),
    })
  end,
}
