-- SPDX-License-Identifier: MIT
-- Moving pixels with an edge along their displacement. Tan, Cui and Bhojan 2020, Ray Mask.
local pass = require "strobe.pass"
local blur = require "passes.lib.blur"

return pass.compute {
  doc    = "Moving pixels with an edge along their displacement",
  fails  = "Uses the pixel's own motion, although disocclusion depends on the motion relative to the background. Marks too " ..
           "few pixels if the background moves against them, none if a static foreground is in front of a moving " ..
           "background, and too many if both move together. Steps longer than the width of an edge miss the edge.",
  size   = { of = "edge" },
  reads  = {
    edge     = { doc = "edge mask, above 1/2 on an edge" },
    id       = { uint = true, doc = "instance + 1; 0 for the sky" },
    velocity = { doc = "displacement of the surface, px over the exposure" },
  },
  writes = { mask = { format = "r8_unorm", doc = "mask of the ray reveal, 1 where a ray is traced" } },
  if_no = { edge = { mask = 0 } },
  params = {
    min_displacement = pass.float { 0.5, min = 0, max = 1000, unit = "px",
      doc = "smallest displacement of a moving pixel; slower pixels count as static" },
    limit            = blur.limit,
    taps             = pass.int { 0, min = 0, max = 1024, doc = "number of steps along the displacement; 0: one per pixel" },
    own_edge         = pass.bool { true,
      doc = "require that the first edge along the displacement belongs to the pixel's own instance" },
  },
}
