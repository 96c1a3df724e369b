-- SPDX-License-Identifier: MIT
-- Which shadow rays of what the pixels see need not be traced, for all of a tile at once. Haines and Wallace 1991, "Shaft
-- Culling for Efficient Ray-Cast Radiosity".
local pass  = require "strobe.pass"
local shade = require "passes.scene.shade"

return pass.trace {
  name   = "shadow_shafts",
  shader = "tile/shadow_shafts",
  doc    = "Per tile, lights to which surely no shadow ray is stopped, and lights to which surely each is",
  fails  = "Never: what is not sure is traced. Only the runtime's own tree can be asked; by other backends nothing is sure.",
  size   = { of = "hit", divide = "shadow_tile" },
  reads  = { hit = { uint = true, doc = "instance + 1 (0 = sky), geometry, primitive" } },
  writes = { sure = { format = "rg32ui", doc = "bits of the first 32 lights: of those no ray to which is stopped, and of " ..
    "those all rays to which are. Others are traced" } },
  without = { shadows = { sure = 0 } },
  params = {
    shadow_tile = shade.params.shadow_tile,
    shafts      = pass.bool { true, doc = "ask for all rays of a tile at once; without, each is traced" },
  },
  counters = {
    free_shafts    = "lights that surely reach all of a tile, summed over tiles",
    stopped_shafts = "lights that surely reach nothing of a tile, summed over tiles",
  },
}
