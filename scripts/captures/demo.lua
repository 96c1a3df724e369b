-- SPDX-License-Identifier: MIT
-- Figure 1 of Tan, Cui and Bhojan 2020, with numbers: a vase slides past a cushion, and a camera goes with it.
local demo = require "strobe.demo"

return demo {
  title = "Hybrid motion blur: what lies behind a moving object",
  note = "After figure 1 of Tan, Cui and Bhojan, \"Hybrid MBlur\" (SIGGRAPH '20 Posters): inside a moving object's " ..
         "silhouette the blur uncovers a background that the raster image does not have.",
  size = { 960, 540 },
  crop_size = { 120, 68 },
  difference_gain = 4,
  regions = { "whole", "inner", "hidden", "outer" },
  measures = { "rmse", "flip", "ms" },
  background = { column = "hybrid (best)", front = "no blur", color = "revealed", valid = "revealed_valid" },
  columns = {
    { label = "no blur", pipeline = "none" },
    { label = "McGuire 2012", pipeline = "mcguire2012" },
    { label = "UE4-style", pipeline = "ue4" },
    { label = "hybrid (as published)", pipeline = "hybrid", set = { preset = "seed" } },
    { label = "hybrid (best)", pipeline = "hybrid", set = { preset = "best" } },
    { label = "ray-traced, 16 samples", pipeline = "ground_truth", role = "floor", shown = false,
      set = { samples = 16, times = "midpoint" } },
    { label = "ground truth", pipeline = "ground_truth", role = "truth", set = { times = "stratified" } },
  },
  shots = {
    { title = "An object in motion", scene = "living_room", camera = "main", truth = { samples = 256 },
      crops = { { 480, 232, 120, 68 }, "inner" } },
    { title = "A tracking shot", scene = "living_room", camera = "tracking", truth = { samples = 64 },
      crops = { { 400, 195, 120, 68 }, "inner" } },
  },
}
