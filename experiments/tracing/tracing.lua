-- SPDX-License-Identifier: MIT
-- What rays cost, by backend, and truth, by how its samples are shared out.
local experiment = require "strobe.experiment"

local list = experiment.list
local blurred = { "no blur", "McGuire 2012", "hybrid (best)" }
local truths = { "truth, everywhere", "truth, adaptive" }

local function is_truth(arm) return arm == truths[1] or arm == truths[2] end

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

local function adaptive_over_everywhere(r, numbers)
  local error, rays = 0, 0
  for _, shot in ipairs { "room", "cells" } do
    for _, samples in ipairs(numbers) do
      local own, all = at(r, shot, truths[2], { samples = samples }), at(r, shot, truths[1], { samples = samples })
      error, rays = math.max(error, own.rmse / all.rmse), math.max(rays, own.rays / all.rays)
    end
  end
  return error, rays
end

-- Why a failed expectation fails.
local borders = "of truth's tens of millions of rays some pass a triangle within rounding of its border, and fall to either " ..
                "side; the methods' own pictures are the same bit for bit"
local foreseen = "16 samples tell roughly how a tile errs, and not how fast that falls with more of them; samples " ..
                 "everywhere are spread evenly as a whole, those of levels each for themselves"

return experiment {
  title    = "Rays: backends, and truth's samples",
  question = "What does the runtime's own tree save, and what do samples that go where they are needed?",
  note     = "Backends are three ways to trace one set of rays. Both truths see whole pixels, at times drawn in strata; " ..
             "adaptive shares samples out by what the first 16 everywhere differ by, and aims at the error that the " ..
             "number given would have everywhere. Errors are held against truth with 1024 samples everywhere. Times are " ..
             "ratios to McGuire 2012 with ray queries in the same shot; of truth, which is not timed, rays count.",
  size     = { 320, 180 },
  size_params = { "width", "height" },
  shots    = {
    { name = "room", title = "Living room", scene = "living_room", camera = "main", ["scene.pixels"] = 24,
      note = "Three lights that cast shadows: most rays are theirs." },
    { name = "cells", title = "Cells", scene = "behind", ["scene.cell"] = 9, note = "Unlit: no ray but those that look." },
  },
  arms     = {
    { name = "no blur", pipeline = "none", lacks = { "samples" } },
    { name = "McGuire 2012", pipeline = "mcguire2012", lacks = { "samples" } },
    { name = "hybrid (best)", pipeline = "hybrid_traced", lacks = { "samples" } },
    { name = truths[1], pipeline = "ground_truth", set = { samples = 64, pixel = "box", times = "stratified" } },
    { name = truths[2], pipeline = "ground_truth",
      set = { mode = "adaptive", samples = 64, pixel = "box", times = "stratified" } },
  },
  truth    = { pipeline = "ground_truth", set = { samples = 1024, pixel = "box", times = "stratified" } },
  base     = "McGuire 2012",
  rounds   = 21,
  vary     = { experiment.each {
    list { name = "backend", title = "Tracing backend", values = { "query", "pipeline", "bvh" } },
    list { name = "samples", title = "Samples of truth", scale = "log", benign = 64, values = { 32, 64, 128, 256 },
      at = function(value) return { samples = value, backend = "bvh" } end },
  } },
  skip     = function(point) return point.samples and not is_truth(point.arm) end,
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
    { "from 128 samples on adaptive truth errs at most a quarter more than the same number everywhere, for at most three " ..
      "quarters of the rays", known = foreseen, function(r)
      local error, rays = adaptive_over_everywhere(r, { 128, 256 })
      return error <= 1.25 and rays <= 0.75, ("at most %.2f times the error, %.2f of the rays"):format(error, rays)
    end },
    { "found afterwards: so it is at 256 samples, for at most three fifths of the rays", known = foreseen, function(r)
      local error, rays = adaptive_over_everywhere(r, { 256 })
      return error <= 1.25 and rays <= 0.6, ("at most %.2f times the error, %.2f of the rays"):format(error, rays)
    end },
  },
  layout   = { table = { axes = { "backend", "samples" }, cells = { "rmse", "ms_ratio", "rays" } } },
}
