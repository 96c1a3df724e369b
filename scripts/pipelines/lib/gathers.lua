-- SPDX-License-Identifier: MIT
-- Gathers: filters that blur one layer by reading colours along the motion.
local pass     = require "strobe.pass"
local pipeline = require "strobe.pipeline"
local paths    = require "scripts.pipelines.lib.paths"

local gathers = {}

local images_of_gather = pipeline.record("the inputs of a gather", {
  "valid", "velocity_post", "second", "dominant_post", "background_depth", "background_valid",
  "slowest", "variance",
})

-- Returns the declaration of a choice parameter that selects a gather. Its values are the files of passes/gather, or only the
-- files in `names`.
function gathers.choice(default, doc, names)
  local declared = names or pass.family("gather")
  declared.default, declared.doc, declared.values = default, doc, {}
  for _, name in ipairs(declared) do
    local gather = pass.member("gather", name).description
    declared.values[name] = ("%s. Fails: %s"):format(gather.doc, gather.fails)
  end
  return declared
end

-- Blurs a layer and returns the result. `weights`: name of the gather, a file of passes/gather. `images`: inputs of the gather,
-- from gathers.images. `name`: name of the node. `color_format`: memory format of the result; nil: fp32, for a final picture.
function gathers.blurred(weights, images, name, color_format)
  local gather = pass.member("gather", weights)
  paths.require_segments(images, gather, "weights = " .. weights)
  return gather(pass.wired(gather, images, { as = name, color_format = color_format or "fp32" })).blurred
end

-- Returns the inputs of a gather. `layer`: the layer to blur (color, depth, velocity, optionally valid). `around`: result of
-- tiles.dominant for this layer. `background`: the layer that rays reveal behind `layer`; nil: none.
function gathers.images(layer, around, background)
  return images_of_gather {
    color = layer.color, depth = layer.depth, velocity = layer.velocity, valid = layer.valid,
    velocity_post = layer.velocity_post,
    dominant = around.dominant, second = around.second, dominant_post = around.dominant_post,
    background_depth = background and background.depth, background_valid = background and background.valid,
  }
end

return gathers
