-- SPDX-License-Identifier: MIT
-- Rays for unresolved time samples, each traced at the time of its sample.
local pass  = require "strobe.pass"
local raster_color = require "passes.lib.raster_color"
local shade = require "passes.gbuffer.shade"

return pass.trace {
  doc    = "Colours of the time samples that no layer resolves, by one ray per sample, traced at the time of the sample",
  size   = { of = "partial" },
  reads  = {
    partial  = { pointwise = true,
      doc = "sum of the resolved samples, divided by the number of all samples, linear radiance; alpha: fraction of " ..
            "resolved samples" },
    unresolved = { uint = true, doc = "bit i is set if any time sample of stratum i is unresolved; the strata are " ..
                                      "min(`samples`, 64) equal parts of the samples" },
    hit        = { uint = true, doc = "surface of the raster layer, by indices: instance + 1 (0 for the sky), geometry, " ..
                                      "triangle" },
    color      = { doc = "colour of the raster layer, linear radiance" },
    depth      = { doc = "linear view depth of the raster layer, metres; +inf for the sky" },
    id         = { uint = true, doc = "instance index + 1, geometry index + 1 of the raster layer; 0 for the sky" },
    revealed_color = { doc = "colour of the surface revealed behind the raster layer, linear radiance" },
    revealed_depth = { doc = "linear view depth of the surface revealed behind the raster layer, metres; +inf for the sky" },
    revealed_id    = { uint = true, doc = "instance index + 1, geometry index + 1 of the surface revealed behind the raster " ..
                                          "layer; 0 for the sky" },
    revealed_valid = { doc = "mask, above 1/2 where a ray revealed a surface behind the raster layer" },
  },
  writes = { picture = { format = "rgba32f", doc = "blurred picture, linear radiance; alpha 1" } },
  if_no = { motion = { picture = "partial" }, moving_rect = { picture = "partial" } },
  params = {
    validation_share      = pass.float { 0.01, min = 0, max = 1,
      doc = "fraction of the blocks of 4 x 2 pixels whose resolved samples are validated by rays. Blocks outside " ..
            "the rectangle that contains all motion are not validated" },
    mismatch_tolerance   = pass.float { 0.1, min = 0, max = 1,
      doc = "largest relative error, of the mean of a pixel's resolved samples, that passes validation" },
    shades_contrast = raster_color.shades_contrast,
    contrast        = raster_color.contrast,
    detail_below    = raster_color.detail_below,
    same_depth      = raster_color.same_depth,
  },
  counters = {
    samples    = "time samples resolved by a ray",
    shaded     = "hits shaded because the layers do not show their surface in enough detail",
    validated  = "pixels whose resolved samples were validated by rays",
    mismatched = "validated pixels whose resolved samples have a wrong mean",
    not_finite = shade.counters.not_finite,
  },
  fails  = "Sample times are quantised to at most 64 strata, without jitter. Highlights and shadows stay fixed as at the " ..
           "raster time. The visibility is exact.",
}
