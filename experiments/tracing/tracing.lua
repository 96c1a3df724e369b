-- SPDX-License-Identifier: MIT
-- The cost of rays, by backend.
local experiment = require "strobe.experiment"

local list = experiment.list
local blurred = { "no blur", "McGuire 2012", "hybrid (best)" }
local truths = { "truth" }

local function at(r, shot, arm, wanted)
  local key = { shot = shot, arm = arm }
  for axis, value in pairs(wanted) do key[axis] = value end
  return r.at(key)
end

-- Of the time of ray queries.
local function share(r, shot, arm)
  return at(r, shot, arm, { backend = "bvh" }).ms_ratio / at(r, shot, arm, { backend = "query" }).ms_ratio
end

-- Largest relative difference of the errors by backend.
local function most_apart(r, groups)
  local most = 0
  for _, shot in ipairs { "room", "cells" } do
    for _, arms in ipairs(groups) do
      for _, arm in ipairs(arms) do
        local first = at(r, shot, arm, { backend = "query" }).rmse
        for _, backend in ipairs { "pipeline", "bvh" } do
          most = math.max(most, math.abs(at(r, shot, arm, { backend = backend }).rmse / first - 1))
        end
      end
    end
  end
  return most
end

-- Why an expectation fails.
local borders = "of truth's tens of millions of rays some pass a triangle within rounding of its border, and fall to either " ..
                "side; the methods' own pictures are the same bit for bit"

return experiment {
  title    = "Rays: backends",
  question = "What does the runtime's own tree save?",
  note     = "Backends are three ways to trace one set of rays. Truth sees whole pixels, at times drawn in strata. Errors " ..
             "are held against truth with 1024 samples. Times are ratios to McGuire 2012 with ray queries in the same shot; " ..
             "of truth, which is not timed, rays count.",
  size     = { 320, 180 },
  size_params = { "width", "height" },
  shots    = {
    { name = "room", title = "Living room", scene = "living_room", camera = "main", ["scene.pixels"] = 24,
      note = "Three lights that cast shadows: most rays are theirs." },
    { name = "cells", title = "Cells", scene = "behind", ["scene.cell"] = 9, note = "Unlit: no ray but those that look." },
  },
  arms     = {
    { name = "no blur", pipeline = "none" },
    { name = "McGuire 2012", pipeline = "mcguire2012" },
    { name = "hybrid (best)", pipeline = "hybrid_traced" },
    { name = truths[1], pipeline = "ground_truth", set = { samples = 64, pixel = "box", times = "stratified" } },
  },
  truth    = { pipeline = "ground_truth", set = { samples = 1024, pixel = "box", times = "stratified" } },
  base     = "McGuire 2012",
  rounds   = 21,
  vary     = { list { name = "backend", title = "Tracing backend", values = { "query", "pipeline", "bvh" } } },
  regions  = { "whole", "inner" },
  measures = { "rmse", "ms_ratio", "rays" },
  expect   = {
    { "every backend gives one picture: the same error to the last digit kept", known = borders, function(r)
      local most = most_apart(r, { blurred, truths })
      return most == 0, ("relative difference of up to %.1e"):format(most)
    end },
    { "found afterwards: errors of methods agree to a part in 50,000, those of truths to one in 500", function(r)
      local methods, means = most_apart(r, { blurred }), most_apart(r, { truths })
      return methods <= 2e-5 and means <= 2e-3, ("%.1e and %.1e"):format(methods, means)
    end },
    { "where rays are most of a frame no method takes longer by the own tree", shot = "room", function(r)
      local most = 0
      for _, arm in ipairs(blurred) do most = math.max(most, share(r, "room", arm)) end
      return most <= 1, ("%.2f of the time by ray queries, at most"):format(most)
    end },
  },
  layout   = { table = { axes = { "backend" }, cells = { "rmse", "ms_ratio", "rays" } } },
}
