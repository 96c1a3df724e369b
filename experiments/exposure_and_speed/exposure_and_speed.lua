-- SPDX-License-Identifier: MIT
-- Measures the errors of post-process blurs, of the hybrid and of adaptive at many pairs of exposure and speed.
local experiment = require "strobe.experiment"

-- Reasons why some of the expectations below failed; reports print these reasons.
local all_moves = "in a tracking shot nearly all pixels get rays at several times"
local slow = "at 3 px truth needs few samples, while the error tolerance of the default quality keeps adaptive from " ..
             "a smaller error"

local best, published = "adaptive", "hybrid"
local baselines = { "McGuire 2012", "Guertin 2014", "Jimenez 2014", "UE4-style" }
local exposures, speeds = { 0.25, 0.5, 1 }, { 13, 26, 52 }

local function at(r, arm, shot, speed, exposure, region)
  return r.at { arm = arm, shot = shot, speed = speed, exposure = exposure, region = region or "inner" }
end

-- Returns the largest value of `of(shot, speed, exposure)` over all shots, speeds and exposures, and the name of this point.
local function most(shots, of)
  local largest, where = -math.huge, ""
  for _, shot in ipairs(shots) do
    for _, speed in ipairs(speeds) do
      for _, exposure in ipairs(exposures) do
        local value = of(shot, speed, exposure)
        if value > largest then
          largest, where = value, ("%s, %d px a frame, exposure %g"):format(shot, speed, exposure)
        end
      end
    end
  end
  return largest, where
end

local function best_baseline(r, ...)
  local least = math.huge
  for _, name in ipairs(baselines) do least = math.min(least, at(r, name, ...).rmse) end
  return least
end

-- Returns the expectation that the error of `arm` is below `factor` times the error of the best post-process, at every speed
-- and exposure of `shots`.
local function less(arm, factor, shots, text, known)
  return { text, known = known, function(r)
    local ratio, where = most(shots, function(...) return at(r, arm, ...).rmse / best_baseline(r, ...) end)
    return ratio < factor, ("at most %.2f times the error of the best post-process (%s)"):format(ratio, where)
  end }
end

-- Longest displacement that filters handle, image widths. The displacements here are shorter: at most 52 of 320 px, 0.16
-- widths.
local limit = 0.4
local arms = { { name = "no blur", pipeline = "none" } }
for i, pipeline in ipairs { "mcguire2012", "guertin2014", "jimenez2014", "ue4" } do
  arms[#arms + 1] = { name = baselines[i], pipeline = pipeline, set = { limit = limit } }
end
arms[#arms + 1] = { name = published, pipeline = "hybrid", set = { limit = limit } }
arms[#arms + 1] = { name = best, pipeline = "adaptive", set = { limit = limit } }
arms[#arms + 1] = { name = "truth, 16 samples", pipeline = "ground_truth", role = "floor",
                    set = { samples = 16, times = "midpoint" } }

return experiment {
  title    = "Exposure and speed",
  question = "Over exposures and speeds, how large are the errors and the costs of post-process blurs, of the hybrid and " ..
             "of adaptive?",
  note     = "The vase of the living room slides past the cushions. The camera is at rest in one shot and follows " ..
             "the vase in the other. The displacement is speed times exposure, 3 to 52 px, and is not clamped. " ..
             "Every method has 16 samples. Times are ratios to McGuire 2012.",
  size     = { 320, 180 },
  size_params = { "width", "height" },
  shots    = {
    { name = "object", title = "An object in motion", scene = "living_room", camera = "main" },
    { name = "tracking", title = "A tracking shot", scene = "living_room", camera = "tracking" },
  },
  arms     = arms,
  truth    = { pipeline = "ground_truth", set = { samples = 128, times = "stratified" } },
  base     = "McGuire 2012",
  rounds   = 5,
  vary     = {
    -- The scene moves the vase by its parameter `pixels` (px) over half a frame, the exposure in the scene's file.
    experiment.list { name = "speed", title = "Speed", unit = "px a frame", scale = "log", benign = 13, region = "inner",
      values = speeds, at = function(speed) return { ["scene.pixels"] = speed / 2 } end },
    experiment.list { name = "exposure", title = "Exposure", unit = "frames", scale = "log", benign = 0.25,
      region = "inner", values = exposures },
  },
  regions  = { "whole", "inner", "outer" },
  measures = { "rmse", "flip", "ms_ratio", "displacement", "clamped" },
  expect   = {
    less(best, 0.5, { "object" },
      "with a camera at rest, the inner error of adaptive is less than half of that of the best post-process, at " ..
      "every speed and exposure"),
    less(best, 1, { "tracking" },
      "in the tracking shot the inner error of adaptive is below that of the best post-process, at every speed and " ..
      "exposure"),
    less(published, 1, { "object" },
      "as the paper claims, the inner error of the hybrid as published is below that of the best post-process"),
    { "with a camera at rest, the inner error of adaptive is at most twice the error of truth with 16 samples",
      known = slow, function(r)
        local ratio, where = most({ "object" }, function(...)
          return at(r, best, ...).rmse / at(r, "truth, 16 samples", ...).rmse
        end)
        return ratio <= 2, ("at most %.2f times (%s)"):format(ratio, where)
      end },
    { "the error of post-process grows with the displacement: the smallest inner error of all post-processes at 52 px is at " ..
      "least twice that at 3 px", function(r)
        local short, long = best_baseline(r, "object", 13, 0.25), best_baseline(r, "object", 52, 1)
        return long >= 2 * short, ("%.4f at 3 px, %.4f at 52 px"):format(short, long)
      end },
    { "only the product of speed and exposure matters: errors at equal displacements differ by less than a hundredth",
      function(r)
        local difference = 0
        for _, arm in ipairs { best, published, table.unpack(baselines) } do
          local fast, long = at(r, arm, "object", 52, 0.5).rmse, at(r, arm, "object", 26, 1).rmse
          difference = math.max(difference, math.abs(fast / long - 1))
        end
        return difference < 0.01, ("largest relative difference %.1g"):format(difference)
      end },
    { "a frame of adaptive takes at most twice the time of McGuire 2012 (the paper reports 1.44 times for its hybrid)",
      known = all_moves, function(r)
      local cost, where = most({ "object", "tracking" }, function(...) return at(r, best, ...).ms_ratio end)
      local mean = r.at { arm = best }.ms_ratio
      return cost <= 2, ("%.2f on average, at most %.2f (%s)"):format(mean, cost, where)
    end },
    { "no displacement is clamped", function(r)
      local clamped = 0
      for _, arm in ipairs { best, published, table.unpack(baselines) } do clamped = clamped + r.at { arm = arm }.clamped end
      return clamped == 0, ("%d pixels"):format(clamped)
    end },
  },
  layout   = { front = { x = "ms_ratio", y = "rmse", region = "inner",
                         note = "Compare only marks with equal speed and exposure: other displacements are other pictures." },
               table = {} },
}
