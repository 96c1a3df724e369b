-- SPDX-License-Identifier: MIT
-- Depths revealed by each way of advancing rays, with a cap of 1 to 4 layers, and with the last hit or the fallback at
-- the cap.
local pipeline = require "strobe.pipeline"
local constant = require "passes.mask.constant"
local reveal   = require "passes.hybrid.ray_reveal"
local scene    = require "scripts.pipelines.lib.scene"

return pipeline {
  doc = "Depth revealed by each way of advancing, for each cap",
  params = {},
  build = function()
    local seen = scene.raster()
    local mask = constant { everywhere = true }.mask
    local outputs = { color = seen.color }
    local function revealed(name, advance, most, on_cap)
      local found = reveal {
        hit = seen.hit, mask = mask, advance = advance, max_layers = most, on_cap = on_cap, as = name,
      }
      outputs[name] = found.depth
    end
    for _, advance in ipairs { "origin_kept", "restart", "instance_filter" } do
      for most = 1, 4 do revealed(("%s_%d"):format(advance, most), advance, most, "last_hit") end
      revealed(advance .. "_all", advance, 31, "fallback")
      revealed(advance .. "_few", advance, 2, "fallback")
    end
    return scene.outputs(seen, outputs)
  end,
}
