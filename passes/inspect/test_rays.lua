-- SPDX-License-Identifier: MIT
-- Random rays that compare the tracing backends with each other.
local pass = require "strobe.pass"

return pass.trace {
  doc    = "Hits of one random ray per pixel through the scene at the raster time, with rays that are hard to trace exactly",
  writes = {
    origin    = { format = "rgba32f", doc = "origin of the ray relative to the camera at the raster time, world axes, metres" },
    direction = { format = "rgba32f", doc = "direction of the ray, of any length; alpha: largest t" },
    hit       = { format = "rgba32ui", doc = "instance + 1, geometry, primitive, bits of t; 0 for a miss" },
    color     = { format = "rgba32f", doc = "rgb: t of the hit; 0 for a miss" },
    blocked   = { format = "r32ui", doc = "1 if any surface lies on the ray" },
  },
  params = {
    ray_kind = pass.choice { "all", "through", "vertex", "edge", "axis", "grazing", "afar", "surface", "plane",
      default = "all", doc = "kind of the rays",
      values = {
        all = "The other eight kinds, one per row in turn.",
        through = "From one random point of the scene to another.",
        vertex = "From a random point to the vertex of a triangle.",
        edge = "From a random point to the edge of a triangle.",
        axis = "Parallel to an axis, through a vertex.",
        grazing = "From a point of a triangle parallel to one of its edges.",
        afar = "From a point 10,000 times as far away as the scene is large to a surface.",
        surface = "From a surface in a random direction.",
        plane = "From a random point to a surface, with one component of the direction 0.",
      },
    },
  },
}
