-- SPDX-License-Identifier: MIT
-- Raster and ray-revealed background, blurred and composited. Tan, Cui and Bhojan 2020, "Hybrid MBlur".
local pipeline = require "strobe.pipeline"
local reveal   = require "passes.scene.reveal"
local hybrid   = require "scripts.pipelines.lib.hybrid"
local masks    = require "scripts.pipelines.lib.masks"
local scene    = require "scripts.pipelines.lib.scene"

return pipeline {
  doc = "What raster sees and what rays reveal behind it, blurred and composited (Tan, Cui and Bhojan 2020)",
  params = hybrid.params(),
  presets = hybrid.presets,
  default_preset = "best",
  build = function(p)
    local seen = scene.captured()
    local mask = masks[p.mask()](p, seen)
    local revealed = reveal {
      hit = seen.hit, mask = mask,
      termination = p.termination, advance = p.advance, max_layers = p.max_layers, on_cap = p.on_cap,
    }
    return scene.outputs(seen, {
      color = hybrid.composites[p.composite()](p, seen, revealed), mask = mask,
      revealed = revealed.color, revealed_depth = revealed.depth, revealed_velocity = revealed.velocity,
      revealed_id = revealed.id, revealed_valid = revealed.valid,
    })
  end,
}
