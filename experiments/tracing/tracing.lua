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

return experiment {
  title    = "Rays: backends, and truth's samples",
  question = "What does the runtime's own tree save, and what do samples that go where they are needed?",
  note     = "Backends are three ways to trace one set of rays. Both truths see whole pixels, at times drawn in strata; " ..
             "adaptive shares samples out by what the first 16 everywhere differ by, and aims at the error that the " ..
             "number given would have everywhere. Errors are held against truth with 1024 samples everywhere. Times are " ..
             "ratios to McGuire 2012 with ray queries in the same shot.",
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
    { name = "hybrid (best)", pipeline = "hybrid", lacks = { "samples" } },
    { name = truths[1], pipeline = "ground_truth", set = { samples = 64, pixel = "box", times = "stratified" } },
    { name = truths[2], pipeline = "ground_truth",
      set = { mode = "adaptive", samples = 64, pixel = "box", times = "stratified" } },
  },
  truth    = { pipeline = "ground_truth", set = { samples = 1024, pixel = "box", times = "stratified" } },
  base     = "McGuire 2012",
  rounds   = 5,
  vary     = { experiment.each {
    list { name = "backend", title = "Tracing backend", values = { "query", "pipeline", "bvh" } },
    list { name = "samples", title = "Samples of truth", scale = "log", benign = 64, values = { 32, 64, 128, 256 },
      at = function(value) return { samples = value, backend = "bvh" } end },
  } },
  skip     = function(point) return point.samples and not is_truth(point.arm) end,
  regions  = { "whole", "inner" },
  measures = { "rmse", "ms_ratio", "rays" },
  expect   = {
    { "every backend gives one picture: the same error to the last digit kept", function(r)
      local different = {}
      for _, shot in ipairs { "room", "cells" } do
        for _, arms in ipairs { blurred, truths } do
          for _, arm in ipairs(arms) do
            local first = at(r, shot, arm, { backend = "query" }).rmse
            for _, backend in ipairs { "pipeline", "bvh" } do
              local same = at(r, shot, arm, { backend = backend }).rmse == first
              if not same then different[#different + 1] = arm .. ", " .. backend end
            end
          end
        end
      end
      return #different == 0, #different == 0 and "all alike" or table.concat(different, "; ")
    end },
    { "the own tree takes at most two thirds of the time of truth by ray queries", function(r)
      local room, cells = share(r, "room", truths[1]), share(r, "cells", truths[1])
      return room <= 2 / 3 and cells <= 2 / 3, ("%.2f in the room, %.2f before cells"):format(room, cells)
    end },
    { "no method takes longer by the own tree", function(r)
      local most = 0
      for _, shot in ipairs { "room", "cells" } do
        for _, arm in ipairs(blurred) do most = math.max(most, share(r, shot, arm)) end
      end
      return most <= 1, ("at most %.2f"):format(most)
    end },
    { "from 128 samples on adaptive truth errs at most a quarter more than the same number everywhere, for at most three " ..
      "quarters of the time", function(r)
      local error, time = 0, 0
      for _, shot in ipairs { "room", "cells" } do
        for _, samples in ipairs { 128, 256 } do
          local own, all = at(r, shot, truths[2], { samples = samples }), at(r, shot, truths[1], { samples = samples })
          error, time = math.max(error, own.rmse / all.rmse), math.max(time, own.ms_ratio / all.ms_ratio)
        end
      end
      return error <= 1.25 and time <= 0.75, ("at most %.2f times the error and %.2f of the time"):format(error, time)
    end },
  },
  layout   = { table = { axes = { "backend", "samples" }, cells = { "rmse", "ms_ratio", "rays" } } },
}
