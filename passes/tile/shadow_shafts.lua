-- SPDX-License-Identifier: MIT
-- Conservative visibility of each light from a whole tile, so that its shadow rays need no tracing. Haines and Wallace 1991,
-- "Shaft Culling for Efficient Ray-Cast Radiosity".
local pass  = require "strobe.pass"
local shade = require "passes.scene.shade"

return pass.trace {
  name   = "shadow_shafts",
  shader = "tile/shadow_shafts",
  doc    = "Visibility of each light from all points of a tile: visible, blocked or mixed",
  fails  = "Conservative: mixed lights are traced per pixel. Only the runtime's own tree supports the test; with other " ..
           "backends all lights are mixed.",
  size   = { of = "hit", divide = "shadow_tile" },
  reads  = { hit = { uint = true, doc = "visible surface: instance + 1 (0 for the sky), geometry, primitive" } },
  writes = { sure = { format = "rg32ui",
    doc = "bits of the first 32 lights; x: visible from the whole tile, y: blocked from the whole tile; neither: mixed, " ..
          "traced per pixel" } },
  without = { shadows = { sure = 0 } },
  params = {
    shadow_tile = shade.params.shadow_tile,
    shafts      = pass.bool { true, doc = "test all shadow rays of a tile at once; off: every ray is traced" },
  },
  counters = {
    free_shafts    = "lights visible from a whole tile, summed over tiles",
    stopped_shafts = "lights blocked from a whole tile, summed over tiles",
  },
}
