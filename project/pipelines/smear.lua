-- SPDX-License-Identifier: MIT
-- What raster sees, smeared along its motion.
local pipeline = require "strobe.pipeline"
local smear    = require "passes.smear"
local scene    = require "scripts.pipelines.lib.scene"

return pipeline {
  doc = "What the capture sees, averaged along each pixel's own motion",
  params = { taps = smear.params.taps },
  build = function(p)
    local seen = scene.captured()
    return scene.outputs(seen, { color = smear { color = seen.color, velocity = seen.velocity, taps = p.taps }.color })
  end,
}
