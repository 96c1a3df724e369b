-- SPDX-License-Identifier: MIT
-- Draws each part of the exposure as a separate frame, then the frame itself. Outputs `part_*`: the last part.
local parts    = require "strobe.parts"
local pipeline = require "strobe.pipeline"
local scene    = require "scripts.pipelines.lib.scene"

return pipeline {
  doc = "The last part of the exposure and the raster image",
  params = { parts = pipeline.int { 2, min = 1, max = 64, doc = "number of parts" } },
  build = function(p)
    local last = parts.loop { name = "parts", count = p.parts, body = function()
      local raster = pipeline.prefixed("part_", scene.raster)
      return { color = raster.color, depth = raster.depth, normal = raster.normal, velocity = raster.velocity }
    end }
    local raster = scene.raster()
    return scene.outputs(raster, {
      color = raster.color, part_color = last.color, part_depth = last.depth, part_normal = last.normal,
      part_velocity = last.velocity,
    })
  end,
}
