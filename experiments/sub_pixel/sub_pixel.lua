-- SPDX-License-Identifier: MIT
-- Measures errors with few and many samples, under motion by less than a pixel and by many pixels. Under slow motion
-- and with many samples, the remaining errors are steps at silhouettes, and textures that are smoothed because a layer
-- stores one colour per pixel.
--   strobe sweep experiments/sub_pixel/sub_pixel.lua -o out/sub_pixel
local experiment = require "strobe.experiment"

local speeds, counts = { 0.3, 1, 3, 10, 30, 100 }, { 1, 4, 16, 64 }
local best, floor = "adaptive", "truth, as many samples"

-- Reasons why some of the expectations below failed; reports print these reasons.
local tolerance = "at its default quality adaptive gathers surfaces whose displacements differ by at most 0.35 px. " ..
                  "If they differ more, the error depends on the error tolerance that the parameter `quality` sets, " ..
                  "and more samples do not reduce it"
local many = "if a surface moves fast, adaptive traces the first rays of a pixel at many times, while truth traces moving " ..
             "objects only where they are at the time of the sample"

-- Returns the error of `arm` divided by the error of `other`: the largest ratio and the least ratio over all speeds and numbers
-- of samples. After each ratio comes the name of its point (speed and number).
local function ratios(r, arm, other)
  local most, least, most_at, least_at = 0, math.huge, "", ""
  for _, speed in ipairs(speeds) do
    for _, count in ipairs(counts) do
      local function error_of(name) return r.at { arm = name, speed = speed, samples = count }.rmse end
      local ratio, where = error_of(arm) / error_of(other), ("%g px, %d samples"):format(speed, count)
      if ratio > most then most, most_at = ratio, where end
      if ratio < least then least, least_at = ratio, where end
    end
  end
  return most, most_at, least, least_at
end

local function arm(name, pipeline, set) return { name = name, pipeline = pipeline, set = set } end

return experiment {
  title    = "Sub-pixel motion",
  question = "Is adaptive as accurate as truth with as many samples, also under motion by less than a pixel?",
  note     = "A panel of cells passes a wall of cells along a line at 17 degrees to the rows of pixels. All methods sample " ..
             "the centres of pixels. Speeds are px over the exposure.",
  size     = { 240, 136 },
  shots    = { { name = "passage", title = "A panel passes a wall", scene = "stability/passage", ["scene.angle"] = 17 } },
  arms     = {
    arm("McGuire 2012", "mcguire2012", { limit = "auto" }),
    arm(best, "adaptive"),
    { name = floor, pipeline = "ground_truth", role = "floor", set = { times = "midpoint" } },
  },
  truth    = { pipeline = "ground_truth", set = { samples = 1024, times = "midpoint" } },
  vary     = {
    experiment.list { name = "speed", title = "Speed", unit = "px", scale = "log", benign = 30, region = "whole",
      values = speeds, at = function(speed) return { ["scene.speed"] = speed } end },
    experiment.list { name = "samples", title = "Samples", scale = "log", benign = 16, region = "whole", values = counts },
  },
  regions  = { "whole", "inner", "outer" },
  measures = { "rmse", "flip", "rays", "pixels" },
  expect   = {
    { "the error of adaptive is at most 1.3 times the error of truth with as many samples, at every speed and number " ..
      "of samples", known = tolerance, function(r)
      local most, where = ratios(r, best, floor)
      return most <= 1.3, ("at most %.2f times the error (%s)"):format(most, where)
    end },
    { "from 4 samples on adaptive needs at most a tenth of the rays of truth with as many samples",
      known = many, function(r)
      local most, where = 0, ""
      for _, speed in ipairs(speeds) do
        for _, count in ipairs { 4, 16, 64 } do
          local function rays_of(name) return r.at { arm = name, speed = speed, samples = count }.rays end
          local ratio = rays_of(best) / rays_of(floor)
          if ratio > most then most, where = ratio, ("%g px, %d samples"):format(speed, count) end
        end
      end
      return most <= 0.1, ("at most %.3f (%s)"):format(most, where)
    end },
    { "McGuire 2012 has more than 1.3 times the error of truth with as many samples, from 3 px and 4 samples on", function(r)
      local least, where = math.huge, ""
      for _, speed in ipairs { 3, 10, 30, 100 } do
        for _, count in ipairs { 4, 16, 64 } do
          local function error_of(name) return r.at { arm = name, speed = speed, samples = count }.rmse end
          local ratio = error_of("McGuire 2012") / error_of(floor)
          if ratio < least then least, where = ratio, ("%g px, %d samples"):format(speed, count) end
        end
      end
      return least > 1.3, ("at least %.1f times the error (%s)"):format(least, where)
    end },
  },
  layout   = { curves = { factor = 1.3 }, table = {} },
}
