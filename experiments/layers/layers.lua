-- SPDX-License-Identifier: MIT
-- What further layers buy: surfaces revealed one behind another, layers of the exposure's other end, and rays at their own
-- time instead.
--   strobe sweep experiments/layers/layers.lua -o out/layers
local experiment = require "strobe.experiment"

local names = { "1 layer", "2 layers", "3 layers", "4 layers" }
local shots = { "two", "three", "four", "alike", "enters", "telescope", "tracking" }
local with_end, own_times = "4 layers and the end's", "own times"

local function at(r, shot, arm, region) return r.at { shot = shot, arm = arm, region = region or "whole" } end

-- The error falls from layer to layer, up to so many.
local function falls(layers, shot, title)
  return { ("%s: the error falls with each of %d layers"):format(title, layers), shot = shot, function(r)
    local texts, good, last = {}, true, math.huge
    for layer = 1, layers do
      local error = at(r, shot, names[layer]).rmse
      good, last = good and error < last, error
      texts[layer] = ("%.4f"):format(error)
    end
    return good, "RMSE " .. table.concat(texts, ", ")
  end }
end

local arms = { { name = "McGuire 2012", pipeline = "mcguire2012" } }
for count, name in ipairs(names) do
  arms[#arms + 1] = { name = name, pipeline = "hybrid", set = { preset = "captured", revealed_layers = count } }
end
arms[#arms + 1] = { name = with_end, pipeline = "hybrid", set = { preset = "layers" } }
arms[#arms + 1] = { name = own_times, pipeline = "hybrid", set = { preset = "best" } }
arms[#arms + 1] = { name = own_times .. " and the end's layer", pipeline = "hybrid",
  set = { preset = "best", end_layers = true } }
arms[#arms + 1] = { name = "truth, 16 samples", pipeline = "ground_truth", role = "floor",
  set = { samples = 16, times = "midpoint" } }

local function stacked(name, title, count, equal)
  return { name = name, title = title, scene = "objects/stacked", ["scene.count"] = count, ["scene.equal"] = equal or false,
           ["scene.pixels"] = 53 }
end

return experiment {
  title    = "Layers",
  question = "What does another layer buy, and when is a ray at its own time worth more?",
  note     = "Boxes one behind the other, each moving its own way by about 53 px; then what leaves and enters the picture, " ..
             "what turns, and a tracking shot. \"The end's\" is a layer of what the start of the exposure sees and no layer " ..
             "of the capture holds. Times are ratios to McGuire 2012.",
  size     = { 320, 180 },
  size_params = { "width", "height" },
  shots    = {
    stacked("two", "Two movers", 2), stacked("three", "Three movers", 3), stacked("four", "Four movers", 4),
    stacked("alike", "Four movers alike", 4, true),
    { name = "enters", title = "Leaves and enters", scene = "objects/enters" },
    { name = "telescope", title = "Telescope", scene = "objects/telescope" },
    { name = "tracking", title = "Tracking shot", scene = "objects/tracking_parallax" },
  },
  arms     = arms,
  truth    = { pipeline = "ground_truth", set = { samples = 256, times = "stratified" } },
  base     = "McGuire 2012",
  rounds   = 5,
  regions  = { "whole", "inner", "hidden", "outer" },
  measures = { "rmse", "flip", "ms_ratio", "rays", "pixels" },
  expect   = {
    falls(2, "two", "two movers"), falls(3, "three", "three movers"), falls(3, "four", "four movers"),
    falls(3, "alike", "four movers alike"),
    { "equal colours make no difference: the same rays find the same pixels", function(r)
      local good, texts = true, {}
      for i, name in ipairs(names) do
        local one, other = at(r, "four", name).rays, at(r, "alike", name).rays
        good, texts[i] = good and one == other, ("%d"):format(one)
      end
      return good, "rays " .. table.concat(texts, ", ")
    end },
    { "what leaves the picture before the capture is in the end's layer: with it the error outside of silhouettes falls " ..
      "to a third", shot = "enters", function(r)
        local without, own = at(r, "enters", names[4], "outer").rmse, at(r, "enters", with_end, "outer").rmse
        return own <= without / 3, ("RMSE %.4f and %.4f"):format(without, own)
      end },
    { "found afterwards: the end's layer costs no error: with it at most a fiftieth more than without, in every shot",
      function(r)
        local most, where = 0, ""
        for _, shot in ipairs(shots) do
          local ratio = at(r, shot, with_end).rmse / at(r, shot, names[4]).rmse
          if ratio > most then most, where = ratio, shot end
        end
        return most <= 1.02, ("at most %.2f times (%s)"):format(most, where)
      end },
    { "rays at their own time leave less than any number of layers, in every shot", function(r)
      local most, where = 0, ""
      for _, shot in ipairs(shots) do
        local ratio = at(r, shot, own_times).rmse / at(r, shot, with_end).rmse
        if ratio > most then most, where = ratio, shot end
      end
      return most < 1, ("at most %.2f of it (%s)"):format(most, where)
    end },
  },
  layout   = { front = { x = "ms_ratio", y = "rmse", region = "whole" }, table = {} },
}
