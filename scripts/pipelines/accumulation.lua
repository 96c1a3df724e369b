-- SPDX-License-Identifier: MIT
-- The accumulation buffer: the scene drawn at many times. Haeberli and Akeley 1990.
local pipeline = require "strobe.pipeline"
local blur     = require "passes.lib.blur"
local captured_color = require "passes.lib.captured_color"
local accumulated  = require "passes.scene.accumulated"
local over_ground  = require "passes.scene.over_ground"
local still_ground = require "passes.scene.still_ground"
local visibility_moving = require "passes.scene.visibility_moving"
local scene    = require "scripts.pipelines.lib.scene"

local snapped = "vertices are snapped to 1/256 px: a silhouette as close to a pixel's centre falls to either side"

return pipeline {
  doc = "The scene drawn at each time sample, in the colours of the capture (Haeberli and Akeley 1990)",
  breaks = { mirrored = snapped, scaled = snapped },
  params = {
    samples = blur.samples { doc = "times at which the scene is drawn" },
    reuse   = pipeline.choice { "none", "blended", "detailed", default = "detailed",
      doc = "whether what is seen at other times has the colour that the capture shows of it",
      values = {
        none = "It never has: all is shaded, as it is at the capture, at each time. A shadow ray per sample and light.",
        blended = "It has, blended of the four texels around, wherever these show it. Fails by smoothing texture.",
        detailed = "Only where these texels are alike, or it moves by more than `detail_below` from sample to sample.",
      } },
    unlike = captured_color.unlike { doc = "with reuse = detailed: share of their colour by which such texels may differ" },
    detail_below = captured_color.detail_below {
      doc = "with reuse = detailed: what moves by more from sample to sample is blended, however they differ" },
  },
  build = function(p)
    local seen = scene.captured()
    local ground = still_ground { hit = seen.hit }.ground
    local moving = pipeline.loop { name = "shutter", count = p.samples, times = "midpoint", body = function()
      local hit = visibility_moving { time = "sample", as = "sample_visibility" }.hit
      return { moving = accumulated {
        hit = hit, color = seen.color, depth = seen.depth, id = seen.id, ground = ground, time = "sample",
        reused = p.reuse() ~= "none", shades_unlike = p.reuse() == "detailed",
      }.moving }
    end }.moving
    return scene.outputs(seen, {
      color = over_ground { moving = moving, ground = ground, color = seen.color }.picture,
    })
  end,
}
