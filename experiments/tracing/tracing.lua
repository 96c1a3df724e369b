-- SPDX-License-Identifier: MIT
-- Compares the ray tracing backends (ray queries, ray tracing pipelines, the runtime's own tree) by frame times and errors.
local experiment = require "strobe.experiment"

local list = experiment.list
local blurred = { "no blur", "McGuire 2012", "adaptive" }
local truths = { "truth" }

local function at(r, shot, arm, wanted)
  local key = { shot = shot, arm = arm }
  for axis, value in pairs(wanted) do key[axis] = value end
  return r.at(key)
end

-- Returns the frame time with the runtime's own tree, divided by the frame time with ray queries.
local function share(r, shot, arm)
  return at(r, shot, arm, { backend = "bvh" }).ms_ratio / at(r, shot, arm, { backend = "query" }).ms_ratio
end

-- Returns the largest relative difference between the errors of an arm with ray queries and with another backend. `groups`:
-- lists of arms.
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

-- Reasons why some of the expectations below failed; reports print these reasons.
local borders = "some of truth's tens of millions of rays pass so close to the border of a triangle that rounding decides " ..
                "the hit, and backends round differently. The pictures of methods are equal bit for bit"

return experiment {
  title    = "Rays: backends",
  question = "How much time does the runtime's own tree (bvh) save?",
  note     = "The three backends trace the same rays. Samples of truth cover whole pixels, at stratified times. Errors are " ..
             "against truth with 1024 samples. Times are ratios to McGuire 2012 with ray queries in the same shot. Truth is " ..
             "not timed; its rays are counted.",
  size     = { 320, 180 },
  size_params = { "width", "height" },
  shots    = {
    { name = "room", title = "Living room", scene = "living_room", camera = "main", ["scene.pixels"] = 24,
      note = "Three lights cast shadows: most rays are shadow rays." },
    { name = "cells", title = "Cells", scene = "behind", ["scene.cell"] = 9, note = "Unlit: no shadow rays." },
  },
  arms     = {
    { name = "no blur", pipeline = "none" },
    { name = "McGuire 2012", pipeline = "mcguire2012" },
    { name = "adaptive", pipeline = "adaptive" },
    { name = truths[1], pipeline = "ground_truth", set = { samples = 64, pixel = "box", times = "stratified" } },
  },
  truth    = { pipeline = "ground_truth", set = { samples = 1024, pixel = "box", times = "stratified" } },
  base     = "McGuire 2012",
  rounds   = 21,
  vary     = { list { name = "backend", title = "Tracing backend", values = { "query", "pipeline", "bvh" } } },
  regions  = { "whole", "inner" },
  measures = { "rmse", "ms_ratio", "rays" },
  expect   = {
    { "all backends give the same picture: errors are equal to the last digit", known = borders, function(r)
      local most = most_apart(r, { blurred, truths })
      return most == 0, ("relative difference of up to %.1e"):format(most)
    end },
    { "found afterwards: between backends, the errors of methods differ by at most a fifty-thousandth and the errors of " ..
      "truth by at most a five-hundredth", function(r)
      local methods, means = most_apart(r, { blurred }), most_apart(r, { truths })
      return methods <= 2e-5 and means <= 2e-3, ("%.1e and %.1e"):format(methods, means)
    end },
    { "where rays take most of a frame, no method takes longer with the runtime's own tree than with ray queries",
      shot = "room", function(r)
      local most = 0
      for _, arm in ipairs(blurred) do most = math.max(most, share(r, "room", arm)) end
      return most <= 1, ("at most %.2f of the time with ray queries"):format(most)
    end },
  },
  layout   = { table = { axes = { "backend" }, cells = { "rmse", "ms_ratio", "rays" } } },
}
