-- SPDX-License-Identifier: MIT
-- Measures the time that parts of the pipeline hybrid_layered cost in a simple scene that does not need these parts.
--   strobe sweep experiments/not_required/not_required.lua -o out/not_required
local experiment = require "strobe.experiment"

local base = "raster layers"

-- Parts that are not needed to blur a panel that slides in front of a wall.
local parts = {
  { "curved paths", { trajectory = "arc" } },
  { "no limit", { limit = "auto" } },
}

local arms = {}
local function add(name, more)
  local set = { limit = 0.5 }
  for key, value in pairs(more) do set[key] = value end
  arms[#arms + 1] = { name = name, pipeline = "hybrid_layered", set = set }
end
add(base, {})
for _, part in ipairs(parts) do add("+ " .. part[1], part[2]) end

return experiment {
  title    = "Parts that are not required",
  question = "How much time does a part of the hybrid cost in a scene that does not need the part?",
  note     = "A panel slides by 40 px in front of a wall, parallel to the picture: no object turns or enters, and " ..
             "no surface is behind two others. Times are ratios to the first arm. The arms are timed in turn in one " ..
             "run. All arms run the same passes (their plans are equal), so differences between their times are noise.",
  size     = { 480, 270 },
  shots    = { { name = "slide", title = "A panel slides", scene = "stability/passage", ["scene.speed"] = 40 } },
  arms     = arms,
  truth    = { pipeline = "ground_truth", set = { samples = 256 } },
  base     = base,
  rounds   = 60, most_rounds = 120, within = 0.004,
  regions  = { "whole" },
  measures = { "rmse", "ms_ratio" },
  expect   = {
    { "no part that the scene does not need increases the time by more than a hundredth", function(r)
      local most, which = 0, ""
      for _, part in ipairs(parts) do
        local ratio = r.at { shot = "slide", arm = "+ " .. part[1] }.ms_ratio
        if ratio > most then most, which = ratio, part[1] end
      end
      return most <= 1.01, ("at most %.3f times the time (%s)"):format(most, which)
    end },
    { "no part that the scene does not need changes the picture", function(r)
      local same = true
      local rmse = r.at { shot = "slide", arm = base }.rmse
      for _, part in ipairs(parts) do same = same and r.at { shot = "slide", arm = "+ " .. part[1] }.rmse == rmse end
      return same, ("RMSE %.5f"):format(rmse)
    end },
  },
  layout   = { table = {} },
}
