-- SPDX-License-Identifier: MIT
-- Compares the error that the pipeline `adaptive` estimates for each pixel (its output `error`) with the error against truth.
--   strobe sweep experiments/error_estimate/error_estimate.lua -o out/error_estimate
local experiment = require "strobe.experiment"
local all_shots  = require "scripts.scenes.lib.all_shots"

local shots, arms = all_shots.list(), {}
for _, quality in ipairs { 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7 } do
  arms[#arms + 1] = { name = ("quality %g"):format(quality), pipeline = "adaptive", set = { quality = quality } }
end
local default = "quality 0.4"

local region = "whole"

-- Returns the ratio of the mean estimated error to the mean error, for an arm in a shot; nil if the error is 0.
local function ratio(r, arm, shot)
  local at = r.at { arm = arm, shot = shot.name, region = region }
  return at.error_mean > 1e-6 and at.error_estimate / at.error_mean or nil
end

return experiment {
  title    = "Estimated error of adaptive",
  question = "The pipeline adaptive estimates the error of each pixel. Does the estimate rank the pixels of a picture by " ..
             "their error, and does its mean agree with the mean error?",
  note     = "The shots are all scenes of the repository except the exhibits. The chart is a reliability plot: each mark is " ..
             "a picture, and the estimate is right on the line y = x. The estimate is a standard deviation, and the error " ..
             "of one pixel is a single draw. So even a perfect estimate ranks the moving pixels imperfectly: for errors " ..
             "drawn from the estimated deviations of the default quality, the mean rank correlation over these pixels is " ..
             "0.53 (found afterwards).",
  size     = { 160, 90 },
  shots    = shots,
  arms     = arms,
  truth    = { pipeline = "ground_truth", set = { samples = 512, mark_regions = false } },
  regions  = { region },
  measures = { "error_mean", "error_estimate", "estimate_rank" },
  expect   = {
    { "at the default quality, the mean over all shots of the rank correlation is at least 0.8", function(r)
      local mean = r.at { arm = default, region = region }.estimate_rank
      return mean >= 0.8, ("%.2f"):format(mean)
    end, known = "the error of a pixel is a single draw, which no estimate of its deviation predicts" },
    { "at the default quality, the mean estimate is within a factor of 1.5 of the mean error in at least 80 % of the shots",
      function(r)
        local all, good, others = 0, 0, {}
        for _, shot in ipairs(shots) do
          local at = ratio(r, default, shot)
          if at then all = all + 1 end
          if at and at <= 1.5 and at >= 1 / 1.5 then good = good + 1
          elseif at then others[#others + 1] = ("%s %.2f"):format(shot.title, at) end
        end
        return good >= 0.8 * all, ("%d of %d; outside: %s"):format(good, all, table.concat(others, ", "))
      end, known = "the reason is not measured: in six of these shots the estimate is too large, in one it is too small" },
    { "in no shot and at no quality is the mean estimate below a third of the mean error", function(r)
      local least, where = math.huge, ""
      for _, shot in ipairs(shots) do
        for _, arm in ipairs(arms) do
          local at = ratio(r, arm.name, shot)
          if at and at < least then least, where = at, shot.title .. ", " .. arm.name end
        end
      end
      return least >= 1 / 3, ("%.2f: %s"):format(least, where)
    end },
  },
  layout = {
    front = { title = "Reliability", x = "error_estimate", y = "error_mean", region = region, together = true },
    table = { title = "All pictures" },
  },
}
