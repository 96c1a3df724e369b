-- SPDX-License-Identifier: MIT
-- One traced time sample of ground truth per pixel, added to one of two half buffers. A loop repeats the pass over the
-- exposure.
-- Source: Cook, Porter, Carpenter, "Distributed Ray Tracing", SIGGRAPH '84.
local pass  = require "strobe.pass"
local shade = require "passes.gbuffer.shade"

return pass.trace {
  doc    = "Colour and regions of one time sample per pixel, by a ray through the scene's true poses at that time",
  size   = { of = "hit" },
  reads  = {
    hit = { uint = true, doc = "surface of the raster layer: instance + 1 (0 for the sky), geometry, primitive" },
    pixel_list = { buffer = true, optional = true, doc = "list of the pixels to sample; absent: all pixels" },
    light_visibility = { absent = 0, uint = true,
      doc = "bits per tile from `tile_light_visibility`: lights whose shadow rays need no tracing" },
    known_hit     = { absent = 0, uint = true, doc = "surface that the first samples agree on, from `sample_consensus`" },
    known_shadows = { absent = 0, uint = true,
      doc = "light visibility that the first samples agree on, from `sample_consensus`" },
    even_color    = { absent = 0,
      doc = "colour of the static surface that the first samples agree on, from `sample_consensus`" },
    first_static      = { absent = 0, uint = true,
      doc = "static or common surface of earlier samples, encoded as `static_background`" },
    first_static_mean = { absent = 0,
      doc = "mean colour of the static surface in earlier samples, encoded as `static_mean`" },
    first_regions     = { absent = 0, uint = true, doc = "regions of earlier samples, encoded as `regions`" },
  },
  dispatch_over = "pixel_list",
  updates = {
    mean_a  = { format = "rgba32f",
      doc = "mean of one half of the samples, linear radiance; alpha: number of samples in that half" },
    mean_b  = { format = "rgba32f",
      doc = "mean of the other half of the samples, linear radiance; alpha: number of samples in that half" },
    regions     = { format = "r32ui",
      doc = "regions of the error report that contain the pixel, as bits: 1 inner, 2 hidden, 4 outer, 8 self" },
    static_mean = { format = "rgba32f", doc = "mean colour of the static surface, linear radiance; alpha: number of samples" },
    contrast    = { format = "r32f",
      doc = "largest difference of a sample's colour from the mean of the samples before it, relative to that mean" },
    static_background  = { format = "rgba32ui",
      doc = "surface found by the samples. x: 0 for none, 1 for the sky, 2 + instance, or 2^32 - 1 for several surfaces; y: " ..
            "geometry; z: triangle; w: distance as the bits of a float. Moving surfaces are recorded only with pixel = box, " ..
            "where no sample found a static surface" },
    shadows = { format = "rgba32ui",
      doc = "light visibility on two instances; x and z: 2 + instance; y and w: bit i is set if light i of 16 was visible " ..
            "in all samples that tested it, bit 16 + i if it was blocked in all, both if none tested it" },
  },
  counters = {
    not_finite = shade.counters.not_finite,
    validated  = "samples traced in full to validate the rays skipped elsewhere",
    mismatched   = "validated samples with another surface, triangle or shadow than the first samples agree on",
  },
  params = {
    shading = shade.params.shading {
      doc = "time of the poses used for shading: the raster time, as in blur filters, or the time of the sample" },
    pixel   = pass.choice { "centre", "box", default = "centre",
      doc = "sample positions within the pixel: its centre, or its whole area" },
    in_turn = pass.bool { false, wired = true,
      doc = "spread sample positions evenly over successive iterations, so that the loop may stop at any time; off: spread " ..
            "positions evenly together with the time strata" },
    shadow_tile = shade.params.shadow_tile,
    every_ray = pass.bool { false, doc = "trace every ray, including rays whose result other samples have found" },
    writes_stats = pass.bool { false, wired = true, doc = "store per-pixel statistics of the samples, for `sample_consensus`" },
    probes = pass.bool { false, wired = true,
      doc = "trace and store a probe ray at the raster time with its shadow rays, if the camera moves" },
    validation_share = pass.float { 0.01, min = 0, max = 1,
      doc = "fraction of the blocks of 4 x 2 pixels that trace every ray, to validate the rays skipped elsewhere" },
    static_once_per_loop = pass.bool { false, role = "static_once",
      doc = "sample a pixel only once if no moving surface reaches it; exact with pixel = centre and shading = frozen" },
    mark_regions = pass.bool { true, doc = "find the regions for error reports; costs one more ray per sample" },
  },
}
