-- SPDX-License-Identifier: MIT
-- The sampling range: one displacement over the whole exposure, or one before the capture and one after it.
local pass     = require "strobe.pass"
local pipeline = require "strobe.pipeline"
local either   = require "passes.mask.either"
local halves   = require "passes.scene.halves"
local scene    = require "scripts.pipelines.lib.scene"

local ranges = {}

-- A parameter of pipelines whose filters know parts of the exposure.
ranges.param = pipeline.choice { "whole", "split", default = "whole",
  doc = "displacements: one for the exposure, or one for each side of the capture (matters to the anchor centre alone)",
  values = {
    whole = "One displacement over the exposure: a point moves along a straight line at an even pace. Fails where " ..
            "motion bends: what turns back at the capture is taken for something at rest.",
    split = "Times before the capture use the displacement from the start of the exposure to the capture, times " ..
            "after it that from the capture to the end, each from true poses. Costs a second set of tiles and a " ..
            "second mask. The anchors close and open have one part only, and displacement = extrapolated knows one " ..
            "displacement only: there it is the same as whole. Fails where motion bends elsewhere than at the capture.",
  } }

function ranges.are_split(p)
  return p.range() == "split" and p.displacement() == "window"
end

-- `layer` (scene.layer) for a filter: if the range is split, a copy with the velocity before the raster time, an
-- after_velocity, and the former velocity as whole_velocity. `name` names the node.
function ranges.divided(p, layer, name)
  if not ranges.are_split(p) then return layer end
  local parts = halves {
    depth = layer.depth, id = layer.id, velocity = layer.velocity, as = name,
  }
  local divided = scene.layer {}
  for key, value in pairs(layer) do divided[key] = value end
  divided.velocity, divided.after_velocity, divided.whole_velocity = parts.before, parts.after, layer.velocity
  return divided
end

-- A divided layer as it moves after the capture; made once.
function ranges.after(layer)
  if layer.after then return layer.after end
  local after = scene.layer {}
  for key, value in pairs(layer) do after[key] = value end
  after.velocity, after.after_velocity, after.motions, after.bounds = layer.after_velocity, nil, nil, nil
  layer.after = after
  return after
end

-- A mask of a layer: `mask(p, layer)`, of both parts where there are two.
function ranges.mask(p, layer, mask)
  if not layer.after_velocity then return mask(p, layer) end
  return either {
    first = pipeline.prefixed("before_", function() return mask(p, layer) end),
    second = pipeline.prefixed("after_", function() return mask(p, ranges.after(layer)) end),
    as = "mask",
  }.mask
end

-- Stops where a filter would take no notice of the parts.
function ranges.require_parts(layer, filter, setting)
  if not layer.after_velocity or pass.reads(filter, "after_velocity") then return end
  error(("range = split: %s knows no parts of the exposure; it needs range = whole"):format(setting), 0)
end

return ranges
