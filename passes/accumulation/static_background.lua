-- SPDX-License-Identifier: MIT
-- Static background behind the moving surfaces of the raster layer, for a static camera.
local pass  = require "strobe.pass"
local shade = require "passes.gbuffer.shade"

return pass.trace {
  doc    = "Static background behind each moving surface of the raster layer, for a static camera",
  fails  = "The static background is shaded as at the raster time, with the shadows of that time. If several " ..
           "moving surfaces are one behind another, a static surface at the same depth as the second or a later one is not " ..
           "found.",
  size   = { of = "hit" },
  reads  = {
    hit = { uint = true, doc = "surface of the raster layer, by indices: instance + 1 (0 for the sky), geometry, triangle" },
  },
  writes = {
    static_background = { format = "rgba32f", cleared = true,
      doc = "colour of the static background, linear radiance. Alpha: linear view depth, metres; +inf for the sky, 0 " ..
            "where the raster layer is static" },
  },
  if_no = { motion = { static_background = 0 }, moving_rect = { static_background = 0 } },
  counters = {
    rays       = "pixels that show a moving surface at the raster time; rays search the static background there",
    not_finite = shade.counters.not_finite,
  },
}
