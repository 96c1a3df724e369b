-- SPDX-License-Identifier: MIT
-- Measures every method of the repository in four kinds of motion, with the measures that papers use: milliseconds per frame at
-- 1280x720 and 1920x1080, PSNR, SSIM and FLIP.
--   strobe sweep experiments/methods/methods.lua -o out/methods
local experiment = require "strobe.experiment"

local base, dial = "McGuire 2012", "adaptive, quality %g"

local arms = {
  { name = "no blur", pipeline = "none" },
  { name = base, pipeline = "mcguire2012" },
  { name = "Guertin 2014", pipeline = "guertin2014" },
  { name = "Jimenez 2014", pipeline = "jimenez2014" },
  { name = "UE4-style", pipeline = "ue4" },
  { name = "UE5-style", pipeline = "ue5" },
  { name = "Bevy", pipeline = "bevy" },
  { name = "HDRP", pipeline = "hdrp" },
  { name = "EEVEE, 4 steps", pipeline = "eevee", set = { steps = 4 } },
  { name = "Lee 2024", pipeline = "lee2024" },
  { name = "Oberberger 2022", pipeline = "oberberger2022" },
  { name = "hybrid", pipeline = "hybrid" },
  { name = "hybrid_layered", pipeline = "hybrid_layered" },
  { name = "accumulation", pipeline = "accumulation" },
}
for _, quality in ipairs { 0.1, 0.4, 0.7 } do
  arms[#arms + 1] = { name = dial:format(quality), pipeline = "adaptive", set = { quality = quality } }
end
arms[#arms + 1] = { name = "truth, 1024 samples", pipeline = "ground_truth", role = "floor", timed = true,
                    set = { mark_regions = false } }

local shots = {
  { name = "mover", title = "One mover: a vase slides", scene = "living_room", camera = "main" },
  { name = "turning", title = "Turning: a wheel rolls", scene = "objects/spoked_wheel" },
  { name = "entering", title = "A ball enters, a crate leaves", scene = "objects/enters" },
  { name = "camera", title = "The camera moves past objects at many depths", scene = "objects/tracking_parallax" },
}

-- Sizes of the pictures. The displacement over the exposure is a twentieth of the width.
local measured = "1280x720"  -- errors are read at this size
local moving = "camera"      -- the shot that is drawn at this size only, because ground truth takes minutes per frame
local sizes = { ["1280x720"] = { 1280, 720 }, ["1920x1080"] = { 1920, 1080 } }

local function error_of(r, shot_name, arm) return r.at { shot = shot_name, arm = arm, picture = measured }.flip end

return experiment {
  title = "Methods",
  question = "How large are time and error of each method, in the units that papers use?",
  note = "The displacement over the exposure is a twentieth of the picture's width. Every method with the parameter samples " ..
         "has 16 samples; ground truth has 1024. A time is the median over all frames except the first; the methods are " ..
         "drawn in turns. FLIP is computed at 67 pixels per degree, PSNR and SSIM on clamped, sRGB-encoded values, all over " ..
         "the whole picture. The errors of ground truth are limited by the reference, which has 128 samples.",
  size = sizes[measured],
  shots = shots,
  arms = arms,
  base = base,
  rounds = 2,
  truth = { pipeline = "ground_truth", set = { samples = 128, times = "stratified", mark_regions = false } },
  vary = { experiment.list {
    name = "picture", title = "Size of the picture", values = { "1280x720", "1920x1080" }, region = "whole",
    at = function(name)
      local width, height = table.unpack(sizes[name])
      local set = { size = sizes[name], ["scene.width"] = width, ["scene.height"] = height, ["scene.pixels"] = width / 20 }
      if name ~= measured then set.truth = { samples = 8 } end  -- only times are read at the other size
      return set
    end,
  } },
  skip = function(point) return point.shot == moving and point.picture ~= measured end,
  regions = { "whole" },
  measures = { "rmse", "psnr", "ssim", "flip", "ms", "ms_ratio", "rays" },
  expect = {
    { "in every shot, adaptive has the smallest FLIP of all methods that take at most its time", function(r)
      local worse = {}
      for _, one in ipairs(shots) do
        local own = r.at { shot = one.name, arm = dial:format(0.4), picture = measured }
        for _, arm in ipairs(arms) do
          local other = r.at { shot = one.name, arm = arm.name, picture = measured }
          if arm.pipeline ~= "adaptive" and arm.role ~= "floor" and other.ms <= own.ms and other.flip < own.flip then
            worse[#worse + 1] = one.title .. ": " .. arm.name
          end
        end
      end
      return #worse == 0, table.concat(worse, "; ")
    end, known = "in these scenes of few triangles, drawing the scene at 16 times takes less time than the rays of adaptive" },
    { "with a moving camera, every post-process has at least five times the FLIP of adaptive", function(r)
      local least, own = math.huge, error_of(r, "camera", dial:format(0.4))
      for _, arm in ipairs { base, "Guertin 2014", "Jimenez 2014", "UE4-style", "Bevy", "HDRP" } do
        least = math.min(least, error_of(r, "camera", arm) / own)
      end
      return least >= 5, ("%.1f times"):format(least)
    end },
    { "in every shot with a static camera, the time of every method grows from 1280x720 to 1920x1080 by 1.8 to 2.7 times; " ..
      "the number of pixels grows by 2.25 times",
      function(r)
        local least, most = math.huge, 0
        for _, one in ipairs(shots) do
          for _, arm in ipairs(one.name == moving and {} or arms) do
            local small = r.at { shot = one.name, arm = arm.name, picture = measured }
            local large = r.at { shot = one.name, arm = arm.name, picture = "1920x1080" }
            least, most = math.min(least, large.ms / small.ms), math.max(most, large.ms / small.ms)
          end
        end
        return least >= 1.8 and most <= 2.7, ("%.2f to %.2f"):format(least, most)
      end, known = "times of the short frames vary by a fifth between rounds" },
  },
  layout = { table = {} },
}
