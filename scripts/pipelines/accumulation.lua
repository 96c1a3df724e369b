-- SPDX-License-Identifier: MIT
-- The accumulation buffer: the mean of the scene drawn at many times. Haeberli and Akeley 1990.
local pipeline = require "strobe.pipeline"
local blur     = require "passes.lib.blur"
local raster_color = require "passes.lib.raster_color"
local accumulated       = require "passes.accumulation.accumulate_moving"
local over_background   = require "passes.accumulation.over_background"
local static_background = require "passes.accumulation.static_background"
local visibility_moving = require "passes.gbuffer.visibility_moving"
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
        detailed = "The blend, except where the four texels differ by more than `contrast` and the surface moves by at most " ..
                   "`detail_below` from sample to sample: there shading.",
      } },
    contrast = raster_color.contrast {
      doc = "with reuse = detailed: largest difference of the four texels that are blended, share of their colour" },
    detail_below = raster_color.detail_below {
      doc = "with reuse = detailed: motion from sample to sample above which the four texels are always blended" },
  },
  build = function(p)
    local raster = scene.raster()
    local background = static_background { hit = raster.hit }.static_background
    local moving = pipeline.loop { name = "shutter", count = p.samples, times = "midpoint", body = function()
      local hit = visibility_moving { time = "sample", as = "sample_visibility" }.hit
      return { moving = accumulated {
        hit = hit, color = raster.color, depth = raster.depth, id = raster.id,
        static_background = background, time = "sample", reused = p.reuse() ~= "none",
        shades_contrast = p.reuse() == "detailed",
      }.moving }
    end }.moving
    return scene.outputs(raster, {
      color = over_background { moving = moving, static_background = background, color = raster.color }.picture,
    })
  end,
}
