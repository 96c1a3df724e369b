-- SPDX-License-Identifier: MIT
-- Static background behind the moving surfaces of the raster layer, for a static camera.
local pass  = require "strobe.pass"
local shade = require "passes.scene.shade"

return pass.trace {
  name   = "still_ground",
  shader = "scene/still_ground",
  doc    = "Static background behind each moving surface of the raster layer, for a static camera",
  fails  = "The static background is shaded as at the raster time, with the shadows of that time. A static surface in the " ..
           "same place as a moving surface behind the first one is not found.",
  size   = { of = "hit" },
  reads  = {
    hit = { uint = true, doc = "surface of the raster layer: instance + 1 (0 for the sky), geometry, primitive" },
  },
  writes = {
    ground = { format = "rgba32f", cleared = true,
      doc = "colour of the static background, linear radiance; alpha: linear view depth, metres, +inf without a surface; 0 " ..
            "where the raster layer is static" },
  },
  without = { motion = { ground = 0 }, reached = { ground = 0 } },
  counters = {
    rays       = "pixels of moving surfaces, each with a ray to the static background",
    not_finite = shade.counters.not_finite,
  },
}
