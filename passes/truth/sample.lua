-- SPDX-License-Identifier: MIT
-- One traced time sample of ground truth per pixel, added to one of two half buffers. A loop repeats the pass over the
-- exposure.
-- Source: Cook, Porter, Carpenter, "Distributed Ray Tracing", SIGGRAPH '84.
local pass  = require "strobe.pass"
local shade = require "passes.gbuffer.shade"

return pass.trace {
  doc    = "Colour of one time sample per pixel, by a ray through the scene's true poses at that time; also statistics of " ..
           "the samples, and the regions for error reports",
  size   = { of = "hit" },
  reads  = {
    hit = { uint = true, doc = "surface of the raster layer, by indices: instance + 1 (0 for the sky), geometry, triangle" },
    pixel_list = { buffer = true, optional = true, doc = "list of the pixels to sample; absent: all pixels" },
    light_visibility = { absent = 0, uint = true,
      doc = "lights that are visible, or blocked, from a whole tile, as bits from `tile_light_visibility`; these lights " ..
            "need no shadow rays" },
    known_hit     = { absent = 0, uint = true, doc = "surface that all first samples of the pixel and its neighbours hit, " ..
        "from `sample_consensus`" },
    known_shadows = { absent = 0, uint = true,
      doc = "light visibility that the first samples of the pixel and its neighbours agree on, from `sample_consensus`" },
    even_color    = { absent = 0,
      doc = "colour of the static surface, where the first samples agree on one colour, from `sample_consensus`" },
    first_static      = { absent = 0, uint = true,
      doc = "static surface that the samples before this loop found, encoded like the output `static_background`" },
    first_static_mean = { absent = 0,
      doc = "mean colour of the static surface in the samples before this loop, encoded like the output `static_mean`" },
    first_regions     = { absent = 0, uint = true, doc = "regions for error reports from the samples before this loop, " ..
        "encoded like the output `regions`" },
  },
  dispatch_over = "pixel_list",
  updates = {
    mean_a  = { format = "rgba32f",
      doc = "mean of one half of the samples, linear radiance; alpha: number of samples in that half" },
    mean_b  = { format = "rgba32f",
      doc = "mean of the other half of the samples, linear radiance; alpha: number of samples in that half" },
    regions     = { format = "r32ui",
      doc = "regions for error reports that contain the pixel, as bits. 1 inner: a farther instance at some time; 2 hidden: " ..
            "a disoccluded surface; 4 outer: a nearer instance; 8 self: a disoccluded part of the instance visible at the " ..
            "raster time" },
    static_mean = { format = "rgba32f", doc = "mean colour of the static surface, linear radiance; alpha: number of samples " ..
                                              "that hit this surface" },
    contrast    = { format = "r32f",
      doc = "largest difference of a sample's colour from the mean of the samples before it, relative to that mean" },
    static_background  = { format = "rgba32ui",
      doc = "surface that the samples of the pixel hit. A moving surface is recorded only if pixel = box and no sample of " ..
            "the pixel hits a static surface. x: 0 for none, 1 for the sky, 2 + instance for one surface, 2^32 - 1 for " ..
            "several surfaces. y: geometry. z: triangle, or 2^32 - 1 for several triangles. w: distance, as the bits of a " ..
            "float" },
    shadows = { format = "rgba32ui",
      doc = "light visibility on up to two instances. x and z: 2 + instance. y and w, for the first 16 lights: bit i is set " ..
            "if light i is visible in all samples that trace a shadow ray to it, bit 16 + i if it is blocked in all of " ..
            "these samples; both bits are set if no sample traces such a ray" },
  },
  counters = {
    not_finite = shade.counters.not_finite,
    validated  = "samples that trace all their rays, to validate the results that other samples assume without a ray",
    mismatched   = "validated samples that contradict the first samples: other surface, triangle or shadow",
  },
  params = {
    shading = shade.params.shading {
      doc = "time of the poses used for shading: the raster time, as in blur filters, or the time of the sample" },
    pixel   = pass.choice { "centre", "box", default = "centre",
      doc = "sample positions within the pixel: its centre, or its whole area" },
    in_turn = pass.bool { false, wired = true,
      doc = "order of the sample positions within a pixel. On: by iteration, so that the positions are evenly spread " ..
            "whenever the loop stops. Off: by the time in the exposure, so that positions and times are evenly spread " ..
            "together" },
    shadow_tile = shade.params.shadow_tile,
    every_ray = pass.bool { false, doc = "trace every ray through the whole scene, even if earlier samples make its " ..
                                         "result known" },
    writes_stats = pass.bool { false, wired = true, doc = "store per-pixel statistics of the samples (surface, shadows, " ..
        "contrast), which `sample_consensus` reads" },
    probes = pass.bool { false, wired = true,
      doc = "if the camera moves, also trace a probe: a ray at the raster time, with its shadow rays. `sample_consensus` " ..
            "reads the surface and the shadows that the probe finds" },
    validation_share = pass.float { 0.01, min = 0, max = 1,
      doc = "fraction of the blocks of 4 x 2 pixels that trace every ray, to validate the results that other blocks assume " ..
            "without a ray" },
    static_once_per_loop = pass.bool { false, role = "static_once",
      doc = "sample a pixel only once if no moving surface reaches the pixel; exact with pixel = centre and shading = frozen" },
    mark_regions = pass.bool { true, doc = "find the regions for error reports; costs one more ray per sample" },
  },
}
