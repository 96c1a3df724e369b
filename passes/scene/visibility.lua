-- SPDX-License-Identifier: MIT
-- What each pixel sees: the raster pass of every pipeline. Everything else is derived from it.
local pass = require "strobe.pass"

return pass.raster {
  name   = "visibility",
  shader = "scene/visibility",
  doc    = "Nearest triangle at each sample position",
  writes = { hit = { format = "rgba32ui", doc = "instance + 1 (0 = sky), geometry, primitive, 0" } },
}
