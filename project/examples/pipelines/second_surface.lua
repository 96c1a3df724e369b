-- SPDX-License-Identifier: MIT
-- The raster image, averaged with the colours of the surfaces that rays find behind the visible surfaces.
local pipeline       = require "strobe.pipeline"
local second_surface = require "passes.second_surface"
local scene          = require "scripts.pipelines.lib.scene"

return pipeline {
  doc    = "Raster image, averaged with the colour of the second surface on each pixel's ray",
  breaks = { uniform = "the pipeline does not blur" },
  params = { share = second_surface.params.share },
  build  = function(p)
    local raster = scene.raster()
    local traced = second_surface { hit = raster.hit, color = raster.color, share = p.share }
    return scene.outputs(raster, { color = traced.picture })
  end,
}
