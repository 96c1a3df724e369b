-- SPDX-License-Identifier: MIT
-- Colours of the surfaces that are rasterised at one time of the exposure. A surface that the raster layer shows has the
-- colour of its texel; any other surface is shaded.
local pass = require "strobe.pass"
local blur = require "passes.lib.blur"
local raster_color = require "passes.lib.raster_color"
local shade = require "passes.gbuffer.shade"

return pass.trace {
  doc   = "Colours of a pose, which is the scene rasterised at one sample time; shaded as at the raster time",
  size  = { of = "hit" },
  reads = {
    hit   = { uint = true, doc = "indices of the surface in the pose: instance + 1 (0 for the sky), geometry, triangle" },
    drawn = { absent = 1, doc = "per cell, above 1/2 where the colours of the pose are wanted" },
    rest  = { absent = 0, doc = "colour of the cells whose value of `drawn` is at most 1/2, linear radiance" },
    color = { doc = "colour of the raster layer, linear radiance" },
    depth = { doc = "linear view depth of the raster layer, metres; +inf for the sky" },
    id    = { uint = true, doc = "instance index + 1, geometry index + 1 of the raster layer; 0 for the sky" },
  },
  writes = { pose = { format = "rgba32f", doc = "colour of the pose, linear radiance; alpha 1" } },
  params = {
    cell_side       = blur.cell_side,
    shades_contrast = raster_color.shades_contrast,
    contrast        = raster_color.contrast,
    detail_below    = raster_color.detail_below,
    same_depth      = raster_color.same_depth,
  },
  counters = {
    shaded     = "hits that are shaded because the raster layer does not show their surface",
    not_finite = shade.counters.not_finite,
  },
}
