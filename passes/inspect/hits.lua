-- SPDX-License-Identifier: MIT
-- Hits of one camera ray, for a pixel inspector.
local pass = require "strobe.pass"

return pass.trace {
  doc    = "First 16 hits of the camera ray through one pixel at the raster time, nearest first, one per texel",
  fails  = "Lists only one of two surfaces whose depths differ by at most 4 units in the last place.",
  size   = { 16, 1 },
  writes = {
    hit      = { format = "rgba32ui", doc = "hit surface: instance index + 1, geometry index + 1, triangle index, 1 for a " ..
                                            "front face; 0 after the last hit" },
    where    = { format = "rgba32f", doc = "x: linear view depth, metres; yzw: unit normal towards the camera, world space" },
    velocity = { format = "rg32f", doc = "screen displacement of the hit surface, x right, y down, px over the exposure" },
    color    = { format = "rgba32f", doc = "colour of the hit, linear radiance; alpha 1 for a hit, otherwise 0" },
  },
  params = {
    pixel_x = pass.int { 0, min = 0, max = 32767, unit = "px", doc = "column of the pixel, counted from the left" },
    pixel_y = pass.int { 0, min = 0, max = 32767, unit = "px", doc = "row of the pixel, counted from the top" },
  },
}
