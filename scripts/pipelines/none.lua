-- SPDX-License-Identifier: MIT
-- No blur: what raster sees at the capture.
local pipeline = require "strobe.pipeline"
local scene    = require "scripts.pipelines.lib.scene"

return pipeline {
  doc = "What the capture sees, without blur",
  kind = "sharp",
  breaks = { uniform = "it does not blur" },
  build = function()
    local seen = scene.captured()
    return scene.outputs(seen, { color = seen.color })
  end,
}
