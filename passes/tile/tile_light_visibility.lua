-- SPDX-License-Identifier: MIT
-- Conservative visibility of each light from a whole tile, which saves shadow rays. Haines and Wallace 1991,
-- "Shaft Culling for Efficient Ray-Cast Radiosity".
local pass  = require "strobe.pass"
local shade = require "passes.gbuffer.shade"

return pass.trace {
  doc    = "Visibility of each light from a tile: visible from all its surface points, blocked from all, or mixed",
  fails  = "The classes are conservative: shadow rays to a mixed light are traced per pixel, so the picture is never wrong. " ..
           "Only the runtime's own acceleration structure supports the test. With other ray tracing backends all lights are " ..
           "mixed, and no rays are saved.",
  size   = { of = "hit", divide = "shadow_tile" },
  reads  = { hit = { uint = true, doc = "visible surface, by indices: instance + 1 (0 for the sky), geometry, triangle" } },
  writes = { light_visibility = { format = "rg32ui",
    doc = "x: bit i is set if light i of the first 32 is visible from the whole tile; y: bit i is set if light i is " ..
          "blocked from the whole tile. If neither bit is set, the light's shadow rays are traced per pixel" } },
  if_no = { shadows = { light_visibility = 0 } },
  params = {
    shadow_tile = shade.params.shadow_tile,
    per_tile    = pass.bool { true, doc = "test all shadow rays of a tile at once; off: every shadow ray is traced" },
  },
  counters = {
    visible_lights = "lights visible from a whole tile, summed over tiles",
    blocked_lights = "lights blocked from a whole tile, summed over tiles",
  },
}
