-- SPDX-License-Identifier: MIT
-- One edge detector over the whole picture.
local pipeline = require "strobe.pipeline"
local edges    = require "scripts.pipelines.lib.edges"
local scene    = require "scripts.pipelines.lib.scene"

local names = { default = "sobel", doc = "edge detector" }
for _, name in ipairs(edges.names) do names[#names + 1] = name end

return pipeline {
  doc    = "Edges over the whole picture",
  params = { edge = pipeline.choice(names) },
  build  = function(p)
    local seen = scene.raster()
    return scene.outputs(seen, { color = seen.color, edge = edges.detected(p.edge(), seen) })
  end,
}
