-- SPDX-License-Identifier: MIT
-- Measures how error and time depend on the number of samples and the tile size, with and without rays.
local experiment = require "strobe.experiment"

local function inner(r, arm, samples, tile)
  return r.at { arm = arm, samples = samples, tile = tile, region = "inner" }.rmse
end

local bounded = "from 8 samples on the error of adaptive depends on the error tolerance of its quality, not on the " ..
  "number of samples"

-- Returns the expectation that the inner error of an arm falls at least by half from 4 to 64 samples.
local function samples_help(arm, known)
  return { ("samples help %s: from 4 to 64 samples its inner error falls at least by half"):format(arm), known = known,
    function(r)
      local ratio = inner(r, arm, 64, 40) / inner(r, arm, 4, 40)
      return ratio <= 0.5, ("to %.2f of the error"):format(ratio)
    end }
end

return experiment {
  title    = "Samples and tiles",
  question = "How does the error change with the number of samples, the tile size and the time of a frame?",
  note     = "The vase of the living room slides past the cushions. Times are ratios to McGuire 2012 with 4 samples and " ..
             "tiles of 10 px.",
  size     = { 320, 180 },
  shots    = { { name = "vase", title = "Vase", scene = "living_room", camera = "main" } },
  arms     = {
    { name = "McGuire 2012", pipeline = "mcguire2012" },
    { name = "UE4-style", pipeline = "ue4" },
    { name = "hybrid_layered", pipeline = "hybrid_layered" },
    { name = "adaptive", pipeline = "adaptive" },
  },
  truth    = { pipeline = "ground_truth", set = { samples = 512, times = "stratified" } },
  base     = "McGuire 2012",
  rounds   = 5, most_rounds = 25, within = 0.05,
  vary     = { experiment.grid { samples = { 4, 8, 16, 32, 64 }, tile = { 10, 20, 40 } } },
  regions  = { "whole", "inner", "outer" },
  measures = { "rmse", "flip", "ms", "ms_ratio" },
  expect   = {
    { "inside the silhouette adaptive has a smaller error with 8 samples than each baseline with 64", function(r)
      local own, best = inner(r, "adaptive", 8, 40), math.huge
      for _, arm in ipairs { "McGuire 2012", "UE4-style" } do best = math.min(best, inner(r, arm, 64, 40)) end
      return own < best, ("%.4f and %.4f"):format(own, best)
    end },
    { "samples do not help methods that estimate the background: from 4 to 64 samples the inner error of each baseline " ..
      "falls by less than a fifth",
      function(r)
        local worst = 0
        for _, arm in ipairs { "McGuire 2012", "UE4-style" } do
          worst = math.max(worst, 1 - inner(r, arm, 64, 40) / inner(r, arm, 4, 40))
        end
        return worst < 0.2, ("at most %.0f %%"):format(100 * worst)
      end },
    samples_help "hybrid_layered", samples_help("adaptive", bounded),
    { "the tile size changes the inner error of hybrid_layered by at most a tenth", function(r)
      local most = 0
      for _, samples in ipairs { 4, 8, 16, 32, 64 } do
        local middle = inner(r, "hybrid_layered", samples, 20)
        for _, tile in ipairs { 10, 40 } do
          most = math.max(most, math.abs(inner(r, "hybrid_layered", samples, tile) / middle - 1))
        end
      end
      return most <= 0.1, ("at most %.1f %%"):format(100 * most)
    end },
  },
  layout   = { front = { x = "ms_ratio", y = "rmse", region = "inner" }, table = {} },
}
