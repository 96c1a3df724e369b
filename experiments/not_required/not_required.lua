-- SPDX-License-Identifier: MIT
-- What a scene does not need, and what asking for it costs.
--   strobe sweep experiments/not_required/not_required.lua -o out/not_required
local experiment = require "strobe.experiment"

local base, own_times = "layers of the capture", "+ rays where no layer explains"

-- Parts of the hybrid that a panel which slides before a wall does not need.
local parts = {
  { "curved paths", { trajectory = "arc" } },
  { "no limit", { limit = "auto" } },
}

local arms = {}
local function add(name, more, pipeline)
  local set = { limit = 0.5 }
  for key, value in pairs(more) do set[key] = value end
  arms[#arms + 1] = { name = name, pipeline = pipeline or "hybrid_layered", set = set }
end
add(base, {})
for _, part in ipairs(parts) do add("+ " .. part[1], part[2]) end
add(own_times, {}, "hybrid_traced")

return experiment {
  title    = "What is not required",
  question = "What does a part of the hybrid cost that the scene does not need?",
  note     = "A panel slides by 40 px before a wall, parallel to the picture: nothing turns, nothing comes in, nothing is " ..
             "behind two things. Times are ratios to the layers of the capture alone, alternately in one run. Plans are " ..
             "the same but for the last arm: what differs between the others is chance.",
  size     = { 480, 270 },
  shots    = { { name = "slide", title = "A panel slides", scene = "stability/passage", ["scene.speed"] = 40 } },
  arms     = arms,
  truth    = { pipeline = "ground_truth", set = { samples = 256 } },
  base     = base,
  rounds   = 60, most_rounds = 120, within = 0.004,
  regions  = { "whole" },
  measures = { "rmse", "ms_ratio" },
  expect   = {
    { "no part costs more than a hundredth", function(r)
      local most, which = 0, ""
      for _, part in ipairs(parts) do
        local ratio = r.at { shot = "slide", arm = "+ " .. part[1] }.ms_ratio
        if ratio > most then most, which = ratio, part[1] end
      end
      return most <= 1.01, ("at most %.3f times the time (%s)"):format(most, which)
    end },
    { "and none changes the picture", function(r)
      local same = true
      local rmse = r.at { shot = "slide", arm = base }.rmse
      for _, part in ipairs(parts) do same = same and r.at { shot = "slide", arm = "+ " .. part[1] }.rmse == rmse end
      return same, ("RMSE %.5f"):format(rmse)
    end },
    { "found afterwards: rays at sample times, between texels of different colour too, cost at most a third more", function(r)
        local ratio = r.at { shot = "slide", arm = own_times }.ms_ratio
        return ratio <= 4 / 3, ("%.3f times the time"):format(ratio)
      end },
  },
  layout   = { table = {} },
}
