-- SPDX-License-Identifier: MIT
-- A stand-in for the post-process blur of game engines around 2020 (filter of Jimenez 2014, mirrored background).
local pipeline = require "strobe.pipeline"
local gather   = require "passes.gather.ue4"
local scene    = require "scripts.pipelines.lib.scene"
local options  = require "scripts.pipelines.lib.options"
local tiles    = require "scripts.pipelines.lib.tiles"

return pipeline {
  doc = "Stand-in for engines' post-process blur: Jimenez 2014 with mirrored background, 16 px tiles, 5 % of the width",
  params = options.with(options.blur(16, 0.05), {
    mirror = pipeline.bool { true, doc = "the nearer and faster tap of a pair gives both their weight" },
  }),
  build = function(p)
    local seen = scene.captured(p)
    local dominant = tiles.dominant(p, seen).dominant
    local blurred = gather {
      color = seen.color, depth = seen.depth, velocity = seen.velocity, dominant = dominant,
      samples = p.samples, tile = p.tile, limit = p.limit, depth_extent = p.depth_extent, jitter = p.jitter,
      mirror = p.mirror, as = "gather",
    }.blurred
    return scene.outputs(seen, { color = blurred })
  end,
}
