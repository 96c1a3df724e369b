-- SPDX-License-Identifier: MIT
-- Measures how error and time depend on the largest number of hits that a ray may test on its way through the foreground. This
-- number is the parameter `max_layers`, called the cap here.
--   strobe sweep experiments/hits_tried/hits_tried.lua -o out/hits_tried
local experiment = require "strobe.experiment"

-- Reasons why some of the expectations below failed; reports print these reasons.
local target = "the hit that ends the ray counts as tested too, so four walls need a cap of 4, and twigs and leaves up to 16"

local list = experiment.list
local caps = { 1, 2, 3, 4, 8, 16 }

local function at(r, shot, arm, cap) return r.at { shot = shot, arm = arm, cap = cap, region = "inner" } end

local function hits(name, set)
  set.advance = "origin_kept"
  return { name = name, pipeline = "hybrid_layered", set = set }
end

return experiment {
  title    = "Hits that a ray may test",
  question = "How many hits must a ray be allowed to test?",
  note     = "All arms are hybrid_layered. The ray of the arm \"one ray\" ignores the instance in front. The rays of the " ..
             "other arms advance from hit to hit until a hit has another instance (or luminance), or until the " ..
             "number of tested hits reaches the cap. A ray that reaches the cap reveals nothing or, as in the " ..
             "paper, the last hit. Times are ratios to the arm \"one ray\".",
  size     = { 320, 180 },
  size_params = { "width", "height" },
  shots    = {
    { name = "vase", title = "Living room", scene = "living_room", camera = "main", ["scene.pixels"] = 24,
      note = "A ray through the hollow vase hits up to three further walls of the vase before the cushion." },
    { name = "cells_9", title = "Cells of 9 px", scene = "behind", ["scene.cell"] = 9,
      note = "A closed box of one colour slides past cells of 9 px." },
  },
  arms     = {
    { name = "one ray", pipeline = "hybrid_layered", lacks = { "max_layers" } },
    hits("instance, nothing at the cap", {}),
    hits("instance, last hit at the cap", { on_cap = "last_hit" }),
    hits("luminance, last hit at the cap", { termination = "luminance", on_cap = "last_hit" }),
  },
  truth    = { pipeline = "ground_truth", set = { samples = 256, times = "stratified" } },
  base     = "one ray",
  rounds   = 7,
  vary     = { list { name = "cap", title = "Hits tested", scale = "log", benign = 8, region = "inner", values = caps,
    at = function(value) return { max_layers = value } end } },
  skip     = function(point) return point.arm == "one ray" and point.cap ~= 8 end,
  regions  = { "whole", "inner" },
  measures = { "rmse", "flip", "ms_ratio", "rays" },
  expect   = {
    { "for the vase, which has four walls, a cap of 3 hits suffices: its error is at most 1.01 times the error with 16 hits",
      shot = "vase", known = target, function(r)
        local three = at(r, "vase", "instance, nothing at the cap", 3).rmse
        local many = at(r, "vase", "instance, nothing at the cap", 16).rmse
        return three <= 1.01 * many, ("RMSE %.4f and %.4f"):format(three, many)
      end },
    { "found afterwards: in the living room the default cap of 8 hits is too low: it has at least twice the error of 16 hits",
      shot = "vase", function(r)
        local eight = at(r, "vase", "instance, nothing at the cap", 8).rmse
        local many = at(r, "vase", "instance, nothing at the cap", 16).rmse
        return eight >= 2 * many, ("RMSE %.4f and %.4f"):format(eight, many)
      end },
    { "in the living room a cap of 1 hit reveals too little: it has at least 3 times the error of 16 hits", shot = "vase",
      function(r)
      local one = at(r, "vase", "instance, nothing at the cap", 1).rmse
      local many = at(r, "vase", "instance, nothing at the cap", 16).rmse
      return one >= 3 * many, ("RMSE %.4f and %.4f"):format(one, many)
    end },
    { "at a cap of 2 hits, which is too low, revealing nothing has a smaller error than revealing the last hit", shot = "vase",
      function(r)
      local nothing = at(r, "vase", "instance, nothing at the cap", 2).rmse
      local last = at(r, "vase", "instance, last hit at the cap", 2).rmse
      return nothing < last, ("RMSE %.4f and %.4f"):format(nothing, last)
    end },
    { "with termination by luminance the errors of all caps are within a tenth in the living room, because rays end at the " ..
      "vase's walls", shot = "vase", function(r)
        local least, most = math.huge, 0
        for _, cap in ipairs(caps) do
          local error = at(r, "vase", "luminance, last hit at the cap", cap).rmse
          least, most = math.min(least, error), math.max(most, error)
        end
        return most <= 1.1 * least, ("RMSE %.4f to %.4f"):format(least, most)
      end },
    { "an advance from hit to hit with a cap of 16 hits finds the same surfaces as the arm \"one ray\": the errors differ " ..
      "by at most a hundredth", function(r)
      local most = 0
      for _, shot in ipairs { "vase", "cells_9" } do
        local one = at(r, shot, "one ray", 8).rmse
        most = math.max(most, math.abs(at(r, shot, "instance, nothing at the cap", 16).rmse / one - 1))
      end
      return most <= 0.01, ("errors differ by at most %.2f %%"):format(100 * most)
    end },
  },
  layout   = { front = { x = "ms_ratio", y = "rmse", region = "inner" },
               table = { axes = { "cap" }, cells = { "rmse", "ms_ratio", "rays" } } },
}
