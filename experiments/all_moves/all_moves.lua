-- SPDX-License-Identifier: MIT
-- Compares the pipeline adaptive with ground truth and with an accumulation buffer, by time and error, under moving cameras.
--   strobe sweep experiments/all_moves/all_moves.lua -o out/all_moves
local experiment = require "strobe.experiment"

local base, layers, drawn = "McGuire 2012", "hybrid_layered", "accumulation buffer"
local few, equal = "truth, 4 samples", "truth, 16 samples"  -- `equal`: as many samples as the other arms
local qualities = { 0.1, 0.2, 0.4 }

local function adaptive(quality) return ("adaptive, quality %g"):format(quality) end

local best = adaptive(0.4)  -- the default quality

local at_rest = "with a camera at rest truth traces and shades pixels without motion only once, so it takes less " ..
                "time than three post-process frames"

local everywhere = "if the whole picture moves, nearly every pixel gets rays. A frame with enough rays to reduce " ..
                   "the error to a quarter takes more than 4 times the time of McGuire 2012"

local road_mark = "the road mark passes some pixels between two rays of similar colour. At a quality of 0.6 the error is " ..
                  "below the error of truth with as many samples"

local finer = "adaptive chooses the times of its rays among twice as many times as there are samples, so its error " ..
              "may be below the error of an accumulation buffer with as many samples"

local function at(r, arm, shot) return r.at { shot = shot, arm = arm } end

-- Returns the largest value of the function `of` over `shots`, and the name of the shot with this value.
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

local arms = {
  { name = base, pipeline = "mcguire2012", set = { samples = 16 } },
  { name = layers, pipeline = "hybrid_layered" },
}
for _, quality in ipairs(qualities) do
  arms[#arms + 1] = { name = adaptive(quality), pipeline = "adaptive", set = { quality = quality } }
end
arms[#arms + 1] = { name = drawn, pipeline = "accumulation", timed = true, set = { samples = 16 } }
for _, one in ipairs { { few, 4 }, { equal, 16 } } do
  arms[#arms + 1] = { name = one[1], pipeline = "ground_truth", timed = true, set = { samples = one[2], mark_regions = false } }
end

-- Returns the names of the shots and settings of adaptive where the arm `other` has both a smaller error and less time.
local function dominated(r, other)
  local names = {}
  for _, shot in ipairs(all) do
    local by = at(r, other, shot)
    for _, quality in ipairs(qualities) do
      local own = at(r, adaptive(quality), shot)
      if by.rmse < own.rmse and by.ms_ratio < own.ms_ratio then
        names[#names + 1] = ("%s, quality %g, by %s"):format(shot, quality, other)
      end
    end
  end
  return names
end

return experiment {
  title    = "Cost under moving cameras",
  question = "If the whole picture moves, is adaptive cheaper than truth or an accumulation buffer with as many samples?",
  note     = "There are four shots. A vase slides, and the camera is at rest. In the same room a camera follows the " ..
             "vase. A camera moves sideways past posts, balls and boxes. A camera follows a car over a road. All " ..
             "methods have 16 samples; truth has 16 in one arm and 4 in another. Times are ratios to McGuire 2012, " ..
             "and the arms are timed in turn in one run. The times of truth do not include the marking of regions.",
  size     = { 480, 270 },
  shots    = {
    { name = "vase", title = "The vase slides, camera at rest", scene = "living_room", camera = "main" },
    { name = "tracking", title = "The camera follows the vase", scene = "living_room", camera = "tracking" },
    { name = "parallax", title = "Past objects at many depths", scene = "objects/tracking_parallax" },
    { name = "chase", title = "Behind a car", scene = "objects/chase" },
  },
  arms     = arms,
  truth    = { pipeline = "ground_truth", set = { samples = 256 } },
  base     = base,
  rounds   = 15,
  regions  = { "whole" },
  measures = { "rmse", "ms_ratio", "rays" },
  expect   = {
    { "with a camera at rest adaptive takes at most a fifth of the time of truth with as many samples", known = at_rest,
      function(r)
        local share = ratio(r, best, equal, "ms_ratio")("vase")
        return share <= 0.2, ("%.2f of the time"):format(share)
      end },
    { "in no shot and at no quality does adaptive take longer than truth with as many samples", function(r)
      local share, which = 0, ""
      for _, quality in ipairs(qualities) do
        local own, where = most(all, ratio(r, adaptive(quality), equal, "ms_ratio"))
        if own > share then share, which = own, ("%s, quality %g"):format(where, quality) end
      end
      return share <= 1, ("at most %.2f of the time (%s)"):format(share, which)
    end },
    { "in every shot adaptive has, at one of its qualities, at most a quarter of the error of McGuire 2012 in at most 4 " ..
      "times its time", known = everywhere, function(r)
      local all_reach, texts = true, {}
      for _, shot in ipairs(all) do
        local least = math.huge
        for _, quality in ipairs(qualities) do
          if ratio(r, adaptive(quality), base, "ms_ratio")(shot) <= 4 then
            least = math.min(least, ratio(r, adaptive(quality), base, "rmse")(shot))
          end
        end
        all_reach = all_reach and least <= 0.25
        texts[#texts + 1] = ("%s %.2f"):format(shot, least)
      end
      return all_reach, "of the error: " .. table.concat(texts, ", ")
    end },
    { "the error of adaptive is at most 1.5 times the error of truth with as many samples", known = road_mark,
      function(r)
      local share, where = most(all, ratio(r, best, equal, "rmse"))
      return share <= 1.5, ("at most %.2f times the error (%s)"):format(share, where)
    end },
    { "in every shot the error of the accumulation buffer is at most 1.1 times the error of adaptive", known = finer,
      function(r)
      local share, where = most(all, ratio(r, drawn, best, "rmse"))
      return share <= 1.1, ("at most %.2f times the error (%s)"):format(share, where)
    end },
    { "in no shot does truth or the accumulation buffer have both a smaller error and less time than a setting of adaptive",
      function(r)
        local names = {}
        for _, other in ipairs { few, equal, drawn } do
          for _, name in ipairs(dominated(r, other)) do names[#names + 1] = name end
        end
        return #names == 0, #names == 0 and "none" or table.concat(names, "; ")
      end,
      known = "drawing these scenes at 16 times takes about as long as the rays of adaptive" },
    { "hybrid_layered has a smaller error than McGuire 2012, in every shot", function(r)
      local share, where = most(all, ratio(r, layers, base, "rmse"))
      return share < 1, ("at most %.2f times the error (%s)"):format(share, where)
    end },
  },
  layout   = { table = {} },
}
