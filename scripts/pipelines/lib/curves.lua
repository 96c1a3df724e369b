-- SPDX-License-Identifier: MIT
-- Paths over the exposure that are no straight lines.
local pass          = require "strobe.pass"
local pipeline      = require "strobe.pipeline"
local earlier_curve = require "passes.scene.earlier_curve"
local path_curve    = require "passes.scene.path_curve"
local ranges        = require "scripts.pipelines.lib.ranges"

local curves = {}

function curves.are_asked(p) return p.trajectory() ~= "line" end

-- From poses of earlier frames, which say displacements too?
function curves.are_foretold(p) return curves.are_asked(p) and p.displacement() == "extrapolated" end

-- Refuses a filter that would ignore curves. `setting` names the filter.
function curves.require(p, filter, setting)
  if not curves.are_asked(p) then return end
  if pass.reads(filter, "after_velocity") and ranges.are_split(p) then
    error(("trajectory = %s: range = split has straight paths; it needs range = whole"):format(p.trajectory()), 0)
  end
  if not pass.reads(filter, "curve") then
    error(("trajectory = %s: %s follows straight paths only; it needs trajectory = line"):format(p.trajectory(), setting), 0)
  end
end

-- How many poses curves go through, beside those at the ends of the exposure or that of the capture.
local function poses_of(p)
  if not curves.are_foretold(p) then return p.trajectory() == "arc" and 5 or 3 end
  if p.trajectory() == "arc" then
    error("trajectory = arc: arcs need poses inside of the exposure, displacement = window; poses of earlier frames make " ..
          "a quadratic", 0)
  end
  return 2
end

local function curve_of(p, name, layer)
  local images = {
    depth = layer.depth, id = layer.id, velocity = layer.velocity, hit = layer.hit, normal = layer.normal,
    as = name .. "_curve",
  }
  if curves.are_foretold(p) then return earlier_curve(images) end
  return path_curve(images)
end

-- Adds `curve`, `bend` and `bent` to each of the layers, { name, layer (plain tables: depth, id, velocity, perhaps hit,
-- normal) }: from poses inside of the exposure, or from poses of earlier frames, which give a velocity too. The loop over
-- the poses is named after the first layer, or `inside`, or `loop_name`. Does nothing where paths are lines.
function curves.add(p, layers, loop_name)
  if not curves.are_asked(p) then return end
  local foretold = curves.are_foretold(p)
  local images = { "curve", "bend", "bent", foretold and "velocity" or nil }
  local found = pipeline.loop {
    name = loop_name or (foretold and layers[1][1] .. "_earlier" or "inside"),
    count = 1, times = foretold and "frames" or "even", slices = poses_of(p),
    body = function()
      local result = {}
      for _, given in ipairs(layers) do
        local of = curve_of(p, given[1], given[2])
        for _, image in ipairs(images) do result[given[1] .. "_" .. image] = of[image] end
      end
      return result
    end,
  }
  for _, given in ipairs(layers) do
    local name, layer = given[1], given[2]
    for _, image in ipairs(images) do layer[image] = found[name .. "_" .. image] end
  end
end

return curves
