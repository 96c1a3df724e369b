-- SPDX-License-Identifier: MIT
-- The raster image with a tint on moving pixels. The parameter `tint` has one choice for each file of passes/motion_tint.
local pipeline = require "strobe.pipeline"
local pass     = require "strobe.pass"
local scene    = require "scripts.pipelines.lib.scene"

local tints = { default = "speed", doc = "tint of moving pixels", values = {}, table.unpack(pass.family "motion_tint") }
for _, name in ipairs(tints) do tints.values[name] = pass.member("motion_tint", name).description.doc end

return pipeline {
  doc    = "Raster image with tinted moving pixels",
  breaks = { uniform = "the pipeline does not blur" },
  params = { tint = pipeline.choice(tints) },
  build  = function(p)
    local raster = scene.raster()
    local tint = pass.member("motion_tint", p.tint())  -- p.tint() is the chosen name; it selects the pass
    return scene.outputs(raster, { color = tint(pass.wired(tint, raster, { as = "tint" })).tinted })
  end,
}
