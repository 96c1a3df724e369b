-- SPDX-License-Identifier: MIT
-- Range check of the ray mask: moving pixels with an edge along their displacement. Tan, Cui and Bhojan 2020, section
-- "Ray Mask".
local pass = require "strobe.pass"
local blur = require "passes.lib.blur"

return pass.compute {
  doc    = "Mask for the pass `ray_reveal`: moving pixels with an edge along their displacement, where the background may " ..
           "be disoccluded",
  fails  = "Uses the pixel's own motion, although disocclusion depends on the pixel's motion relative to the " ..
           "background. Marks too few pixels if the background moves in the opposite direction, and too many if " ..
           "both move together. Marks no pixels if a static foreground is in front of a moving background. Steps " ..
           "that are longer than the width of an edge miss the edge.",
  size   = { of = "edge" },
  reads  = {
    edge     = { doc = "edge mask, above 1/2 on an edge" },
    id       = { uint = true, doc = "instance index + 1; 0 for the sky" },
    velocity = { doc = "screen displacement of the surface, px over the exposure" },
  },
  writes = { mask = { format = "r8_unorm", doc = "mask for the pass `ray_reveal`: 1 where a ray to the background is " ..
      "traced, otherwise 0" } },
  if_no = { edge = { mask = 0 } },
  params = {
    min_displacement = pass.float { 0.5, min = 0, max = 1000, unit = "px",
      doc = "smallest displacement of a moving pixel; slower pixels count as static" },
    limit            = blur.limit,
    taps             = pass.int { 0, min = 0, max = 1024, doc = "number of steps along the displacement; 0: one step per " ..
        "pixel" },
    own_edge         = pass.bool { true,
      doc = "require that the first edge along the displacement belongs to the pixel's own instance" },
  },
}
