-- SPDX-License-Identifier: MIT
-- Where everything moves, is the hybrid cheaper than truth with as many samples, or than drawing all at each time?
--   strobe sweep experiments/all_moves/all_moves.lua -o out/all_moves
local experiment = require "strobe.experiment"

local base, layers, best, few = "McGuire 2012", "hybrid, layers alone", "hybrid (best)", "truth, 16 samples"
local drawn = "accumulation buffer"

local left_open = "what bends, what comes by a motion that its tile does not know and what has more motions at a pixel than " ..
                  "layers follow is left to rays at their own time, here nearly all, and masking and layers come on top"

local at_rest = "truth traces and shades once what nothing in motion reaches, so that before a camera at rest it takes less " ..
                "than three frames of post-process"

local cheaper = "the hybrid takes less than when this was found, with 0.64"

local function at(r, arm, shot) return r.at { shot = shot, arm = arm } end

-- The largest of a number over shots, and where.
local function most(shots, of)
  local found, where = -math.huge, ""
  for _, shot in ipairs(shots) do
    local value = of(shot)
    if value > found then found, where = value, shot end
  end
  return found, where
end

local function ratio(r, arm, other, measure)
  return function(shot) return at(r, arm, shot)[measure] / at(r, other, shot)[measure] end
end

local all = { "vase", "tracking", "parallax", "chase" }

return experiment {
  title    = "Where everything moves",
  question = "Where everything moves, is the hybrid cheaper than truth with as many samples, or than drawing all at each time?",
  note     = "A vase that slides before a camera at rest; the same room from a camera that goes along with the vase; a " ..
             "camera that goes sideways past posts, balls and boxes; one that follows a car over a road. All with 16 " ..
             "samples. Times are ratios to McGuire 2012, alternately in one run. Truth with 16 samples tells no regions here.",
  size     = { 480, 270 },
  shots    = {
    { name = "vase", title = "The vase slides, camera at rest", scene = "living_room", camera = "main" },
    { name = "tracking", title = "The camera goes with the vase", scene = "living_room", camera = "tracking" },
    { name = "parallax", title = "Past things at many depths", scene = "objects/tracking_parallax" },
    { name = "chase", title = "Behind a car", scene = "objects/chase" },
  },
  arms     = {
    { name = base, pipeline = "mcguire2012", set = { samples = 16 } },
    { name = layers, pipeline = "hybrid_layered", set = { ["composite.taps"] = "linear" } },
    { name = best, pipeline = "hybrid_traced" },
    { name = drawn, pipeline = "accumulation", timed = true, set = { samples = 16 } },
    { name = few, pipeline = "ground_truth", timed = true, set = { samples = 16, mark_regions = false } },
  },
  truth    = { pipeline = "ground_truth", set = { samples = 256 } },
  base     = base,
  rounds   = 15,
  regions  = { "whole" },
  measures = { "rmse", "ms_ratio", "rays" },
  expect   = {
    { "before a camera at rest the hybrid (best) takes at most a fifth of the time of truth with as many samples",
      known = at_rest,
      function(r)
        local share = ratio(r, best, few, "ms_ratio")("vase")
        return share <= 0.2, ("%.2f of it"):format(share)
      end },
    { "in no shot does it take longer than truth with as many samples", known = left_open,
      function(r)
        local share, where = most(all, ratio(r, best, few, "ms_ratio"))
        return share <= 1, ("at most %.2f of it (%s)"):format(share, where)
      end },
    { "found afterwards: its error is at most one and a half times that of truth with as many samples",
      function(r)
        local share, where = most(all, ratio(r, best, few, "rmse"))
        return share <= 1.5, ("at most %.2f of it (%s)"):format(share, where)
      end },
    { "found afterwards: the accumulation buffer errs at most a tenth more than the hybrid (best) in any shot",
      function(r)
        local share, where = most(all, ratio(r, drawn, best, "rmse"))
        return share <= 1.1, ("at most %.2f of its error (%s)"):format(share, where)
      end },
    { "found afterwards: past things at many depths and behind a car it takes at most two thirds of the hybrid's time",
      known = cheaper,
      function(r)
        local share, where = most({ "parallax", "chase" }, ratio(r, drawn, best, "ms_ratio"))
        return share <= 2 / 3, ("at most %.2f of it (%s)"):format(share, where)
      end },
    { "without rays at their own time the hybrid errs less than McGuire 2012 in every shot",
      function(r)
        local share, where = most(all, ratio(r, layers, base, "rmse"))
        return share < 1, ("at most %.2f of its error (%s)"):format(share, where)
      end },
  },
  layout   = { table = {} },
}
