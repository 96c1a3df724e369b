-- SPDX-License-Identifier: MIT
-- What lies behind what each pixel sees: the scene drawn once more, without what is in front.
local pass = require "strobe.pass"

return pass.raster {
  name   = "peel",
  shader = "scene/peel",
  doc    = "Nearest triangle behind that of the layer in front at each sample position: one step of depth peeling",
  reads  = { front = { uint = true, doc = "of the layer in front: instance + 1 (0 = sky), geometry, primitive" } },
  writes = { hit = { format = "rgba32ui", doc = "of the layer behind: instance + 1 (0 = sky), geometry, primitive, 0" } },
  params = {
    sides = pass.choice { "front", "all", default = "front", doc = "which sides of surfaces are layers",
      values = {
        front = "Those that their triangles turn to the camera, as renderers draw them: a closed object is a layer or two "
          .. "less. Fails behind what is open and seen from its back.",
        all = "Both, as everything else draws and hits them. Fails by spending layers on the far side of what is in front.",
      } },
  },
  counters = { fragments = "fragments that were drawn to find it" },
  fails  = "A layer costs as much as drawing the scene anew, and more: nothing hidden is passed over early. Surfaces as close "
    .. "together as a depth buffer's numbers may be in no layer.",
}
