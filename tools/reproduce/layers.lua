-- SPDX-License-Identifier: MIT
-- Measures errors and masked pixels for docs/derivations.md. The shot of the living room compares composites, and a
-- limit on the hits of a ray. The shot of high-contrast stripes, which move against each other, measures the published
-- composite.
local experiment = require "strobe.experiment"

local in_stripes = { ["seed_linear"] = true, ["seed_linear, own edge"] = true }

return experiment {
  title = "Composites in the living room and on stripes of high contrast",
  size = { 320, 180 },
  shots = {
    { name = "living_room", scene = "living_room", truth = { samples = 64 } },
    { name = "harsh", scene = "oracles/textured_bar", frame = 0, ["scene.width"] = 320, ["scene.height"] = 180,
      ["scene.left"] = 100, ["scene.right"] = 164, ["scene.d_f"] = 12, ["scene.d_b"] = -12, ["scene.period_f"] = 6,
      ["scene.period_b"] = 10, ["scene.f_light"] = 0.8, ["scene.f_dark"] = 0.2, ["scene.b_light"] = 0.9,
      ["scene.b_dark"] = 0.1, truth = { samples = 1024 } },
  },
  arms = {
    { name = "layered", pipeline = "hybrid_layered" },
    { name = "in_gather", pipeline = "experiments/pipelines/hybrid_steps.lua", set = { composite = "in_gather" } },
    { name = "alpha_over", pipeline = "experiments/pipelines/hybrid_steps.lua", set = { composite = "alpha_over" } },
    { name = "capped", pipeline = "hybrid_layered", set = { advance = "origin_kept" } },
    { name = "seed_linear", pipeline = "hybrid", set = { preset = "text", weights = "uniform", tile = 20, limit = 0.1 } },
    { name = "seed_linear, own edge", pipeline = "hybrid",
      set = { preset = "text", weights = "uniform", tile = 20, limit = 0.1, own_edge = true } },
  },
  truth = { pipeline = "ground_truth" },
  skip = function(point) return (in_stripes[point.arm] or false) ~= (point.shot == "harsh") end,
  regions = { "whole", "hidden" },
  measures = { "rmse", "masked" },
}
