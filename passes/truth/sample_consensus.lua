-- SPDX-License-Identifier: MIT
-- Consensus of the first samples of ground truth: their common surface, shadows and colour. Later samples need fewer rays.
local pass = require "strobe.pass"

return pass.compute {
  doc    = "Surface, shadows and colour that all first samples of a pixel and its eight neighbours agree on, so that later " ..
           "samples need fewer rays",
  fails  = "A surface that lies between all of these samples, such as an object smaller than a pixel, is missing from the " ..
           "consensus and from later samples.",
  size   = { of = "static_background" },
  reads  = {
    static_background = { uint = true,
      doc = "surface that the samples hit. x: 0 for none, 1 for the sky, or 2 + instance; y: geometry; z: triangle. A " ..
            "moving surface is stored only if no sample hits a static surface" },
    static_mean = { doc = "mean colour of the static surface, linear radiance" },
    contrast    = {
      doc = "largest difference of a sample's colour from the mean of the samples before it, relative to that mean" },
    shadows = { uint = true,
      doc = "light visibility on up to two instances. x and z: 2 + instance. y and w: bit i is set if light i is visible in " ..
            "all samples that trace a shadow ray to it, bit 16 + i if it is blocked in all of these samples; both bits are " ..
            "set if no sample traces such a ray" },
  },
  writes = {
    known_hit = { format = "rgba32ui",
      doc = "surface that all samples hit, encoded like the input `static_background`. x: 0 if the samples hit different " ..
            "surfaces; z: 2^32 - 1 if they hit different triangles" },
    known_shadows = { format = "rgba32ui", doc = "light visibility that all samples agree on, encoded like the input " ..
        "`shadows`" },
    even_color = { format = "rgba32f",
      doc = "colour of the static surface, linear radiance; alpha: 1 if all samples agree on the colour, otherwise 0" },
    more = { format = "r8_unorm", doc = "1 at pixels that need further samples, 0 where the first samples suffice" },
  },
  params = {
    even_within = pass.float { 0.02, min = 0, max = 1,
      doc = "largest difference of a colour from the mean of the samples, relative to the mean, that still counts as one " ..
            "colour" },
    one_shading = pass.bool { true, wired = true,
      doc = "true if all samples are shaded at the raster time, so that one colour may suffice" },
    validation_share = pass.float { 0, min = 0, max = 1, wired = true,
      doc = "fraction of the blocks of 4 x 2 pixels that take all samples although the first ones suffice, to validate the " ..
            "consensus" },
  },
}
