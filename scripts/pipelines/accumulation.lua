-- SPDX-License-Identifier: MIT
-- Motion blur by an accumulation buffer (Haeberli and Akeley 1990): the scene is rasterised at many times of the exposure, and
-- the pictures are averaged.
local pipeline = require "strobe.pipeline"
local blur     = require "passes.lib.blur"
local raster_color = require "passes.lib.raster_color"
local accumulated       = require "passes.accumulation.accumulate_moving"
local over_background   = require "passes.accumulation.over_background"
local static_background = require "passes.accumulation.static_background"
local visibility_moving = require "passes.gbuffer.visibility_moving"
local scene    = require "scripts.pipelines.lib.scene"

local snapped = "the rasteriser snaps vertices to 1/256 px, so that a silhouette may cross the centre of a pixel"

return pipeline {
  doc = "Accumulation buffer (Haeberli and Akeley 1990): mean of pictures at many times, all shaded as at the raster time",
  breaks = { mirrored = snapped, scaled = snapped },
  params = {
    samples = blur.samples { doc = "number of time samples; the scene is drawn once for each" },
    reuse   = pipeline.choice { "none", "blended", "detailed", default = "detailed",
      doc = "source of a surface's colour in a time sample: new shading, or the raster image if that image shows the surface",
      values = {
        none = "Every sample is shaded in the pose of the raster time. Costs a shadow ray per sample and light.",
        blended = "The four nearest texels of the raster image are blended if they show the surface. Otherwise the sample " ..
                  "is shaded. Fails by smoothing textures.",
        detailed = "Like `blended`, but a sample is shaded if the four texels around it differ by more than " ..
                   "`contrast` and its surface moves by at most `detail_below` from sample to sample.",
      } },
    contrast = raster_color.contrast {
      doc = "largest relative difference between the colours of raster texels that a time sample may blend. If the four " ..
            "texels around the sample's surface point differ by more, the sample is shaded anew, unless the surface " ..
            "moves by more than `detail_below` from sample to sample. Used with reuse = detailed" },
    detail_below = raster_color.detail_below {
      doc = "displacement of a surface from one time sample to the next. Above it, the four raster texels around a " ..
            "point of the surface are blended even if their colours differ. Used with reuse = detailed" },
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
