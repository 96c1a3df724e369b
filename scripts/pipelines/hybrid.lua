-- SPDX-License-Identifier: MIT
-- Raster and ray-revealed background, blurred and composited. Tan, Cui and Bhojan 2020, "Hybrid MBlur".
local pipeline = require "strobe.pipeline"
local budget   = require "scripts.pipelines.lib.budget"
local curves   = require "scripts.pipelines.lib.curves"
local hybrid   = require "scripts.pipelines.lib.hybrid"
local masks    = require "scripts.pipelines.lib.masks"
local ranges   = require "scripts.pipelines.lib.ranges"
local scene    = require "scripts.pipelines.lib.scene"

-- Without rays the hybrid is the post-process that its layers are blurred by.
local function without_rays(weights, other, set)
  local when = { mask = "none", composite = "alpha_over", weights = weights, directions = "one" }
  return { when = when, pipeline = other, set = set }
end

return pipeline {
  doc = "What raster sees and what rays reveal behind it, blurred and composited (Tan, Cui and Bhojan 2020)",
  params = hybrid.params(),
  presets = hybrid.presets,
  default_preset = "best",
  compare_with = "mcguire2012",
  equals = {
    without_rays("mcguire2012", "mcguire2012", { weights = "mcguire2012" }),
    without_rays("uniform", "mcguire2012", { weights = "uniform" }),
    without_rays("jimenez2014", "jimenez2014", { cheap = false }),
    without_rays("guertin2014", "guertin2014", { uniform_path = false }),
  },
  build = function(p)
    local seen = scene.captured()
    if curves.are_foretold(p) then curves.add(p, { { "raster", seen } }) end
    local moving = ranges.divided(p, seen, "halves")
    local mask = budget.masked(p, seen, ranges.mask(p, moving, masks[p.mask()]))
    local revealed = hybrid.revealed(p, seen, mask)
    local first, layers = revealed[1], hybrid.divided(p, revealed)
    local color, traced = hybrid.composited(p, moving, layers, mask)
    return scene.outputs(seen, {
      color = color, mask = mask, traced = budget.is_set(p) and traced or nil,
      revealed = first.color, revealed_depth = first.depth,
      revealed_velocity = curves.are_foretold(p) and layers[1].velocity or first.velocity,
      revealed_id = first.id, revealed_valid = first.valid,
    })
  end,
}
