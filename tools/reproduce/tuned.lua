-- SPDX-License-Identifier: MIT
-- Compares the preset of experiments/tune with hybrid_traced, and also the second setting that docs/tuning.md describes.
local experiment = require "strobe.experiment"

return experiment {
  title = "Results of tuning",
  size = { 320, 180 },
  shots = { { name = "living_room", scene = "living_room" } },
  arms = {
    { name = "as given", pipeline = "hybrid_traced" },
    { name = "preset", pipeline = "experiments/pipelines/hybrid_steps.lua",
      set = { preset = "experiments/tune/living_room.lua" } },
    { name = "other", pipeline = "hybrid_layered", set = { ["composite.taps"] = "linear" } },
  },
  truth = { pipeline = "ground_truth", set = { samples = 256 } },
  regions = { "whole", "inner" },
  measures = { "rmse", "own_ratio" },
  rounds = 5,
}
