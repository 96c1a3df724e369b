-- SPDX-License-Identifier: MIT
-- Post-process blur of Guertin, McGuire and Nowrouzezahrai 2014, for any anchor (position of the exposure relative to the
-- raster time).
local pipeline = require "strobe.pipeline"
local gather   = require "passes.gather.guertin2014"
local gathers  = require "scripts.pipelines.lib.gathers"
local options  = require "scripts.pipelines.lib.options"
local scene    = require "scripts.pipelines.lib.scene"
local tiles    = require "scripts.pipelines.lib.tiles"

return pipeline {
  doc = "Guertin et al. 2014: blur of each pixel along the longest displacement of surrounding tiles and a second direction",
  params = {
    options.blur(40),
    directions   = gather.params.directions,
    second_share = pipeline.choice { "half", "variance", default = "half",
      doc = "share of the samples that follow the second direction",
      values = {
        half = "Half of the samples, at every pixel. Fails by wasting samples where all surfaces move in one direction.",
        variance = "A larger share where the motion directions of the surrounding tiles differ more. Fails where motions " ..
                   "cross within one tile.",
      } },
    kappa        = gather.params.kappa,
    gamma        = gather.params.gamma,
    eta          = gather.params.eta,
    tile_jitter  = gather.params.tile_jitter,
    uniform_path = pipeline.bool { true,
      doc = "take the longest displacement near a pixel as the motion of all surfaces there, if the shortest displacement " ..
            "near the pixel is at least 0.65 times as long" },
  },
  build = function(p)
    local raster = scene.raster()
    local two = p.directions() == "two"
    local around = tiles.dominant(p, raster, { second = two })
    local images = gathers.images(raster, around)
    if p.uniform_path() then images.slowest = tiles.slowest(raster, around) end
    if p.second_share() == "variance" then images.variance = tiles.variance(around) end
    return scene.outputs(raster, {
      color = gathers.blurred("guertin2014", images, "gather"),
    })
  end,
}
