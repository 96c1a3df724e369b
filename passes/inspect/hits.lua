-- SPDX-License-Identifier: MIT
-- Every hit of one camera ray, for a pixel inspector.
local pass = require "strobe.pass"

return pass.trace {
  name   = "hits",
  shader = "inspect/hits",
  doc    = "The first 16 hits of the camera's ray through one pixel at the capture, nearest first, one per texel",
  fails  = "Of two surfaces in one place, within 4 representable numbers of depth, only one is listed.",
  size   = { 16, 1 },
  writes = {
    hit      = { format = "rgba32ui", doc = "instance + 1, geometry + 1, primitive, 1 if front is seen; 0: no more" },
    where    = { format = "rgba32f", doc = "linear view depth, metres; unit normal, world space, towards the camera" },
    velocity = { format = "rg32f", doc = "displacement over the exposure, px, x right, y down" },
    color    = { format = "rgba32f", doc = "linear radiance towards the camera; alpha 1 on a hit" },
  },
  params = {
    pixel_x = pass.int { 0, min = 0, max = 32767, unit = "px", doc = "column, from the left" },
    pixel_y = pass.int { 0, min = 0, max = 32767, unit = "px", doc = "row, from the top" },
  },
}
