-- SPDX-License-Identifier: MIT
-- Paths of surface points over the exposure: a line, two segments that meet at the raster time, or a curve.
local pass               = require "strobe.pass"
local pipeline           = require "strobe.pipeline"
local union              = require "passes.mask.union"
local extrapolated_curve = require "passes.time.extrapolated_curve"
local path_curve         = require "passes.time.path_curve"
local two_segments       = require "passes.time.two_segments"
local scene              = require "scripts.pipelines.lib.scene"

local paths = {}

-- Parameter of pipelines whose filters can follow two segments.
paths.range = pipeline.choice { "whole", "split", default = "whole",
  doc = "displacements of a surface point: one for the exposure, or, with anchor = centre, one before and one after the " ..
        "raster time",
  values = {
    whole = "One displacement: a point moves along a straight line at constant speed. Fails where motion turns: a point " ..
            "that turns back at the raster time is taken as static.",
    split = "One displacement from shutter open to the raster time and one from there to shutter close, each from exact " ..
            "poses. Costs a second set of tiles and a second mask. Equals `whole` if anchor is end or start, because the " ..
            "exposure then lies on one side of the raster time, and if displacement = extrapolated. Fails where motion " ..
            "turns at any time other than the raster time.",
  } }

-- ---- two segments

function paths.are_split(p)
  return p.range() == "split" and p.displacement() == "window"
end

local function copy_of(layer)
  local copy = scene.layer {}
  for key, value in pairs(layer) do copy[key] = value end
  return copy
end

-- If the motion is split at the raster time (range = split), returns a copy of `layer` with two fields for the two
-- segments. Each field is the displacement, px, of a point that keeps the velocity of one segment from shutter open to
-- shutter close:
--   velocity        at the velocity before the raster time
--   velocity_post   at the velocity after the raster time
-- Otherwise returns `layer`. `name`: name of the node.
function paths.split(p, layer, name)
  if not paths.are_split(p) then return layer end
  local segments = two_segments { depth = layer.depth, id = layer.id, velocity = layer.velocity, as = name }
  local split = copy_of(layer)
  split.velocity, split.velocity_post = segments.velocity_pre, segments.velocity_post
  return split
end

-- Returns a copy of the split layer `layer`, with the velocity after the raster time as its velocity. Filters that read only
-- one velocity can read this copy. Later calls return the first copy.
function paths.post(layer)
  if layer.post then return layer.post end
  local post = copy_of(layer)
  post.velocity, post.velocity_post, post.velocities, post.bounds = layer.velocity_post, nil, nil, nil
  layer.post = post
  return post
end

-- Returns the mask that the function `mask`, called as mask(p, layer), makes for a layer. If the layer is split, calls the
-- function twice, for the motion before and for the motion after the raster time, and returns the union of the two masks.
function paths.mask(p, layer, mask)
  if not layer.velocity_post then return mask(p, layer) end
  return union {
    first = pipeline.prefixed("pre_", function() return mask(p, layer) end),
    second = pipeline.prefixed("post_", function() return mask(p, paths.post(layer)) end),
    as = "mask",
  }.mask
end

-- Raises an error if the layer has two segments and the pass `filter` follows only one. `setting`: name of the filter in the
-- message.
function paths.require_segments(layer, filter, setting)
  if not layer.velocity_post or pass.reads(filter, "velocity_post") then return end
  error(("range = split: %s supports only one displacement for the whole exposure; set range = whole"):format(setting), 0)
end

-- ---- curves

function paths.are_curved(p) return p.trajectory() ~= "line" end

-- True if curves are extrapolated from the poses of previous frames. Extrapolated curves also replace the velocity.
function paths.are_extrapolated(p) return paths.are_curved(p) and p.displacement() == "extrapolated" end

-- Raises an error if paths are curved and the pass `filter` cannot follow curves. `setting`: name of the filter in the message.
function paths.require_curves(p, filter, setting)
  if not paths.are_curved(p) then return end
  if pass.reads(filter, "velocity_post") and paths.are_split(p) then
    error(("trajectory = %s: paths are straight with range = split; set range = whole"):format(p.trajectory()), 0)
  end
  if not pass.reads(filter, "curve") then
    error(("trajectory = %s: %s supports straight paths only; set trajectory = line"):format(p.trajectory(), setting), 0)
  end
end

-- Number of poses in the loop that fits curves to paths. An extrapolated curve is fitted to the poses at the raster
-- time and in this number of earlier frames. Any other curve is fitted to the poses at shutter open, at shutter close
-- and at this number of times between the two.
local function poses_of(p)
  if not paths.are_extrapolated(p) then return p.trajectory() == "arc" and 5 or 3 end
  if p.trajectory() == "arc" then
    error("trajectory = arc: arcs need poses inside of the exposure; set displacement = window, or trajectory = quadratic", 0)
  end
  return 2
end

local function curve_of(p, name, layer)
  local images = { depth = layer.depth, id = layer.id, hit = layer.hit, as = name .. "_curve" }
  if not paths.are_extrapolated(p) then return path_curve(images) end
  images.velocity = layer.velocity
  return extrapolated_curve(images)
end

-- Adds the field `curve` to each layer of `layers`, a list of { name, layer }. An extrapolated curve also replaces the field
-- `velocity`. Changes nothing if paths are straight lines.
function paths.add_curves(p, layers)
  if not paths.are_curved(p) then return end
  local extrapolated = paths.are_extrapolated(p)
  local images = { "curve", extrapolated and "velocity" or nil }
  local found = pipeline.loop {
    name = extrapolated and layers[1][1] .. "_earlier" or "inside",
    count = 1, times = extrapolated and "frames" or "even", slices = poses_of(p),
    body = function()
      local result = {}
      for _, given in ipairs(layers) do
        local curve = curve_of(p, given[1], given[2])
        for _, image in ipairs(images) do result[given[1] .. "_" .. image] = curve[image] end
      end
      return result
    end,
  }
  for _, given in ipairs(layers) do
    local name, layer = given[1], given[2]
    for _, image in ipairs(images) do layer[image] = found[name .. "_" .. image] end
  end
end

return paths
