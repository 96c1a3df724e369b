-- SPDX-License-Identifier: MIT
-- Which of two things is in front depends on when: what comes nearer, a car over its road, what passes the near plane.
--   strobe sweep experiments/depths/depths.lua -o out/depths
local experiment = require "strobe.experiment"

local best, floor = "hybrid (best)", "truth, 16 samples"
local baselines = {
  ["McGuire 2012"] = "mcguire2012", ["UE4-style"] = "ue4", ["Guertin 2014"] = "guertin2014",
  ["Jimenez 2014"] = "jimenez2014", ["Bevy"] = "bevy", ["HDRP"] = "hdrp",
}
local names = { "McGuire 2012", "UE4-style", "Guertin 2014", "Jimenez 2014", "Bevy", "HDRP" }
local shots = { "nearer", "car", "chase", "drive", "thrown" }

local arms = {}
for _, name in ipairs(names) do arms[#arms + 1] = { name = name, pipeline = baselines[name], set = {} } end
arms[#arms + 1] = { name = best, pipeline = "hybrid", set = { preset = "best" } }

-- Without rays at their own time: depths of the capture, and those at the time of a sample.
local at_tap = { ["captured"] = "captured, depths of taps", ["Jimenez 2014"] = "Jimenez 2014, depths of taps" }
arms[#arms + 1] = { name = "captured", pipeline = "hybrid", set = { preset = "captured" } }
arms[#arms + 1] = { name = at_tap["captured"], pipeline = "hybrid", set = { preset = "captured", depths = "tap" } }
arms[#arms + 1] = { name = at_tap["Jimenez 2014"], pipeline = "jimenez2014", set = { depths = "tap" } }
arms[#arms + 1] = { name = floor, pipeline = "ground_truth", role = "floor", set = { samples = 16, times = "midpoint" } }

-- Of a measure in a region, the share that `best` has of the best baseline's: the largest over all shots that have the
-- region. Errors are those beyond truth with as many samples, whose squares add up.
local function largest_share(r, measure, region)
  local most, where = -1, "nowhere"
  for _, shot in ipairs(shots) do
    local function beyond(arm)
      local own = r.at { shot = shot, arm = arm, region = region }[measure]
      local least = r.at { shot = shot, arm = floor, region = region }[measure]
      return measure == "rmse" and math.sqrt(math.max(own * own - least * least, 0)) or math.max(own - least, 0)
    end
    if (r.at { shot = shot, arm = best, region = region }.pixels or 0) > 100 then
      local least, of = math.huge, ""
      for _, name in ipairs(names) do
        local own = beyond(name)
        if own < least then least, of = own, name end
      end
      local share = beyond(best) / least
      if share > most then most, where = share, ("%s, %s"):format(shot, of) end
    end
  end
  return most, where
end

local function a_third(measure, region, text)
  return { text, function(r)
    local most, where = largest_share(r, measure, region)
    return most <= 1 / 3, ("at most %.2f (%s)"):format(most, where)
  end }
end

-- In no shot a larger error by depths at the time of a sample, and in one a smaller by a tenth at least.
local function gains(name)
  local text = "%s, depths of taps: in no shot a larger error by more than 1 %%, in one a smaller by a tenth at least"
  return { text:format(name), function(r)
    local shares, least, most = {}, math.huge, -1
    for _, shot in ipairs(shots) do
      local function error_of(arm) return r.at { shot = shot, arm = arm, region = "whole" }.rmse end
      local share = error_of(at_tap[name]) / error_of(name)
      shares[#shares + 1] = ("%s %.2f"):format(shot, share)
      least, most = math.min(least, share), math.max(most, share)
    end
    return most <= 1.01 and least <= 0.9, table.concat(shares, ", ") .. " of its error"
  end }
end

return experiment {
  title    = "Depths at the time of a sample",
  question = "Which of two things is in front depends on when: what do methods make of it that compare depths of the capture?",
  note     = "Errors are compared beyond those of truth with as many samples. The box that is thrown away was added after " ..
    "the other shots had been measured, in which nothing passes from before one thing to behind it.",
  size     = { 320, 180 },
  size_params = { "width", "height" },
  shots    = {
    { name = "nearer", title = "A box comes nearer by half its distance", scene = "objects/nearer" },
    { name = "car", title = "A car over its road, which the camera follows", scene = "objects/car_and_road",
      ["scene.follow"] = 1, ["scene.pixels"] = 60 },
    { name = "chase", title = "A car from behind, marks of the road under it", scene = "objects/chase" },
    { name = "drive", title = "A post that the camera passes", scene = "objects/drive", anchor = "open" },
    { name = "thrown", title = "A box thrown away past a post, before it first", scene = "objects/thrown" },
  },
  arms     = arms,
  truth    = { pipeline = "ground_truth", set = { samples = 256, times = "stratified" } },
  regions  = { "whole", "inner", "hidden", "outer" },
  measures = { "rmse", "p999", "flip", "rays", "pixels" },
  expect   = {
    a_third("rmse", "inner", "inside what moves: at most a third of the best baseline's error, in every shot"),
    a_third("rmse", "hidden", "where something hidden shows: at most a third of the best baseline's error, in every shot"),
    a_third("rmse", "whole", "over the whole picture: at most a third of the best baseline's error, in every shot"),
    a_third("p999", "whole",
      "no streak: the error that one pixel in a thousand exceeds is at most a third of the best baseline's"),
    gains("captured"), gains("Jimenez 2014"),
  },
  layout   = { table = {} },
}
