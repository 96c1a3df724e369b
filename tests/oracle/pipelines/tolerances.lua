-- SPDX-License-Identifier: MIT
-- Colours revealed by luminance termination with two tolerances.
local pipeline = require "strobe.pipeline"
local constant = require "passes.mask.constant"
local reveal   = require "passes.hybrid.ray_reveal"
local scene    = require "scripts.pipelines.lib.scene"

return pipeline {
  doc = "Colour revealed by luminance termination with tolerances a and b",
  params = {
    a = pipeline.float { 0, min = 0, max = 1, doc = "tolerance" },
    b = pipeline.float { 0, min = 0, max = 1, doc = "tolerance" },
  },
  build = function(p)
    local seen = scene.raster()
    local mask = constant { everywhere = true }.mask
    local function revealed(name, tolerance)
      return reveal {
        hit = seen.hit, mask = mask, termination = "luminance", advance = "origin_kept", tolerance = tolerance,
        as = name,
      }.color
    end
    return scene.outputs(seen, { color = seen.color, a = revealed("with_a", p.a), b = revealed("with_b", p.b) })
  end,
}
