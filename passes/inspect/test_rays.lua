-- SPDX-License-Identifier: MIT
-- Random rays that compare the tracing backends with each other.
local pass = require "strobe.pass"

return pass.trace {
  doc    = "Hit of one random ray per pixel through the scene at the raster time, for the comparison of ray tracing " ..
           "backends; many of these rays are difficult, because rounding decides which triangle they hit",
  writes = {
    origin    = { format = "rgba32f", doc = "origin of the ray relative to the camera at the raster time, world axes, metres" },
    direction = { format = "rgba32f", doc = "direction of the ray, of any length; alpha: largest ray parameter t" },
    hit       = { format = "rgba32ui",
      doc = "hit surface, by indices: instance + 1, geometry, triangle; then the ray parameter t as the bits of a float; 0 " ..
            "for a miss" },
    color     = { format = "rgba32f", doc = "rgb: ray parameter t of the hit, for display; 0 for a miss" },
    blocked   = { format = "r32ui", doc = "1 if any surface lies on the ray, otherwise 0" },
  },
  params = {
    ray_kind = pass.choice { "all", "through", "vertex", "edge", "axis", "grazing", "afar", "surface", "plane",
      default = "all", doc = "kind of the rays",
      values = {
        all = "All eight other kinds, one per row of pixels in turn.",
        through = "From one random point of the scene to another.",
        vertex = "From a random point to the vertex of a triangle.",
        edge = "From a random point to the edge of a triangle.",
        axis = "Parallel to an axis, through a vertex.",
        grazing = "From a point of a triangle, in the direction of an edge of this triangle.",
        afar = "From a point at a distance of 10,000 times the size of the scene, to a surface.",
        surface = "From a surface in a random direction.",
        plane = "From a random point to a surface; one component of the direction is 0.",
      },
    },
  },
}
