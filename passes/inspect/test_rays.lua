-- SPDX-License-Identifier: MIT
-- Rays that nobody's camera has, to hold the tracing backends against each other.
local pass = require "strobe.pass"

return pass.trace {
  name   = "test_rays",
  shader = "inspect/test_rays",
  doc    = "A ray of its own for each pixel through the scene at the capture, easy ones and hard ones, and what it hits",
  writes = {
    origin    = { format = "rgba32f", doc = "where the ray starts, world axes, from the capture's camera, metres" },
    direction = { format = "rgba32f", doc = "of any length; alpha: the longest t" },
    hit       = { format = "rgba32ui", doc = "instance + 1, geometry, primitive, bits of t; 0: a miss" },
    color     = { format = "rgba32f", doc = "rgb: t of the hit, 0 of a miss" },
    blocked   = { format = "r32ui", doc = "1: something lies on the ray" },
  },
  params = {
    ray_kind = pass.choice { "all", "through", "vertex", "edge", "axis", "grazing", "afar", "surface", "plane",
      default = "all", doc = "which rays; all: each eighth row has one of them",
      values = {
        all = "All of the others, row by row.",
        through = "From one random point of the scene's box to another.",
        vertex = "From a random point to the corner of a triangle.",
        edge = "From a random point to the edge of a triangle.",
        axis = "Parallel to an axis, through a corner.",
        grazing = "From a point of a surface along an edge of it.",
        afar = "From ten thousand times as far as the scene is large to a surface.",
        surface = "From a surface to any side.",
        plane = "From a random point to a surface, with one coordinate of the direction 0.",
      },
    },
  },
}
