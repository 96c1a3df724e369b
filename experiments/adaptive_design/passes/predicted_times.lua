-- SPDX-License-Identifier: MIT
-- The prediction of the pass `layered/in_gather`, with a ray for each time sample without a predicted surface.
local pass         = require "strobe.pass"
local blur         = require "passes.lib.blur"
local ports        = require "passes.lib.blur_ports"
local jitter       = require "passes.lib.jitter"
local raster_color = require "passes.lib.raster_color"
local shade        = require "passes.gbuffer.shade"

return pass.trace {
  doc    = "Blur by prediction: each time sample takes the surface that displacements bring to the pixel. Samples without " ..
           "such a surface get a ray",
  fails  = "A sample between two validation rays is wrong if the found surface is hidden by a surface with another motion, " ..
           "or if its path is nonlinear.",
  size   = { of = "color" },
  reads  = ports.of_both({}, {
    hit         = { uint = true,
      doc = "surface of the raster layer, by indices: instance + 1 (0 for the sky), geometry, triangle" },
    id          = { uint = true, doc = "instance index + 1, geometry index + 1 of the raster layer; 0 for the sky" },
    revealed_id = { uint = true, doc = "instance index + 1, geometry index + 1 of the surface revealed behind the raster " ..
                                       "layer; 0 for the sky" },
  }),
  writes = ports.picture,
  if_no  = ports.no_motion,
  params = {
    validation_rays = pass.int { 3, min = 0, max = 64,
      doc = "number of rays per pixel that check the prediction, evenly spread over the time samples for which the " ..
            "prediction has a surface" },
    mismatch        = pass.float { 0.05, min = 0, max = 1e6,
      doc = "largest difference of a channel between a validation ray and the prediction, linear radiance" },
    shades_contrast = raster_color.shades_contrast,
    contrast     = raster_color.contrast,
    detail_below = raster_color.detail_below,
    same_depth   = raster_color.same_depth,
    samples      = blur.samples { doc = "number of time samples" },
    tile         = blur.tile,
    limit        = blur.limit,
    depth_extent = blur.depth_extent,
    jitter       = jitter.jitter,
    jitter_frame = jitter.jitter_frame,
  },
  counters = {
    fallback   = "time samples whose background is in neither layer",
    samples    = "time samples with a ray",
    shaded     = "hits that are shaded because no layer shows their surface",
    not_finite = shade.counters.not_finite,
  },
}
