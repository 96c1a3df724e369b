-- SPDX-License-Identifier: MIT
-- The geometry buffer, derived from what each pixel sees by the functions that rays use too.
local pass = require "strobe.pass"

return pass.compute {
  name   = "gbuffer",
  shader = "scene/gbuffer",
  doc    = "Depth, normal, ids and displacement of what each pixel sees",
  size   = { of = "hit" },
  scene  = true,
  reads  = { hit = { uint = true, doc = "instance + 1 (0 = sky), geometry, primitive" } },
  writes = {
    depth    = { format = "r32f", doc = "linear view depth, metres; sky = +inf" },
    normal   = { format = "rgba32f", doc = "unit, world space, towards the camera; sky = 0" },
    id       = { format = "rg32ui", doc = "instance + 1, geometry + 1; sky = 0" },
    velocity = { format = "rg32f", doc = "displacement over the exposure, px, x right, y down; never clamped" },
  },
}
