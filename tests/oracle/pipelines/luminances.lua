-- SPDX-License-Identifier: MIT
-- Depths revealed by luminance termination, for each definition of luminance.
local pipeline = require "strobe.pipeline"
local constant = require "passes.mask.constant"
local reveal   = require "passes.hybrid.ray_reveal"
local scene    = require "scripts.pipelines.lib.scene"

return pipeline {
  doc = "Depth revealed by the luminance of radiance, base colour and material",
  build = function()
    local seen = scene.raster()
    local mask = constant { everywhere = true }.mask
    local outputs = { color = seen.color }
    for _, of in ipairs { "radiance", "base_color", "material" } do
      outputs[of] = reveal {
        hit = seen.hit, mask = mask, termination = "luminance", advance = "origin_kept", luminance_of = of, as = of,
      }.depth
    end
    return scene.outputs(seen, outputs)
  end,
}
