-- SPDX-License-Identifier: MIT
-- Blur of one layer.
local pass     = require "strobe.pass"
local pipeline = require "strobe.pipeline"
local ranges   = require "scripts.pipelines.lib.ranges"

local gathers = {}

local images_of_gather = pipeline.record("the inputs of a gather", {
  "valid", "after_velocity", "second", "after_dominant", "behind_depth", "behind_valid",
  "slowest", "variance",
})

-- A choice among the files of passes/gather, or among `names`.
function gathers.choice(default, doc, names)
  local declared = names or pass.family("gather")
  declared.default, declared.doc, declared.values = default, doc, {}
  for _, name in ipairs(declared) do
    local gather = pass.member("gather", name).description
    declared.values[name] = ("%s. Fails: %s"):format(gather.doc, gather.fails)
  end
  return declared
end

-- Blurs a layer with `weights`, the name of a file of passes/gather. `images`: its inputs by name, from gathers.images.
-- `color_format`: format of a blurred layer; nil: fp32, for a final picture.
function gathers.blurred(weights, images, name, color_format)
  local gather = pass.member("gather", weights)
  ranges.require_parts(images, gather, "weights = " .. weights)
  return gather(pass.wired(gather, images, { as = name, color_format = color_format or "fp32" })).blurred
end

-- Inputs of a gather, from a layer (color, depth, velocity, optionally valid), the result of tiles.dominant for it, and the
-- layer revealed behind it, if any.
function gathers.images(layer, around, behind)
  return images_of_gather {
    color = layer.color, depth = layer.depth, velocity = layer.velocity, valid = layer.valid,
    after_velocity = layer.after_velocity,
    dominant = around.dominant, second = around.second, after_dominant = around.after_dominant,
    behind_depth = behind and behind.depth, behind_valid = behind and behind.valid,
  }
end

return gathers
