-- SPDX-License-Identifier: MIT
-- The hybrid's mask without what is done with it.
local pipeline = require "strobe.pipeline"
local hybrid   = require "scripts.pipelines.lib.hybrid"
local masks    = require "scripts.pipelines.lib.masks"
local options  = require "scripts.pipelines.lib.options"
local scene    = require "scripts.pipelines.lib.scene"

return pipeline {
  doc    = "Pixels to reveal behind",
  params = options.with(options.blur(40, 0.1), hybrid.mask_params()),
  build  = function(p)
    local seen = scene.captured()
    return scene.outputs(seen, { color = seen.color, mask = masks[p.mask()](p, seen) })
  end,
}
