-- SPDX-License-Identifier: MIT
-- A thousand small points, which show the time of a sweep besides drawing (docs/writing-experiments.md).
local experiment = require "strobe.experiment"

return experiment {
  title = "A thousand points",
  size = { 160, 90 },
  shots = { { name = "living_room", scene = "living_room" } },
  arms = { { name = "hybrid", pipeline = "hybrid_traced" } },
  truth = { pipeline = "ground_truth", set = { samples = 64 } },
  vary = { experiment.list { name = "depth_extent", values = experiment.linear(0.001, 0.1, 1000) } },
  measures = { "rmse" },
}
