-- SPDX-License-Identifier: MIT
-- Figure 1 of Tan, Cui and Bhojan 2020, with numbers: a vase slides past a cushion, and a camera goes with it.
-- Expected: inside the silhouette of what moves the hybrid errs less than either baseline.
--   strobe demo
local experiment = require "strobe.experiment"

local baselines = { "McGuire 2012", "UE4-style" }

local function less_than_baselines(shot)
  return { "hybrid (best) errs less than either baseline inside what moves", shot = shot, function(r)
    local function error_of(arm) return r.at { shot = shot, arm = arm, region = "inner" }.rmse end
    local own, best = error_of "hybrid (best)", math.huge
    for _, name in ipairs(baselines) do best = math.min(best, error_of(name)) end
    return own < best, ("RMSE %.5f, %.2f of the better baseline's"):format(own, own / best)
  end }
end

return experiment {
  title = "Hybrid motion blur: what lies behind a moving object",
  note = "After figure 1 of Tan, Cui and Bhojan, \"Hybrid MBlur\" (SIGGRAPH '20 Posters): inside a moving object's " ..
         "silhouette the blur uncovers a background that the raster image does not have.",
  size = { 960, 540 },
  measures = { "rmse", "flip", "ms" },
  background = { arm = "hybrid (best)", front = "no blur", color = "revealed", valid = "revealed_valid" },
  arms = {
    { name = "no blur", pipeline = "none" },
    { name = "McGuire 2012", pipeline = "mcguire2012" },
    { name = "UE4-style", pipeline = "ue4" },
    { name = "hybrid (as published)", pipeline = "hybrid", set = { preset = "seed" } },
    { name = "hybrid (best)", pipeline = "hybrid", set = { preset = "best" } },
    { name = "ray-traced, 16 samples", pipeline = "ground_truth", role = "floor", shown = false,
      set = { samples = 16, times = "midpoint" } },
  },
  truth = { pipeline = "ground_truth", set = { times = "stratified" } },
  shots = {
    { name = "object", title = "An object in motion", scene = "living_room", camera = "main",
      truth = { samples = 256 }, crops = { { 480, 232, 120, 68 }, "inner" } },
    { name = "tracking", title = "A tracking shot", scene = "living_room", camera = "tracking",
      truth = { samples = 64 }, crops = { { 400, 195, 120, 68 }, "inner" } },
  },
  expect = { less_than_baselines "object", less_than_baselines "tracking" },
  layout = { pictures = { crop_size = { 120, 68 }, difference_gain = 4 } },
}
