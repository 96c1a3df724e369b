-- SPDX-License-Identifier: MIT
-- Two displacements that represent each tile; first step of the disocclusion mask.
local pass = require "strobe.pass"
local blur = require "passes.lib.blur"

return pass.compute {
  doc    = "Two displacements that represent each tile: the longest one, and the displacement that differs most from the " ..
           "longest one",
  fails  = "If a tile has three different motions, the third one is lost.",
  size   = { of = "velocity", divide = "tile" },
  group  = true,
  reads  = {
    velocity = { doc = "screen displacement of the surface, px over the exposure" },
    depth    = { doc = "linear view depth, metres; +inf for the sky" },
  },
  writes = {
    velocities = { format = "rgba32f",
      doc = "xy: longest displacement; zw: displacement that differs most from the longest one, px over the exposure" },
    farthest   = { format = "r32f", doc = "linear view depth of the farthest moving surface in each tile, metres; 0 for none" },
    max_displacement = { format = "buffer32ui",
      doc = "entry 0: length of the longest displacement of the image, px over the exposure, as the bits of a float" },
  },
  if_no = {
    motion      = { velocities = 0, farthest = 0, max_displacement = 0 },
    moving_rect = { velocities = 0, farthest = 0, max_displacement = 0 },
  },
  params = {
    tile  = blur.tile,
    limit = blur.limit,
  },
}
