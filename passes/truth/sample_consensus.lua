-- SPDX-License-Identifier: MIT
-- Consensus of the first samples of ground truth, so that later samples need fewer rays.
local pass = require "strobe.pass"

return pass.compute {
  doc    = "Surface, shadows and colour that all first samples of a pixel and its neighbours agree on",
  fails  = "Misses objects smaller than a pixel that lie between all of these samples.",
  size   = { of = "static_background" },
  reads  = {
    static_background = { uint = true,
      doc = "surface found by the samples. x: 0 for none, 1 for the sky, or 2 + instance; y: geometry; z: triangle. A " ..
            "moving surface is stored only if no sample found a static surface" },
    static_mean = { doc = "mean colour of the static surface, linear radiance" },
    contrast    = {
      doc = "largest difference of a sample's colour from the mean of the samples before it, relative to that mean" },
    shadows = { uint = true,
      doc = "light visibility on two instances; x and z: 2 + instance; y and w: bit i is set if light i was visible in all " ..
            "samples that tested it, bit 16 + i if it was blocked in all, both if none tested it" },
  },
  writes = {
    known_hit = { format = "rgba32ui",
      doc = "surface that all samples agree on, encoded as `static_background`. x: 0 if the samples do not agree; z: " ..
            "2^32 - 1 if the triangles differ" },
    known_shadows = { format = "rgba32ui", doc = "light visibility that all samples agree on, encoded as `shadows`" },
    even_color = { format = "rgba32f",
      doc = "colour of the static surface, linear radiance; alpha: 1 if all samples agree on the colour, otherwise 0" },
    more = { format = "r8_unorm", doc = "0 where the first samples suffice, otherwise 1" },
  },
  params = {
    even_within = pass.float { 0.02, min = 0, max = 1,
      doc = "largest difference of colours from their mean, relative to the mean, that counts as one colour" },
    one_shading = pass.bool { true, wired = true,
      doc = "true if all samples are shaded at the raster time, so that one colour may suffice" },
    validation_share = pass.float { 0, min = 0, max = 1, wired = true,
      doc = "fraction of the pixels that take all samples, for validation" },
  },
}
