-- SPDX-License-Identifier: MIT
-- Next raster layer: the scene drawn once more, without the surfaces in front. Everitt 2001, depth peeling.
local pass = require "strobe.pass"

return pass.raster {
  doc    = "Nearest triangle behind the layer in front, at each pixel's sample position: one step of depth peeling",
  reads  = { front = { uint = true,
    doc = "surface of the layer in front, by indices: instance + 1 (0 for the sky), geometry, triangle" } },
  writes = { hit = { format = "rgba32ui",
    doc = "surface of the layer behind, by indices: instance + 1 (0 for the sky), geometry, triangle, 0" } },
  params = {
    sides = pass.choice { "front", "all", default = "front", doc = "sides of triangles that are drawn into the layer",
      values = {
        front = "Front faces only, as renderers draw them; a closed object then needs one or two layers fewer than with " ..
                "`all`. Fails for open surfaces seen from the back.",
        all = "Front and back faces, as all other passes draw and hit them. Fails by spending layers on the far sides of " ..
              "objects in front.",
      } },
  },
  counters = { fragments = "fragments drawn to find the layer" },
  fails  = "Each layer costs more than drawing the scene once, because early depth tests reject no hidden fragments. Of two " ..
           "surfaces closer together than the depth buffer resolves, one may be missing in all layers.",
}
