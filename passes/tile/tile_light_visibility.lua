-- SPDX-License-Identifier: MIT
-- Conservative visibility of each light from a whole tile, so that its shadow rays need no tracing. Haines and Wallace 1991,
-- "Shaft Culling for Efficient Ray-Cast Radiosity".
local pass  = require "strobe.pass"
local shade = require "passes.gbuffer.shade"

return pass.trace {
  doc    = "Visibility of each light from all points of a tile: visible, blocked or mixed",
  fails  = "Conservative: mixed lights are traced per pixel. Only the runtime's own tree supports the test; with other " ..
           "backends all lights are mixed.",
  size   = { of = "hit", divide = "shadow_tile" },
  reads  = { hit = { uint = true, doc = "visible surface: instance + 1 (0 for the sky), geometry, primitive" } },
  writes = { light_visibility = { format = "rg32ui",
    doc = "bits of the first 32 lights; x: visible from the whole tile, y: blocked from the whole tile; neither: mixed, " ..
          "traced per pixel" } },
  if_no = { shadows = { light_visibility = 0 } },
  params = {
    shadow_tile = shade.params.shadow_tile,
    per_tile    = pass.bool { true, doc = "test all shadow rays of a tile at once; off: every ray is traced" },
  },
  counters = {
    visible_lights = "lights visible from a whole tile, summed over tiles",
    blocked_lights = "lights blocked from a whole tile, summed over tiles",
  },
}
