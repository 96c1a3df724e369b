-- SPDX-License-Identifier: MIT
-- Passes over the list of moving pixels, or over the picture.
local pipeline   = require "strobe.pipeline"
local moving     = require "passes.mask.moving"
local marked     = require "passes.marked"
local traced     = require "passes.traced"
local drawn_bins = require "passes.drawn_bins"
local compact      = require "scripts.pipelines.lib.compact"
local options    = require "scripts.pipelines.lib.options"
local scene      = require "scripts.pipelines.lib.scene"
local tiles      = require "scripts.pipelines.lib.tiles"

local params = options.blur(8, 0.1)
params.over = pipeline.choice { "list", "picture", default = "list", doc = "dispatch domain of the passes" }

return pipeline {
  doc = "Number of runs at each pixel, and distances along its rays",
  params = params,
  build = function(p)
    local seen = scene.raster()
    local mask = moving { velocity = seen.velocity, dominant = tiles.dominant(p, seen).dominant }.mask
    local listed = p.over() == "list" and compact.pixels(mask, "moving") or nil
    local made = marked { color = seen.color, listed = listed }
    return scene.outputs(seen, {
      color = seen.color, mask = mask, times = made.times, copied = made.copied,
      distance = traced { listed = listed }.distance, bins = drawn_bins { bins = made.bins }.drawn,
    })
  end,
}
