-- SPDX-License-Identifier: MIT
-- Paths over the exposure that are no straight lines.
local pass       = require "strobe.pass"
local pipeline   = require "strobe.pipeline"
local path_curve = require "passes.scene.path_curve"
local depths     = require "scripts.pipelines.lib.depths"
local ranges     = require "scripts.pipelines.lib.ranges"
local scene      = require "scripts.pipelines.lib.scene"

local curves = {}

function curves.are_asked(p) return p.trajectory() ~= "line" end

-- Stops where a filter would take no notice of them, or where displacements are not those of the exposure.
function curves.require(p, filter, setting)
  if not curves.are_asked(p) then return end
  if p.displacement() ~= "window" then
    error(("trajectory = %s: curves are those of true poses, displacement = window"):format(p.trajectory()), 0)
  end
  if pass.reads(filter, "after_velocity") and ranges.are_split(p) then
    error(("trajectory = %s: range = split has straight paths; it needs range = whole"):format(p.trajectory()), 0)
  end
  if not pass.reads(filter, "curve") then
    error(("trajectory = %s: %s knows straight paths alone; it needs trajectory = line"):format(p.trajectory(), setting), 0)
  end
end

-- Gives each of the layers, { name, layer (plain tables: depth, id, velocity, perhaps hit and normal) }, its curve, and what
-- that does not say: bend, bent. From poses inside of the exposure. Nothing where paths are lines.
function curves.add(p, layers)
  if not curves.are_asked(p) then return end
  local poses = p.trajectory() == "arc" and 5 or 3
  local found = pipeline.loop { name = "inside", count = 1, times = "even", slices = poses, body = function()
    local result = {}
    for _, given in ipairs(layers) do
      local name, layer = given[1], given[2]
      local of = path_curve {
        depth = layer.depth, id = layer.id, velocity = layer.velocity, hit = layer.hit, normal = layer.normal,
        as = name .. "_curve",
      }
      for _, image in ipairs { "curve", "bend", "bent" } do result[name .. "_" .. image] = of[image] end
    end
    return result
  end }
  for _, given in ipairs(layers) do
    local name, layer = given[1], given[2]
    for _, image in ipairs { "curve", "bend", "bent" } do layer[image] = found[name .. "_" .. image] end
  end
end

-- What raster sees, with its curves and the changes of its depths, for a file of passes/gather.
function curves.captured(p, weights)
  local seen = scene.captured()
  curves.require(p, pass.member("gather", weights), "weights = " .. weights)
  curves.add(p, { { "raster", seen } })
  depths.add(p, { { "raster", seen } })
  return seen
end

return curves
