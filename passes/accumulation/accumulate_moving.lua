-- SPDX-License-Identifier: MIT
-- One time sample of the moving surfaces, added to the mean of earlier samples. Haeberli and Akeley 1990, "The Accumulation
-- Buffer"; shading reused for several times: Ragan-Kelley et al. 2011, "Decoupled Sampling".
local pass  = require "strobe.pass"
local raster_color = require "passes.lib.raster_color"
local shade = require "passes.gbuffer.shade"

return pass.trace {
  doc    = "Running mean, over the time samples, of the colours of visible moving surfaces, shaded as at the raster " ..
           "time",
  fails  = "Highlights and shadows that move within the exposure stay fixed to their surfaces.",
  size   = { of = "hit" },
  reads  = {
    hit    = { uint = true,
      doc = "visible moving surface at the sample's time, by indices: instance + 1 (0 for none), geometry, triangle" },
    color             = { doc = "colour of the raster layer, linear radiance" },
    depth             = { doc = "linear view depth of the raster layer, metres; +inf for the sky" },
    id                = { uint = true, doc = "instance index + 1, geometry index + 1 of the raster layer; 0 for the sky" },
    static_background = {
      doc = "alpha: linear view depth of the static background behind a moving surface, metres; 0 where the raster " ..
                     "layer is static. The colour channels are not read" },
  },
  updates = { moving = { format = "rgba32f",
    doc = "mean colour of the visible moving surfaces, linear radiance; alpha: number of samples in this mean" } },
  params = {
    reused        = pass.bool { true,
      doc = "take the colour of the raster layer where that layer shows the surface of the sample; off: shade every sample" },
    shades_contrast = raster_color.shades_contrast,
    contrast        = raster_color.contrast,
    detail_below    = raster_color.detail_below,
    same_depth      = raster_color.same_depth,
    skip_static     = pass.bool { true, role = "static_once",
      doc = "skip pixels that no moving surface reaches" },
  },
  counters = {
    shaded     = "samples with newly shaded colours: the raster layer lacks their surface points or shows them too " ..
                 "coarsely, or `reused` is off",
    not_finite = shade.counters.not_finite,
  },
}
