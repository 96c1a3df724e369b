-- SPDX-License-Identifier: MIT
-- Post-process blur of McGuire, Hennessy, Bukowski and Osman 2012, for any anchor.
local pipeline = require "strobe.pipeline"
local gather   = require "passes.gather.mcguire2012"
local scene    = require "scripts.pipelines.lib.scene"
local options  = require "scripts.pipelines.lib.options"
local ranges   = require "scripts.pipelines.lib.ranges"
local tiles    = require "scripts.pipelines.lib.tiles"
local gathers  = require "scripts.pipelines.lib.gathers"

return pipeline {
  doc = "McGuire et al. 2012: a gather along the dominant displacement of the surrounding tiles",
  params = options.with(options.blur(40), {
    weights = pipeline.choice(gathers.choice("mcguire2012",
      "weights of the taps: as published, or each tap an equal share of the exposure", { "mcguire2012", "uniform" })),
    directions = gather.params.directions,
    range = ranges.param,
  }),
  build = function(p)
    local seen = scene.captured()
    local moving = ranges.divided(p, seen, "halves")
    local images = gathers.images(moving, tiles.dominant(p, moving))
    return scene.outputs(seen, {
      color = gathers.blurred(p.weights(), images, "gather"),
    })
  end,
}
