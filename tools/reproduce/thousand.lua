-- SPDX-License-Identifier: MIT
-- Draws a thousand small points, to measure the time of a sweep in addition to drawing (docs/writing-experiments.md).
local experiment = require "strobe.experiment"

return experiment {
  title = "A thousand points",
  size = { 160, 90 },
  shots = { { name = "living_room", scene = "living_room" } },
  arms = { { name = "adaptive", pipeline = "adaptive" } },
  truth = { pipeline = "ground_truth", set = { samples = 64 } },
  vary = { experiment.list { name = "adaptive_times.same_depth", values = experiment.linear(0.001, 0.1, 1000) } },
  measures = { "rmse" },
}
