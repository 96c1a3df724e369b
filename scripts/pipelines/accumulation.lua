-- SPDX-License-Identifier: MIT
-- The accumulation buffer: the mean of the scene drawn at many times. Haeberli and Akeley 1990.
local pipeline = require "strobe.pipeline"
local blur     = require "passes.lib.blur"
local captured_color = require "passes.lib.captured_color"
local accumulated  = require "passes.scene.accumulated"
local over_ground  = require "passes.scene.over_ground"
local still_ground = require "passes.scene.still_ground"
local visibility_moving = require "passes.scene.visibility_moving"
local scene    = require "scripts.pipelines.lib.scene"

local snapped = "vertices are snapped to 1/256 px, so a silhouette this close to a pixel's centre may fall to either side"

return pipeline {
  doc = "Mean of the scene drawn at each time sample, shaded as at the raster time (Haeberli and Akeley 1990)",
  breaks = { mirrored = snapped, scaled = snapped },
  params = {
    samples = blur.samples { doc = "number of times, each with its own drawing of the scene" },
    reuse   = pipeline.choice { "none", "blended", "detailed", default = "detailed",
      doc = "source of a surface's colour at other times: shading, or the raster image where it shows the surface",
      values = {
        none = "Shading, in the pose of the raster time, of every sample. Costs a shadow ray per sample and light.",
        blended = "Blend of the four nearest texels of the raster image if they show the surface, otherwise shading. Fails " ..
                  "by smoothing textures.",
        detailed = "The blend, except where the four texels differ by more than `unlike` and the surface moves by at most " ..
                   "`detail_below` from sample to sample: there shading.",
      } },
    unlike = captured_color.unlike {
      doc = "with reuse = detailed: largest difference of the four texels that are blended, share of their colour" },
    detail_below = captured_color.detail_below {
      doc = "with reuse = detailed: motion from sample to sample above which the four texels are always blended" },
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
