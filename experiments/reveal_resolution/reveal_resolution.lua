-- SPDX-License-Identifier: MIT
-- A ray per pixel or per square of four, and how many hits a ray may try.
local experiment = require "strobe.experiment"

-- Why a failed expectation fails.
local patterns = "stripes, cushions and shading change from pixel to pixel, and silhouettes among them move by up to one"
local borders = "every square across a border of cells has the colour of one of them: at 9 px that is as much as at 5"
local target = "the hit that ends the ray is one that was tried: four walls take a cap of 4, twigs and leaves up to 16"

local list = experiment.list
local caps = { 1, 2, 3, 4, 8, 16 }
local cards = { "cells_3", "cells_5", "cells_9" }

local function at(r, shot, arm, wanted)
  local key = { shot = shot, arm = arm, region = "inner" }
  for axis, value in pairs(wanted) do key[axis] = value end
  return r.at(key)
end

local function half_over_full(r, shot)
  return at(r, shot, "one ray", { resolution = "half" }).rmse / at(r, shot, "one ray", { resolution = "full" }).rmse
end

local function hits(name, set)
  set.preset, set.advance = "captured", "origin_kept"
  return { name = name, pipeline = "hybrid", set = set, lacks = { "reveal_resolution" } }
end

-- Odd, so that cells do not coincide with the squares of 2 x 2 pixels that share a ray: even ones lose nothing.
local function fine(cell)
  return { name = "cells_" .. cell, title = ("Cells of %d px"):format(cell), scene = "behind", ["scene.cell"] = cell,
           note = "A closed box of one colour slides past cells of so many pixels." }
end

return experiment {
  title    = "Resolution and depth of reveal",
  question = "What does a ray for every four pixels save and cost, and how many hits must a ray be allowed to try?",
  note     = "All arms are the hybrid with preset captured. \"one ray\" ignores the instance in front and needs no cap; the " ..
             "others go from hit to hit until one is another instance, or another luminance, and at the cap reveal " ..
             "nothing, or the last hit as the paper has it. Times are ratios to one ray per pixel.",
  size     = { 320, 180 },
  size_params = { "width", "height" },
  shots    = {
    { name = "vase", title = "Living room", scene = "living_room", camera = "main", ["scene.pixels"] = 24,
      note = "A ray through the hollow vase meets up to three of its own walls before the cushion." },
    fine(3), fine(5), fine(9),
  },
  arms     = {
    { name = "one ray", pipeline = "hybrid", set = { preset = "captured" }, lacks = { "max_layers" } },
    hits("instance, nothing at the cap", {}),
    hits("instance, last hit at the cap", { on_cap = "last_hit" }),
    hits("luminance, last hit at the cap", { termination = "luminance", on_cap = "last_hit" }),
  },
  truth    = { pipeline = "ground_truth", set = { samples = 256, times = "stratified" } },
  base     = "one ray",
  rounds   = 7,
  vary     = { experiment.each {
    list { name = "resolution", title = "Rays per masked pixel", values = { "full", "half" },
      at = function(value) return { reveal_resolution = value } end },
    list { name = "cap", title = "Hits tried", scale = "log", benign = 8, region = "inner", values = caps,
      at = function(value) return { max_layers = value } end },
  } },
  skip     = function(point)
    if point.resolution then return point.arm ~= "one ray" end
    return point.shot ~= "vase" and point.shot ~= "cells_9" or point.arm == "one ray"
  end,
  regions  = { "whole", "inner" },
  measures = { "rmse", "flip", "ms_ratio", "rays" },
  expect   = {
    { "in the living room half resolution errs at most a half more inside the silhouette", shot = "vase",
      known = patterns, function(r)
      local ratio = half_over_full(r, "vase")
      return ratio <= 1.5, ("%.2f times"):format(ratio)
    end },
    { "the finer the background the more half resolution costs, and twice the error at cells of 3 px", known = borders,
      function(r)
      local ratios = {}
      for i, shot in ipairs(cards) do ratios[i] = half_over_full(r, shot) end
      return ratios[1] >= ratios[2] and ratios[2] >= ratios[3] and ratios[1] >= 2,
        ("%.2f times at 3 px, %.2f at 5 px, %.2f at 9 px"):format(table.unpack(ratios))
    end },
    { "half resolution is not faster by a tenth of the frame, since few pixels have a ray", shot = "vase", function(r)
      local full, half = at(r, "vase", "one ray", { resolution = "full" }).ms_ratio,
                         at(r, "vase", "one ray", { resolution = "half" }).ms_ratio
      return half > 0.9 * full, ("%.3f of the time of one ray per pixel"):format(half / full)
    end },
    { "the vase has four walls: a cap of 3 hits loses nothing, errors with 3 and 16 are within a hundredth", shot = "vase",
      known = target, function(r)
        local three = at(r, "vase", "instance, nothing at the cap", { cap = 3 }).rmse
        local many = at(r, "vase", "instance, nothing at the cap", { cap = 16 }).rmse
        return three <= 1.01 * many, ("RMSE %.4f and %.4f"):format(three, many)
      end },
    { "found afterwards: the living room needs more than the default cap of 8: it errs at least twice as much as 16",
      shot = "vase", function(r)
        local eight = at(r, "vase", "instance, nothing at the cap", { cap = 8 }).rmse
        local many = at(r, "vase", "instance, nothing at the cap", { cap = 16 }).rmse
        return eight >= 2 * many, ("RMSE %.4f and %.4f"):format(eight, many)
      end },
    { "a cap of 1 hit loses most of it: at least 3 times the error of 16, living room", shot = "vase", function(r)
      local one = at(r, "vase", "instance, nothing at the cap", { cap = 1 }).rmse
      local many = at(r, "vase", "instance, nothing at the cap", { cap = 16 }).rmse
      return one >= 3 * many, ("RMSE %.4f and %.4f"):format(one, many)
    end },
    { "with a cap that is too low nothing is better than the last hit", shot = "vase", function(r)
      local nothing = at(r, "vase", "instance, nothing at the cap", { cap = 2 }).rmse
      local last = at(r, "vase", "instance, last hit at the cap", { cap = 2 }).rmse
      return nothing < last, ("RMSE %.4f and %.4f"):format(nothing, last)
    end },
    { "under luminance the cap hardly matters in the living room, since rays end at the vase's own walls: within a tenth",
      shot = "vase", function(r)
        local least, most = math.huge, 0
        for _, cap in ipairs(caps) do
          local error = at(r, "vase", "luminance, last hit at the cap", { cap = cap }).rmse
          least, most = math.min(least, error), math.max(most, error)
        end
        return most <= 1.1 * least, ("RMSE %.4f to %.4f"):format(least, most)
      end },
    { "going from hit to hit with a cap of 16 finds what one ray finds: errors within a hundredth", function(r)
      local most = 0
      for _, shot in ipairs { "vase", "cells_9" } do
        local one = at(r, shot, "one ray", { resolution = "full" }).rmse
        most = math.max(most, math.abs(at(r, shot, "instance, nothing at the cap", { cap = 16 }).rmse / one - 1))
      end
      return most <= 0.01, ("at most %.2f %% apart"):format(100 * most)
    end },
  },
  layout   = { front = { x = "ms_ratio", y = "rmse", region = "inner" },
               table = { axes = { "resolution", "cap" }, cells = { "rmse", "ms_ratio", "rays" } } },
}
