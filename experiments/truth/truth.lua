-- SPDX-License-Identifier: MIT
-- Measures the time that ground truth needs for a given error, in two modes: it traces every ray, or it skips a ray if
-- the first samples of the pixel agree on the result of that ray. Samples are spread over the area of each pixel.
--   strobe sweep experiments/truth/truth.lua -o out/truth
local experiment = require "strobe.experiment"

local brute, spared = "every ray", "what is known is spared"
local counts = { 8, 16, 32, 64, 128, 256 }
local shots = {
  { name = "plain", title = "A bar, unlit", scene = "oracles/bar" },
  { name = "room", title = "Living room, the vase slides", scene = "living_room", camera = "main" },
  { name = "tracking", title = "Living room, the camera follows", scene = "living_room", camera = "tracking" },
}

local function arm(name, mode)
  return { name = name, pipeline = "ground_truth", timed = true, set = { pixel = "box", mode = mode, mark_regions = false } }
end

local function at(r, shot, name, samples) return r.at { shot = shot.name, arm = name, samples = samples } end

-- Returns the time of an arm with `samples` samples, divided by the time that the arm `of` needs for an equal error. This time
-- is interpolated or extrapolated from the measured points of `of`, linearly in log(error) and log(time).
local function share(r, shot, name, samples, of)
  local own, k = at(r, shot, name, samples), 1
  while k < #counts - 1 and at(r, shot, of, counts[k + 1]).rmse > own.rmse do k = k + 1 end
  local a, b = at(r, shot, of, counts[k]), at(r, shot, of, counts[k + 1])
  local slope = math.log(b.ms_ratio / a.ms_ratio) / math.log(b.rmse / a.rmse)
  return own.ms_ratio / (a.ms_ratio * (own.rmse / a.rmse) ^ slope)
end

return experiment {
  title    = "Cost of truth",
  question = "How much of the time for a given error does truth save by skipping rays with a known result?",
  note     = "Samples cover the whole pixel. Times are ratios to the arm \"every ray\" with 8 samples in the same shot. The " ..
             "reference has noise too, which adds to all errors equally.",
  size     = { 320, 180 },
  shots    = shots,
  arms     = { arm(brute, "brute"), arm(spared, "rays") },
  base     = brute,
  truth    = { pipeline = "ground_truth", set = { samples = 4096, pixel = "box", mode = "brute", mark_regions = false } },
  rounds   = 3,
  vary     = { experiment.grid { samples = counts } },
  regions  = { "whole" },
  measures = { "rmse", "ms_ratio", "rays" },
  expect   = {
    { "skipping rays changes the error by at most a fiftieth", function(r)
      local most = 0
      for _, shot in ipairs(shots) do
        for _, samples in ipairs(counts) do
          most = math.max(most, math.abs(at(r, shot, spared, samples).rmse / at(r, shot, brute, samples).rmse - 1))
        end
      end
      return most <= 0.02, ("at most %.2f %%"):format(100 * most)
    end },
    { "in a lit room with a camera at rest, truth that skips rays takes at most 0.8 times the time of truth with " ..
      "every ray for the same error, from 64 samples on", function(r)
      local most = 0
      for _, samples in ipairs(counts) do
        if samples >= 64 then most = math.max(most, share(r, shots[2], spared, samples, brute)) end
      end
      return most <= 0.8, ("at most %.2f"):format(most)
    end },
    { "twice as many samples leave less than 0.71 of the error, which is the share that independent samples leave", function(r)
      local most = 0
      for _, shot in ipairs(shots) do
        for i = 2, #counts do
          most = math.max(most, at(r, shot, spared, counts[i]).rmse / at(r, shot, spared, counts[i - 1]).rmse)
        end
      end
      return most < math.sqrt(0.5), ("at most %.2f"):format(most)
    end },
  },
  layout   = { front = { x = "ms_ratio", y = "rmse", region = "whole" }, table = {} },
}
