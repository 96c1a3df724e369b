-- SPDX-License-Identifier: MIT
-- Compares the preset of experiments/tune and the preset few_rays with the defaults of the pipeline adaptive.
local experiment = require "strobe.experiment"

return experiment {
  title = "Results of tuning",
  size = { 320, 180 },
  shots = { { name = "living_room", scene = "living_room" } },
  arms = {
    { name = "as given", pipeline = "adaptive" },
    { name = "preset", pipeline = "adaptive", set = { preset = "experiments/tune/living_room.lua" } },
    { name = "other", pipeline = "adaptive", set = { preset = "few_rays" } },
  },
  truth = { pipeline = "ground_truth", set = { samples = 256 } },
  regions = { "whole", "inner" },
  measures = { "rmse", "own_ratio" },
  rounds = 5,
}
