-- SPDX-License-Identifier: MIT
-- Blur of one layer.
local pass     = require "strobe.pass"
local pipeline = require "strobe.pipeline"
local paths    = require "scripts.pipelines.lib.paths"

local gathers = {}

local images_of_gather = pipeline.record("the inputs of a gather", {
  "valid", "velocity_post", "second", "dominant_post", "background_depth", "background_valid",
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
  paths.require_segments(images, gather, "weights = " .. weights)
  return gather(pass.wired(gather, images, { as = name, color_format = color_format or "fp32" })).blurred
end

-- Inputs of a gather, from a layer (color, depth, velocity, optionally valid), the result of tiles.dominant for it, and the
-- layer revealed behind it, if any.
function gathers.images(layer, around, background)
  return images_of_gather {
    color = layer.color, depth = layer.depth, velocity = layer.velocity, valid = layer.valid,
    velocity_post = layer.velocity_post,
    dominant = around.dominant, second = around.second, dominant_post = around.dominant_post,
    background_depth = background and background.depth, background_valid = background and background.valid,
  }
end

return gathers
